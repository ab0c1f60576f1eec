#include "reports/csv/csv.hpp"

#include "reports/csv/csv_field.hpp"
#include "reports/csv/csv_records.hpp"
#include "reports/json/json_cells.hpp"
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
            fmt::format("{},{},{},{},{}", csv_field(plan.spec.name), csv_field(scene.name),
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

}  // namespace ff::reports
