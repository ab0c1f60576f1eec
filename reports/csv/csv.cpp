#include "reports/csv/csv.hpp"

#include "reports/csv/csv_records.hpp"
#include "reports/json/json_records.hpp"
#include "reports/text/labels.hpp"
#include "reports/text/numbers.hpp"

#include <fmt/format.h>

#include <iterator>
#include <string>

namespace ff::reports {
namespace {

std::string nodes_field(const studies::Method& method) {
    if (!method.nodes) return {};
    const auto [source, target] = *method.nodes;
    return target == 0 || source == target ? fmt::format("{}", source) : fmt::format("{}x{}", source, target);
}

}  // namespace

void write_summary_csv(std::ostream& out, const studies::Analysis& findings) {
    CsvRecords csv(out,
                   "study,scene,method,sampler,estimator,completion,nodes,allocation,patches_per_face,"
                   "samples_per_patch,trials,from_face,to_face,pair_class,reference,mean,bias,bias_se,"
                   "bias_ci_low=bias_interval/low,bias_ci_high=bias_interval/high,interval_method=mean_interval/method,"
                   "level,minimum_detectable_bias,std,std_ci_low=std_interval/low,std_ci_high=std_interval/high,rmse,"
                   "median_abs_error,relative_error_percent,skewness,excess_kurtosis,min=quantiles/min,"
                   "q05=quantiles/q05,median=quantiles/median,q95=quantiles/q95,max=quantiles/max,normality_p,vov,"
                   "tail_index,efficiency_samples,lost_rays,std_interval_method=std_interval/method,"
                   "mean_ci_low=mean_interval/low,mean_ci_high=mean_interval/high");
    const studies::StudyPlan& plan = findings.plan;
    for (const studies::CellAnalysis& found : findings.cells) {
        const studies::Cell& cell = plan.cells[found.cell];
        Json record = in_cell(plan, found.cell, cell_json(plan, found));
        record["nodes"] = nodes_field(plan.spec.methods[cell.method]);
        for (const studies::Summary& summary : found.summaries) {
            record.update(summary_json(plan.scenes[cell.scene], summary));
            record["mean_interval"] = interval_json(summary.mean_interval);
            record["level"] = summary.mean_interval || summary.std_interval ? Json(plan.spec.level) : Json(nullptr);
            csv.add(record);
        }
    }
}

void write_trials_csv(std::ostream& out, const studies::Store& store) {
    out << "study,scene,method,patches_per_face,samples_per_patch,trial,from_face,to_face,estimate\n";
    const studies::StudyPlan& plan = store.plan();
    for (std::size_t index = 0; index < plan.cells.size(); ++index) {
        const studies::Cell& cell = plan.cells[index];
        const Scene& scene = plan.scenes[cell.scene];
        const auto estimates = studies::load_estimates(store, index, studies::Completion::direct);
        const std::string samples =
            cell.samples_per_patch == 0 ? std::string() : std::to_string(cell.samples_per_patch);
        const std::string prefix =
            fmt::format("{},{},{},{},{}", csv_field(plan.spec.name), csv_field(plan.scenes.name(cell.scene)),
                        csv_field(plan.spec.methods[cell.method].name), cell.subdivision.per_part(), samples);
        for (const studies::Quantity pair : studies::distinct_pairs(estimates.faces, studies::Completion::direct)) {
            const std::string faces =
                fmt::format("{},{}", csv_field(from_label(scene, pair)), csv_field(to_label(scene, pair)));
            const auto& values = estimates.values(pair);
            fmt::memory_buffer rows;
            for (std::size_t i = 0; i < values.size(); ++i) {
                fmt::format_to(std::back_inserter(rows), "{},{},{},{}\n", prefix, estimates.trial_numbers[i], faces,
                               exact(values[i]));
            }
            out.write(rows.data(), static_cast<std::streamsize>(rows.size()));
        }
    }
}

void write_slopes_csv(std::ostream& out, const studies::StudyResults& results) {
    CsvRecords csv(out,
                   "study,scene,method,pair_class,from_face,to_face,statistic,slope,slope_ci_low=interval/low,"
                   "slope_ci_high=interval/high,expected=expected/rate,lack_of_fit_p,points");
    const studies::StudyPlan& plan = results.findings.plan;
    for (const studies::LadderSlopes& ladder : results.slopes) {
        const Scene& scene = plan.scenes[ladder.ladder.scene];
        const auto write = [&](const studies::Slope& slope) {
            Json record{{"study", plan.spec.name},
                        {"scene", plan.scenes.name(ladder.ladder.scene)},
                        {"method", ladder.ladder.label}};
            record.update(slope_json(scene, slope));
            csv.add(record);
        };
        for (const studies::ClassSlopes& found : ladder.classes) {
            write(found.rmse);
            write(found.median);
        }
        for (const studies::Slope& slope : ladder.pairs) write(slope);
    }
}

void write_comparisons_csv(std::ostream& out, const studies::StudyResults& results, Timed timed) {
    CsvRecords csv(out,
                   "study,scene,pair_class,equal,budget,better=better/method,"
                   "better_patches_per_face=better/patches_per_face,better_samples_per_patch=better/samples_per_patch,"
                   "better_repeats=better/repeats,better_group=better/group,worse=worse/method,"
                   "worse_patches_per_face=worse/patches_per_face,worse_samples_per_patch=worse/samples_per_patch,"
                   "worse_repeats=worse/repeats,worse_group=worse/group,ratio,ratio_ci_low=interval/low,"
                   "ratio_ci_high=interval/high,level,apart,times_trials");
    const studies::StudySpec& spec = results.findings.plan.spec;
    for (Json& contest : contests_json(results, timed)) {
        const Json ratios = std::move(contest["ratios"]);
        const Json entrants = std::move(contest["entrants"]);
        contest.update({{"study", spec.name}, {"level", spec.level}});
        for (Json ratio : ratios) {
            for (const char* side : {"better", "worse"}) ratio[side] = entrants[ratio[side].get<std::size_t>()];
            ratio.update(contest);
            csv.add(ratio);
        }
    }
}

void write_claimed_errors_csv(std::ostream& out, const studies::StudyResults& results) {
    CsvRecords csv(out,
                   "study,scene,method,patches_per_face,samples_per_patch,pair_class,claimant,promised,claims,held,"
                   "worst_from,worst_to,worst_held,worst_share_ci_low=worst_share_interval/low,"
                   "worst_share_ci_high=worst_share_interval/high,median_ratio,largest_ratio,finding");
    const studies::StudyPlan& plan = results.findings.plan;
    const Json rows = claimed_errors_json(results);
    for (std::size_t i = 0; i < rows.size(); ++i) {
        const studies::ClaimedErrors& row = results.claimed_errors[i];
        const Scene& scene = plan.scenes[plan.cells[row.cell].scene];
        Json record = in_cell(plan, row.cell, rows[i]);
        record["worst_from"] = from_label(scene, row.worst_pair);
        record["worst_to"] = to_label(scene, row.worst_pair);
        csv.add(record);
    }
}

void write_coverage_csv(std::ostream& out, const studies::StudyResults& results) {
    CsvRecords csv(out,
                   "study,scene,method,patches_per_face,samples_per_patch,pair_class,interval_method,replicates,"
                   "mean_trials,intervals,covered,coverage,coverage_ci_low=coverage_interval/low,"
                   "coverage_ci_high=coverage_interval/high,level,short_of_nominal");
    const Json rows = coverage_json(results);
    const studies::StudyPlan& plan = results.findings.plan;
    for (std::size_t i = 0; i < rows.size(); ++i) csv.add(in_cell(plan, results.coverage[i].cell, rows[i]));
}

}  // namespace ff::reports
