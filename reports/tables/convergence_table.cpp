#include "reports/tables/tables.hpp"
#include "reports/text/labels.hpp"
#include "reports/text/numbers.hpp"
#include "reports/words/findings/standing.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace ff::reports {
namespace {

/// @param faster  the mark of what is faster than theory expects
Mark mark_of(const studies::ClassSlopes& found, Mark faster) {
    switch (found.finding) {
        case studies::RateFinding::as_expected:
            return Mark::good;
        case studies::RateFinding::slower:
            return Mark::bad;
        case studies::RateFinding::faster:
            return faster;
        case studies::RateFinding::no_theory:
        case studies::RateFinding::no_slope:
            break;
    }
    return Mark::none;
}

std::string interval_text(const std::optional<stats::Interval>& interval) {
    return interval ? fmt::format("[{:.3f}, {:.3f}]", interval->low, interval->high) : "–";
}

std::string slope(const studies::Slope& found) {
    return found.slope ? fmt::format("{:.3f}", *found.slope) : "–";
}

/// The rate that theory expects: "-0.50"; "≤ -0.57" for an upper bound of the error; "-1.50 to -1.33" where logarithms
/// slow it down at the sizes of the ladder; "-" where none is known.
std::string expected_text(const studies::Slope& slope) {
    if (!slope.expected) return "-";
    const double rate = slope.expected->rate;
    if (slope.expected->at_least) return fmt::format("≤ {:.2f}", slope.slowest_expected);
    if (slope.slowest_expected == rate) return fmt::format("{:.2f}", rate);
    return fmt::format("{:.2f} to {:.2f}", rate, slope.slowest_expected);
}

std::string theory(const studies::Slope& found) {
    if (!found.expected) return "none known";
    return fmt::format("{} [{}]: {}", expected_text(found), found.expected->source, found.expected->because);
}

/// The comparison of trials and theory: "as expected", "slower than expected (p = 0.001)".
std::string finding_in_words(const studies::ClassSlopes& found) {
    const bool infinite = found.rmse.variance == studies::VarianceStatus::infinite;
    std::string words = infinite ? "infinite variance, no RMSE; median " : "";
    const std::string p = found.adjusted_p ? fmt::format(" ({})", p_text(*found.adjusted_p)) : std::string();
    switch (found.finding) {
        case studies::RateFinding::as_expected:
            words += found.judged().expected->at_least ? "within the bound" : "as expected";
            break;
        case studies::RateFinding::slower:
            words += "slower than expected" + p;
            break;
        case studies::RateFinding::faster:
            words += "faster than expected" + p;
            break;
        case studies::RateFinding::no_theory:
            words += "no theory known";
            break;
        case studies::RateFinding::no_slope: {
            if (found.judged().few_trials) return words + "too few trials";
            const auto exact = std::ranges::count_if(
                found.sizes, [](const studies::ClassError& size) { return size.rmse < studies::rounding_error; });
            if (exact > 0 && !infinite)
                return exact == std::ssize(found.sizes)
                           ? "exact to rounding"
                           : fmt::format("exact to rounding at {} of {} sizes", exact, found.sizes.size());
            if (found.rmse.variance != studies::VarianceStatus::none) return words + "no slope";
            return found.rmse.slope && *found.rmse.slope >= 0 ? "deterministic: does not fall"
                                                              : "deterministic: no interval";
        }
    }
    if (found.bent) words += fmt::format("; not a straight line ({})", p_text(*found.judged().lack_of_fit_p));
    return words;
}

}  // namespace

Table slopes_table(const studies::StudyResults& results) {
    const studies::StudyPlan& plan = results.findings.plan;
    Table table{"slopes", "Slopes of ln(error) on ln(N)",
                fmt::format("± half of the {:g} % interval, wider where a straight line may not fit. Verdicts: Holm "
                            "over all rows with a "
                            "theory, {:g} % together.",
                            100 * plan.spec.level, 100 * (1 - plan.spec.level)),
                columns({"method", "sizes", "pairs", ">RMSE", ">median", "theory", "verdict"})};
    for (const studies::LadderSlopes& ladder : results.slopes) {
        const std::string scene = plan.scenes.size() == 1 ? std::string() : plan.scenes.name(ladder.ladder.scene) + " ";
        std::string method = scene + ladder.ladder.label;
        std::string sizes = sizes_text(plan, ladder.ladder);
        for (const studies::ClassSlopes& found : ladder.classes) {
            table.rows.push_back({std::exchange(method, {}),
                                  std::exchange(sizes, {}),
                                  name(found.pair_class),
                                  slope_text(found.rmse),
                                  slope_text(found.median),
                                  expected_text(found.judged()),
                                  {finding_in_words(found), mark_of(found, Mark::surprising)}});
        }
    }
    return table;
}

Table convergence_table(const studies::StudyResults& results) {
    const studies::StudyPlan& plan = results.findings.plan;
    Table table{
        "convergence", "Convergence",
        fmt::format(
            "Slope of ln(error) on ln N, N evaluations per face in a trial: weighted least squares with Var(ln MSE) = "
            "ψ₁(T/2), scaled by how trials vary. Intervals of level {:g} "
            "cover those by bootstrap over whole trials (whose pairs may depend on each other) and, of the RMSE, those "
            "from the weights of the fit. Lack of fit: χ² of the straight line. Theory: the rate expected, with its "
            "source; “≤” where it only bounds the "
            "error; a range where powers of ln N slow it down at these sizes. Verdicts: Holm over all rows with a "
            "theory, {:g} % together.",
            plan.spec.level, 100 * (1 - plan.spec.level)),
        columns({"method", "pairs", "~verdict", ">RMSE slope", ">~interval", ">~from the fit", ">~lack of fit p",
                 ">~median slope", ">~interval", "~theory"})};
    for (const studies::LadderSlopes& ladder : results.slopes) {
        for (const studies::ClassSlopes& found : ladder.classes) {
            table.rows.push_back({scene_prefix(plan, ladder.ladder.scene) + ladder.ladder.label,
                                  name(found.pair_class),
                                  {finding_in_words(found), mark_of(found, Mark::good)},
                                  slope(found.rmse),
                                  interval_text(found.rmse.interval),
                                  interval_text(found.rmse.interval_from_fit),
                                  found.rmse.lack_of_fit_p ? p_value(*found.rmse.lack_of_fit_p) : "–",
                                  slope(found.median),
                                  interval_text(found.median.interval),
                                  theory(found.judged())});
        }
    }
    return without_idle_columns(std::move(table));
}

Table rates_table(const studies::StudyResults& results) {
    const studies::StudyPlan& plan = results.findings.plan;
    constexpr std::size_t most_of_each = 6;
    Table table{"rates", "The fastest convergence",
                fmt::format("Slope of ln(error) on ln N, N evaluations per face in a trial, steepest first, with its "
                            "interval of level {:g}. Methods that are not shown to differ from the first of their "
                            "group share its letter. Of each kind of pairs the first {}; all are below.",
                            plan.spec.level, most_of_each),
                columns({"method", "pairs", ">slope", "~group", "~theory", "~verdict"})};
    for (const Ranking& ranking : rank_rates(results)) {
        for (std::size_t i = 0; i < std::min(most_of_each, ranking.methods.size()); ++i) {
            const RankedMethod& row = ranking.methods[i];
            const auto ladder = std::ranges::find_if(results.slopes, [&](const studies::LadderSlopes& each) {
                return each.ladder.scene == ranking.scene && each.ladder.label == row.label;
            });
            const auto found =
                std::ranges::find(ladder->classes, ranking.pair_class, &studies::ClassSlopes::pair_class);
            table.rows.push_back({scene_prefix(plan, ranking.scene) + row.label,
                                  std::string(name(ranking.pair_class)) + ranking.measured,
                                  with_ends(*row.value, row.interval->low, row.interval->high),
                                  row.group,
                                  expected_text(found->judged()),
                                  {finding_in_words(*found), mark_of(*found, Mark::good)}});
        }
    }
    return table;
}

}  // namespace ff::reports
