#include "reports/tables/tables.hpp"
#include "reports/text/labels.hpp"
#include "reports/text/numbers.hpp"
#include "reports/words/findings/occlusion_words.hpp"
#include "reports/words/findings/slope_words.hpp"

#include <fmt/format.h>

namespace ff::reports {
namespace {

std::string error_text(const studies::PairError& found) {
    const double error = found.size();
    if (error < studies::rounding_error) return "exact";
    const bool median = found.error.status == studies::VarianceStatus::infinite;
    return fmt::format("{:.1e}{}", error, median ? " (median)" : "");
}

TableCell cell_of(const studies::HiddenPair& scene, std::size_t method) {
    const auto& found = scene.methods[method];
    if (!found) return {"–"};
    const bool best = scene.decided && scene.least == method;
    const std::string slope = found->slope ? fmt::format(", {}", slope_text(*found->slope)) : "";
    return {error_text(*found) + slope, best ? Mark::good : Mark::none};
}

}  // namespace

Table occlusion_table(const studies::StudyResults& results) {
    const studies::StudyPlan& plan = results.findings.plan;
    Table table{
        "occlusion",
        "Errors as the occluded fraction grows",
        fmt::format(
            "RMSE of a run on one pair of faces, at the size next to the common number of evaluations, and the "
            "slope of ln(error) on ln(N) along all sizes (± half of its {:g} % interval); of methods without "
            "a variance the median error. Occluded: the fraction of the unoccluded form factor that does not arrive. "
            "Marked: shown to err less than every method of the other kind (sampled, deterministic), {:g} % "
            "over all rows together. An evaluation is a ray, which serves all faces, or a value of the "
            "kernel, which serves one pair.",
            100 * plan.spec.level, 100 * (1 - plan.spec.level)),
        {{"scene", false, ""}, {"pair", false, ""}, {"occluded", true, ""}, {"exact", true, ""}, {"N", true, ""}},
        {},
        {}};
    if (results.occlusion.empty()) return table;
    for (const studies::Method& method : plan.spec.methods) table.columns.push_back({method.name, false, ""});
    for (const studies::OcclusionSeries& series : results.occlusion) {
        for (const studies::HiddenPair& scene : series.scenes) {
            auto& row = table.rows.emplace_back();
            row.push_back({plan.scenes[scene.scene].name});
            row.push_back({quantity_label(plan.scenes[scene.scene], series.pair)});
            row.push_back({fmt::format("{:.4f}", scene.hidden)});
            row.push_back({fmt::format("{:.9f}", scene.exact)});
            row.push_back({std::to_string(series.evaluations)});
            for (std::size_t method = 0; method < scene.methods.size(); ++method) row.push_back(cell_of(scene, method));
        }
        table.remarks.push_back(series_in_words(results, series));
    }
    return table;
}

}  // namespace ff::reports
