#include "reports/tables/tables.hpp"
#include "reports/text/labels.hpp"
#include "reports/text/numbers.hpp"
#include "reports/words/findings/occlusion_words.hpp"
#include "reports/words/findings/verdicts.hpp"
#include "studies/analysis/configuration_estimates.hpp"

#include <fmt/format.h>

#include <string_view>

namespace ff::reports {
namespace {

std::string_view why_no_interval(studies::VarianceStatus variance) {
    switch (variance) {
        case studies::VarianceStatus::infinite:
            return "infinite variance";
        case studies::VarianceStatus::sparse:
            return "too few hits";
        case studies::VarianceStatus::undefined:
            return "infinity or no number in some trials";
        case studies::VarianceStatus::finite:
            return "too few trials to rule out skewness";
        case studies::VarianceStatus::none:
            break;
    }
    return "no spread";
}

/// The bias test covers all pairs of a scene: a pair that could not be tested does not count as agreeing because others
/// do.
TableCell verdict(const Scene& scene, const studies::ConfigurationEstimate& row) {
    const studies::CellAnalysis& found = *row.found;
    if (!found.bias) return {"deterministic", Mark::open};
    if (found.bias_finding == studies::BiasFinding::biased) {
        const bool has_place = found.bias->pairs > 1 && found.bias->largest_t > 0;
        const auto place = has_place ? fmt::format(", on {}", quantity_label(scene, found.bias->largest_pair)) : "";
        return {bias_in_words(found) + place, Mark::bad};
    }
    if (found.bias_finding != studies::BiasFinding::no_bias_found) return {bias_in_words(found), Mark::open};
    if (!row.interval) return {fmt::format("no interval: {}", why_no_interval(row.variance)), Mark::open};
    return {"agrees", Mark::good};
}

std::string interval_of(const studies::ConfigurationEstimate& estimate) {
    if (!estimate.interval) return "–";
    return fmt::format("[{}, {}]", to_error(estimate.interval->low, estimate.error),
                       to_error(estimate.interval->high, estimate.error));
}

std::string error_text(const studies::PairError& found) {
    const double error = found.size();
    if (error < studies::rounding_error) return "exact";
    const bool median = found.error.status == studies::VarianceStatus::infinite;
    return fmt::format("{:.1e}{}", error, median ? "*" : "");
}

TableCell cell_of(const studies::HiddenPair& scene, std::size_t method) {
    const auto& found = scene.methods[method];
    if (!found) return {"–"};
    const bool best = scene.decided && scene.least == method;
    const std::string slope = found->slope ? fmt::format(", {}", slope_text(*found->slope)) : "";
    return {error_text(*found) + slope, best ? Mark::good : Mark::none};
}

}  // namespace

Table configurations_table(const studies::StudyResults& results) {
    const studies::StudyPlan& plan = results.findings.plan;
    Table table{
        "configurations", "Against the exact values of the catalogue",
        fmt::format("Mean over trials, its {:g} % interval on its own, and how many of its standard errors it is off "
                    "(of a deterministic method: the error). The verdict is that of the bias test, {:g} % over "
                    "the whole study. A surface that sees itself is estimated by what it sends to another.",
                    100 * plan.spec.level, 100 * (1 - plan.spec.level)),
        columns({"configuration", "method and size", ">estimate", "interval", ">exact", ">off by", "verdict"})};
    if (!results.occlusion.empty()) return table;  // occlusion has a table of its own
    for (const studies::ConfigurationEstimate& row : studies::configuration_estimates(results.findings)) {
        const studies::Cell& cell = plan.cells[row.found->cell];
        table.rows.push_back(
            {{std::string(row.configuration->name)},
             {fmt::format("{}, {}", plan.spec.methods[cell.method].name, size_label(plan, cell))},
             {to_error(row.mean, row.error)},
             {interval_of(row)},
             {fmt::format("{:.12f}", row.exact)},
             {row.standard_errors ? fmt::format("{:+.2f} SE", *row.standard_errors) : fmt::format("{:+.1e}", row.bias)},
             verdict(plan.scenes[cell.scene], row)});
    }
    return table;
}

Table occlusion_table(const studies::StudyResults& results) {
    const studies::StudyPlan& plan = results.findings.plan;
    Table table{
        "occlusion", "Errors as the occluded fraction grows (*: the median, where the variance is infinite)",
        fmt::format("RMSE of a run on one pair of faces, at the size next to the common number of evaluations, and the "
                    "slope of ln(error) on ln(N) along all sizes (± half of its {:g} % interval); where the variance "
                    "is infinite, that of the median error. Occluded: the fraction of the unoccluded form factor that "
                    "does not arrive. "
                    "Green: shown to err less than every method of the other kind (sampled, deterministic), {:g} % "
                    "over all rows together. An evaluation is a ray, which serves all faces, or a value of the "
                    "kernel, which serves one pair.",
                    100 * plan.spec.level, 100 * (1 - plan.spec.level)),
        columns({"scene", "~pair", ">occluded"})};
    if (results.occlusion.empty()) return table;
    for (const studies::Method& method : plan.spec.methods) table.columns.push_back({method.name});
    for (const studies::OcclusionSeries& series : results.occlusion) {
        for (const studies::HiddenPair& scene : series.scenes) {
            auto& row = table.rows.emplace_back();
            row.push_back(plan.scenes.name(scene.scene));
            row.push_back(quantity_label(plan.scenes[scene.scene], series.pair));
            row.push_back(fmt::format("{:.3f}", scene.hidden));
            for (std::size_t method = 0; method < scene.methods.size(); ++method) row.push_back(cell_of(scene, method));
        }
        table.remarks.push_back(series_in_words(results, series));
    }
    return table;
}

}  // namespace ff::reports
