#include "reports/csv/csv.hpp"

#include "reports/csv/csv_field.hpp"
#include "reports/text/labels.hpp"
#include "reports/text/numbers.hpp"

#include <fmt/format.h>

#include <iterator>
#include <string>
#include <vector>

namespace ff::reports {
namespace {

std::string nodes_field(const studies::Method& method) {
    if (!method.nodes) return {};
    const auto [source, target] = *method.nodes;
    return target == 0 || source == target ? fmt::format("{}", source) : fmt::format("{}x{}", source, target);
}

constexpr std::string_view summary_header =
    "study,scene,method,sampler,estimator,completion,nodes,allocation,patches_per_face,samples_per_patch,trials,from_"
    "face,to_face,"
    "pair_class,reference,mean,bias,bias_se,bias_ci_low,bias_ci_high,interval_method,level,minimum_detectable_bias,std,"
    "std_ci_low,"
    "std_ci_high,rmse,median_abs_error,relative_error_percent,skewness,excess_kurtosis,min,q05,median,q95,max,"
    "normality_p,vov,"
    "tail_index,efficiency_samples,lost_rays,std_interval_method,mean_ci_low,mean_ci_high\n";

/// Columns that are the same for all rows of a cell: study .. trials.
std::string cell_fields(const studies::StudyPlan& plan, const studies::CellFindings& found) {
    const studies::Cell& cell = plan.cells[found.cell];
    const studies::Method& method = plan.spec.methods[cell.method];
    const std::string samples = cell.samples == 0 ? std::string() : std::to_string(cell.samples);
    return fmt::format("{},{},{},{},{},{},{},{},{},{},{}", csv_field(plan.spec.name),
                       csv_field(plan.scenes[cell.scene].name), csv_field(method.name), csv_field(method.sampler),
                       method.estimator, name(method.completion), nodes_field(method),
                       estimator_info(method).has_allocation() ? studies::name(method.allocation) : "",
                       cell.subdivision.per_part(), samples, found.trials);
}

std::string low(const std::optional<stats::Interval>& interval) {
    return interval ? exact(interval->low) : std::string();
}
std::string high(const std::optional<stats::Interval>& interval) {
    return interval ? exact(interval->high) : std::string();
}

std::string summary_fields(const Scene& scene, const studies::Summary& s, const studies::CellFindings& found,
                           double level) {
    const std::vector<std::string> fields{csv_field(from_label(scene, s.quantity)),
                                          csv_field(to_label(scene, s.quantity)),
                                          s.pair_class ? std::string(name(*s.pair_class)) : std::string(),
                                          exact(s.reference),
                                          exact(s.mean),
                                          exact(s.bias),
                                          exact(s.bias_se),
                                          low(s.bias_interval),
                                          high(s.bias_interval),
                                          s.mean_interval ? std::string(s.mean_interval->method) : std::string(),
                                          s.mean_interval || s.std_interval ? exact(level) : std::string(),
                                          exact(s.minimum_detectable_bias),
                                          exact(s.std),
                                          low(s.std_interval),
                                          high(s.std_interval),
                                          exact(s.rmse),
                                          exact(s.median_abs_error),
                                          exact(s.relative_error_percent),
                                          exact(s.skewness),
                                          exact(s.excess_kurtosis),
                                          exact(s.min),
                                          exact(s.q05),
                                          exact(s.median),
                                          exact(s.q95),
                                          exact(s.max),
                                          exact(s.normality_p),
                                          exact(s.vov),
                                          exact(s.tail_index),
                                          exact(s.efficiency_samples),
                                          std::to_string(found.lost_rays),
                                          s.std_interval ? std::string(s.std_interval->method) : std::string(),
                                          low(s.mean_interval),
                                          high(s.mean_interval)};
    return fmt::format("{}", fmt::join(fields, ","));
}

}  // namespace

void write_summary_csv(std::ostream& out, const studies::Findings& findings) {
    out << summary_header;
    for (const studies::CellFindings& found : findings.cells) {
        const Scene& scene = findings.plan.scenes[findings.plan.cells[found.cell].scene];
        const std::string prefix = cell_fields(findings.plan, found);
        for (const studies::Summary& summary : found.summaries) {
            out << prefix << ',' << summary_fields(scene, summary, found, findings.plan.spec.level) << '\n';
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
        const std::string samples = cell.samples == 0 ? std::string() : std::to_string(cell.samples);
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
