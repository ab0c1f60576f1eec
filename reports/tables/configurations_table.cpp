#include "reports/tables/tables.hpp"
#include "reports/text/labels.hpp"
#include "reports/text/numbers.hpp"
#include "reports/words/findings/occlusion_words.hpp"
#include "reports/words/findings/verdicts.hpp"
#include "studies/analysis/configuration_estimates.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

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

std::string off_by(const studies::ConfigurationEstimate& row) {
    return row.standard_errors ? fmt::format("{:+.2f} SE", *row.standard_errors) : fmt::format("{:+.1e}", row.bias);
}

double how_far(const studies::ConfigurationEstimate& row) {
    return std::abs(row.standard_errors.value_or(row.bias));
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
        columns({"configuration", "method and size", ">~estimate", "~interval", ">~exact", ">off by", "~verdict"})};
    if (!results.occlusion.empty()) return table;  // occlusion has a table of its own
    for (const studies::ConfigurationEstimate& row : studies::configuration_estimates(results.findings)) {
        const studies::Cell& cell = plan.cells[row.found->cell];
        const TableCell judged = verdict(plan.scenes[cell.scene], row);
        table.rows.push_back({{std::string(row.configuration->name)},
                              {fmt::format("{}, {}", plan.spec.methods[cell.method].name, size_label(plan, cell))},
                              {to_error(row.mean, row.error)},
                              {interval_of(row)},
                              {fmt::format("{:.12f}", row.exact)},
                              {off_by(row), judged.mark == Mark::bad ? Mark::bad : Mark::none},
                              judged});
    }
    return table;
}

Table agreement_table(const studies::StudyResults& results) {
    const studies::StudyPlan& plan = results.findings.plan;
    Table table{"agreement", "Agreement of each method with the exact values of the catalogue",
                fmt::format("Estimates in all configurations and sizes, judged by the bias test ({:g} % over the whole "
                            "study), and the one furthest off: in its standard errors, or the error of a deterministic "
                            "method, which is not tested.",
                            100 * (1 - plan.spec.level)),
                columns({"method", ">estimates", ">agree", ">~biased", ">~cannot be tested", ">furthest off"})};
    struct Tally {
        std::size_t estimates = 0;
        std::size_t deterministic = 0;
        std::size_t agree = 0;
        std::size_t biased = 0;
        const studies::ConfigurationEstimate* furthest = nullptr;
    };
    const auto estimates = studies::configuration_estimates(results.findings);
    std::vector<Tally> of_method(plan.spec.methods.size());
    for (const studies::ConfigurationEstimate& row : estimates) {
        const studies::Cell& cell = plan.cells[row.found->cell];
        Tally& tally = of_method[cell.method];
        const Mark mark = verdict(plan.scenes[cell.scene], row).mark;
        ++tally.estimates;
        tally.deterministic += row.found->bias ? 0u : 1u;
        tally.agree += mark == Mark::good ? 1u : 0u;
        tally.biased += mark == Mark::bad ? 1u : 0u;
        if (tally.furthest == nullptr || how_far(row) > how_far(*tally.furthest)) tally.furthest = &row;
    }
    for (std::size_t method = 0; method < of_method.size(); ++method) {
        const Tally& tally = of_method[method];
        if (tally.estimates == 0) continue;
        const std::size_t sampled = tally.estimates - tally.deterministic;
        const auto of_sampled = [&](std::size_t number) { return sampled == 0 ? "–" : std::to_string(number); };
        table.rows.push_back({plan.spec.methods[method].name,
                              std::to_string(tally.estimates),
                              of_sampled(tally.agree),
                              {of_sampled(tally.biased), tally.biased > 0 ? Mark::bad : Mark::none},
                              of_sampled(sampled - tally.agree - tally.biased),
                              off_by(*tally.furthest)});
    }
    return without_idle_columns(std::move(table));
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
        columns({"scene", "~pair", ">~occluded"})};
    if (results.occlusion.empty()) return table;
    // Where space is short, the first method and the one that errs least most often are shown.
    std::vector<std::size_t> wins(plan.spec.methods.size());
    for (const studies::OcclusionSeries& series : results.occlusion) {
        for (const studies::HiddenPair& scene : series.scenes)
            if (scene.least && scene.decided) ++wins[*scene.least];
    }
    const auto winner = static_cast<std::size_t>(std::ranges::max_element(wins) - wins.begin());
    for (std::size_t method = 0; method < plan.spec.methods.size(); ++method)
        table.columns.push_back({plan.spec.methods[method].name, false, "", method != 0 && method != winner});
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
