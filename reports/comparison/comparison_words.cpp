#include "reports/comparison/comparison_words.hpp"

#include "reports/text/folding.hpp"
#include "reports/text/labels.hpp"
#include "reports/text/numbers.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <string_view>
#include <vector>

namespace ff::reports {

using studies::Basis;
using studies::CellComparison;
using studies::Likeness;
using studies::RunComparison;

namespace {

/// An interval as a bar between 1/`reach` and `reach`, on a logarithmic scale with 1 in the middle.
std::string bar(const studies::RmseRatio& ratio, double reach) {
    constexpr int half = 15;
    const auto place = [&](double value) {
        return half + static_cast<int>(std::lround(half * std::clamp(std::log(value) / std::log(reach), -1.0, 1.0)));
    };
    const int low = place(ratio.interval->low);
    const int high = place(ratio.interval->high);
    const int middle = place(*ratio.ratio);
    std::string text;
    for (int i = 0; i <= 2 * half; ++i) text += i == middle ? "●" : i == half ? "│" : i >= low && i <= high ? "─" : " ";
    return text;
}

std::string_view in_words(studies::Untested reason) {
    switch (reason) {
        case studies::Untested::few_trials:
            return "fewer than five trials";
        case studies::Untested::repeated_trials:
            return "trials repeat each other";
        case studies::Untested::not_finite:
            return "infinity or no number in some trials";
        case studies::Untested::infinite_variance:
            return "infinite variance";
        case studies::Untested::too_few_hits:
            return "too few hits";
        case studies::Untested::no_spread:
            break;
    }
    return "no spread";
}

/// Why some pairs, or all, are not tested.
std::string why_untested(const CellComparison& cell) {
    std::vector<std::string_view> reasons;
    for (const studies::Untested reason : cell.obstacles) reasons.push_back(in_words(reason));
    return reasons.empty() ? "no trials yet" : fmt::format("{}", fmt::join(reasons, " or "));
}

/// The effects that the tests would have detected, and where.
std::string detectable_in_words(const CellComparison& cell, const studies::Detectable& detectable,
                                std::string_view before) {
    if (detectable.pairs == 0) return "nothing";
    std::string words = fmt::format("{}{}", before, brief(detectable.size, 2));
    const bool everywhere = detectable.pairs == cell.pairs - cell.untestable;
    return everywhere ? words : words + fmt::format(" on {} of the pairs", detectable.pairs);
}

const Scene& scene_of(const RunComparison& comparison, const CellComparison& cell) {
    const studies::StudyPlan& plan = comparison.first.plan;
    return plan.scenes[plan.cells[cell.first].scene];
}

std::string ratio_text(const studies::RmseRatio& ratio) {
    return to_error_with_ends(*ratio.ratio, ratio.interval->low, ratio.interval->high, ratio.interval->width() / 2);
}

std::string independent_in_words(const RunComparison& comparison, const CellComparison& cell) {
    const double alpha = 1 - comparison.level;
    const Scene& scene = scene_of(comparison, cell);
    std::vector<std::string> parts;
    if (cell.mean && cell.mean->adjusted_p < alpha) {
        parts.push_back(fmt::format("mean of {} by {}{} ({})", quantity_label(scene, cell.mean->pair),
                                    cell.mean->size > 0 ? "+" : "", with_half_width(cell.mean->size, cell.mean->error),
                                    p_text(cell.mean->adjusted_p)));
    }
    if (cell.spread && cell.spread->adjusted_p < alpha) {
        parts.push_back(fmt::format("standard deviation of {} by a factor {} ({})",
                                    quantity_label(scene, cell.spread->pair), brief(cell.spread->size, 2),
                                    p_text(cell.spread->adjusted_p)));
    }
    for (const studies::RmseRatio& ratio : cell.ratios) {
        if (ratio.adjusted_p >= alpha) continue;
        parts.push_back(fmt::format("RMSE on {} pairs by a factor {} ({})", name(ratio.pair_class),
                                    brief(ratio.second / ratio.first), p_text(ratio.adjusted_p)));
    }
    if (!parts.empty()) return fmt::format("DIFFERENT: {}", fmt::join(parts, "; "));
    const std::string untested = cell.untestable == 0
                                     ? std::string()
                                     : fmt::format(" on {} of {} pairs, {} on the others", cell.pairs - cell.untestable,
                                                   cell.pairs, why_untested(cell));
    if (cell.difference.pairs == 0 && cell.ratio.pairs == 0)
        return fmt::format("inconclusive{} (too few trials to detect any difference)", untested);
    return fmt::format("{}{} (would detect {} in a mean, {} in a standard deviation)",
                       cell.likeness == Likeness::alike ? "no difference found" : "inconclusive", untested,
                       detectable_in_words(cell, cell.difference, ""),
                       detectable_in_words(cell, cell.ratio, "a factor "));
}

}  // namespace

std::string method_names(const RunComparison& comparison, const CellComparison& compared) {
    const auto name_in = [](const studies::StudyPlan& plan, std::size_t cell) -> const std::string& {
        return plan.spec.methods[plan.cells[cell].method].name;
    };
    const std::string& first = name_in(comparison.first.plan, compared.first);
    const std::string& second = name_in(comparison.second.plan, compared.second);
    return first == second ? first : fmt::format("{} | {}", first, second);
}

std::string scene_and_method(const RunComparison& comparison, const CellComparison& compared) {
    const std::string method = method_names(comparison, compared);
    const studies::StudyPlan& plan = comparison.first.plan;
    return scene_prefix(plan, plan.cells[compared.first].scene) + method;
}

std::string ratio_plot(const RunComparison& comparison) {
    const auto lead = comparison.lead();
    if (!lead.ratios) return {};
    const double reach = std::max({1 / lead.ratios->low, lead.ratios->high, 1.05});
    const studies::StudyPlan& plan = comparison.first.plan;
    std::vector<std::array<std::string, 3>> rows{
        {fmt::format("RMSE of {} / RMSE of {}", comparison.names[1], comparison.names[0]),
         fmt::format("{:<15.2f}1{:>15.2f}", 1 / reach, reach), ""}};
    for (const CellComparison& compared : comparison.cells) {
        for (const studies::RmseRatio& ratio : compared.ratios) {
            if (!ratio.interval) continue;
            rows.push_back({fmt::format("{}, {}, {}", scene_and_method(comparison, compared),
                                        size_label(plan, plan.cells[compared.first]), name(ratio.pair_class)),
                            bar(ratio, reach), ratio_text(ratio)});
        }
    }
    std::size_t width = 0;
    for (const auto& row : rows) width = std::max(width, visible_length(row[0]));
    std::string out;
    for (const auto& [label, drawn, figures] : rows) {
        std::string line =
            fmt::format("{}{}  {}  {}", label, std::string(width - visible_length(label), ' '), drawn, figures);
        out += line.substr(0, line.find_last_not_of(' ') + 1) + '\n';
    }
    return out;
}

TableCell likeness_in_words(const RunComparison& comparison, const CellComparison& cell) {
    const Mark mark = cell.likeness == Likeness::alike       ? Mark::good
                      : cell.likeness == Likeness::different ? Mark::bad
                                                             : Mark::open;
    switch (cell.basis) {
        case Basis::independent:
            if (!cell.mean) return {"no test: " + why_untested(cell), mark};
            return {independent_in_words(comparison, cell), mark};
        case Basis::same_random_numbers:
            if (cell.likeness == Likeness::untestable) return {"same random numbers, no trial in both", mark};
            if (cell.differing == 0)
                return {fmt::format("the same random numbers, equal in all {} trials", cell.trials), mark};
            return {fmt::format("DIFFERENT: {} of {} trials with the same random numbers", cell.differing, cell.trials),
                    mark};
        case Basis::deterministic:
            if (cell.likeness == Likeness::untestable) return {"not run yet", mark};
            if (cell.likeness == Likeness::alike) return {"equal", mark};
            return {fmt::format("DIFFERENT: {} by {:+.2e}",
                                quantity_label(scene_of(comparison, cell), cell.largest_pair), cell.largest_difference),
                    mark};
        case Basis::completed_differently:
            return {"no test: the same trials, completed in two ways", mark};
        case Basis::mixed:
            break;
    }
    return {"no test: only one of them is random", mark};
}

}  // namespace ff::reports
