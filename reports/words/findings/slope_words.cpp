#include "reports/words/findings/slope_words.hpp"

#include "reports/text/labels.hpp"
#include "reports/text/numbers.hpp"
#include "reports/words/findings/standing.hpp"

#include <fmt/format.h>

namespace ff::reports {

std::string slope_text(const studies::Slope& slope) {
    if (!slope.slope) return "-";
    return slope.interval ? fmt::format("{:.2f}±{:.2f}", *slope.slope, slope.interval->width() / 2)
                          : fmt::format("{:.2f}", *slope.slope);
}

std::string expected_text(const studies::Slope& slope) {
    if (!slope.expected) return "-";
    const double rate = slope.expected->rate;
    if (slope.expected->at_least) return fmt::format("≤ {:.2f}", slope.slowest_expected);
    if (slope.slowest_expected == rate) return fmt::format("{:.2f}", rate);
    return fmt::format("{:.2f} to {:.2f}", rate, slope.slowest_expected);
}

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
        case studies::RateFinding::no_slope:
            if (found.judged().few_trials) return words + "too few trials";
            if (found.rmse.variance != studies::VarianceStatus::none) return words + "no slope";
            return found.rmse.slope ? "deterministic: no interval" : "exact to rounding";
    }
    if (found.bent) words += fmt::format("; not a straight line ({})", p_text(*found.judged().lack_of_fit_p));
    return words;
}

std::string sizes_text(const studies::StudyPlan& plan, const studies::Ladder& ladder) {
    const bool patches = ladder.growth == studies::Growth::patches;
    const auto size = [&](std::size_t cell) {
        return patches ? plan.cells[cell].subdivision.per_part() : plan.cells[cell].samples_per_patch;
    };
    return fmt::format("{} … {} ({}){}", size(ladder.cells.front()), size(ladder.cells.back()), ladder.cells.size(),
                       patches ? " patches" : "");
}

namespace {

/// How many verdicts are of each kind.
std::string verdicts_in_words(const std::vector<studies::LadderSlopes>& ladders) {
    std::size_t judged = 0;
    std::size_t expected = 0;
    std::vector<std::string> others;
    for (const studies::LadderSlopes& ladder : ladders) {
        for (const studies::ClassSlopes& found : ladder.classes) {
            if (!found.adjusted_p) continue;
            ++judged;
            if (found.finding == studies::RateFinding::as_expected) {
                ++expected;
            } else {
                others.push_back(fmt::format("{} on {} pairs is {}", ladder.ladder.label, name(found.pair_class),
                                             found.finding == studies::RateFinding::slower ? "slower" : "faster"));
            }
        }
    }
    if (judged == 0) return {};
    return fmt::format("Of {} with a theory {} {} as expected{}{}.", counted(judged, "rate"), expected,
                       expected == 1 ? "is" : "are", others.empty() ? "" : "; ", listed(others));
}

}  // namespace

std::vector<std::string> slopes_in_brief(const studies::StudyResults& results) {
    std::vector<std::string> lines;
    if (results.occlusion.empty()) {  // otherwise scenes differ in what hides, and are described together
        for (const Ranking& ranking : rank_rates(results)) lines.push_back(sentence(ranking, results.findings.plan));
    }
    if (std::string verdicts = verdicts_in_words(results.slopes); !verdicts.empty())
        lines.push_back(std::move(verdicts));
    return lines;
}

}  // namespace ff::reports
