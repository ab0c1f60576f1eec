#include "reports/words/findings/occlusion_words.hpp"

#include "reports/text/labels.hpp"
#include "reports/text/numbers.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <utility>

namespace ff::reports {
namespace {

using studies::HiddenPair;
using studies::OcclusionSeries;
using studies::StudyResults;

bool is_open(const HiddenPair& scene) {
    return scene.hidden == 0;
}

/// All scenes of all series for which a condition holds.
template <class Condition>
std::vector<const HiddenPair*> scenes_where(const StudyResults& results, Condition holds) {
    std::vector<const HiddenPair*> found;
    for (const OcclusionSeries& series : results.occlusion) {
        for (const HiddenPair& scene : series.scenes) {
            if (holds(scene)) found.push_back(&scene);
        }
    }
    return found;
}

/// Slopes of one method, in ascending order.
struct Slopes {
    std::vector<double> values;
    int flat = 0;       ///< number that are shown to be flatter than that of random points
    bool shown = true;  ///< they have intervals
    int medians = 0;    ///< number that are of the median error, for want of a variance
};

Slopes slopes_of(const std::vector<const HiddenPair*>& scenes, std::size_t method) {
    Slopes slopes;
    for (const HiddenPair* scene : scenes) {
        const auto& found = scene->methods[method];
        if (!found || !found->slope || !found->slope->slope) continue;
        if (found->slower_than_random) ++slopes.flat;
        if (found->slope->variance == studies::VarianceStatus::none) slopes.shown = false;
        if (found->slope->statistic == studies::ErrorSize::median_abs_error) ++slopes.medians;
        slopes.values.push_back(*found->slope->slope);
    }
    std::sort(slopes.values.begin(), slopes.values.end());
    return slopes;
}

std::string range(const std::vector<double>& ascending) {
    const std::string low = fmt::format("{:.2f}", ascending.front());
    const std::string high = fmt::format("{:.2f}", ascending.back());
    return low == high ? low : fmt::format("{} to {}", low, high);
}

/// "PDM: ..."; empty where it has no slope in hidden scenes.
std::string slopes_in_words(const StudyResults& results, std::size_t method) {
    const Slopes open = slopes_of(scenes_where(results, is_open), method);
    const Slopes hidden = slopes_of(scenes_where(results, std::mem_fn(&HiddenPair::is_partly_hidden)), method);
    if (hidden.values.empty()) return {};
    return fmt::format(
        "{}: the error falls with slope {}{} where a part is occluded (median {:.2f}), {}"
        "flatter than that of random points with finite variance, {:.1f}, in {} of {} cases{}.",
        results.findings.plan.spec.methods[method].name,
        open.values.empty() ? "" : fmt::format("{} unoccluded, ", range(open.values)), range(hidden.values),
        hidden.values[hidden.values.size() / 2], hidden.shown ? "shown to be " : "", studies::slope_of_random,
        hidden.flat, hidden.values.size(),
        hidden.medians > 0
            ? fmt::format("; in {} the variance is infinite and the slope that of the median error", hidden.medians)
            : "");
}

std::string share(double hidden) {
    return fmt::format("{:.3g}", hidden);
}

/// The smallest error of a scene: its method and, where that is not shown, a remark.
std::string winner(const StudyResults& results, const HiddenPair& scene) {
    if (!scene.least) return "all are exact";
    const std::string& name = results.findings.plan.spec.methods[*scene.least].name;
    return scene.decided ? name : fmt::format("{} (not significantly)", name);
}

/// The methods that are shown to have the smallest error in some scene, with the number of scenes, the most first.
std::vector<std::pair<std::string, int>> most_wins(const StudyResults& results,
                                                   const std::vector<const HiddenPair*>& scenes) {
    std::vector<std::pair<std::string, int>> wins;
    for (const studies::Method& method : results.findings.plan.spec.methods) wins.emplace_back(method.name, 0);
    for (const HiddenPair* scene : scenes) {
        if (scene->least && scene->decided) ++wins[*scene->least].second;
    }
    std::erase_if(wins, [](const auto& win) { return win.second == 0; });
    std::stable_sort(wins.begin(), wins.end(), [](const auto& a, const auto& b) { return a.second > b.second; });
    return wins;
}

/// The method that is shown to have the smallest error on most of some pairs; null where there is none.
const std::pair<std::string, int>* most_often_least(const std::vector<std::pair<std::string, int>>& wins,
                                                    std::size_t pairs) {
    return !wins.empty() && 2 * static_cast<std::size_t>(wins.front().second) > pairs ? &wins.front() : nullptr;
}

/// How a method without a variance in some of these scenes is to be replaced there: "; where its variance is infinite,
/// mostly Sobol' rays", by the method whose error is shown to be least in most of them; empty where no such method has
/// one.
std::string where_variance_is_infinite(const StudyResults& results, const std::vector<const HiddenPair*>& scenes,
                                       const std::string& taken) {
    const auto& methods = results.findings.plan.spec.methods;
    std::vector<int> least(methods.size());
    std::size_t infinite = 0;
    for (const HiddenPair* scene : scenes) {
        const auto is_infinite = [&](std::size_t method) {
            const auto& found = scene->methods[method];
            return found && found->error.status == studies::VarianceStatus::infinite;
        };
        const auto chosen = std::ranges::find(methods, taken, &studies::Method::name);
        if (!is_infinite(static_cast<std::size_t>(chosen - methods.begin()))) continue;
        ++infinite;
        if (scene->least && scene->decided && !is_infinite(*scene->least)) ++least[*scene->least];
    }
    const auto most = std::ranges::max_element(least);
    if (most == least.end() || *most == 0) return {};
    return fmt::format("; where its variance is infinite, {}{}",
                       static_cast<std::size_t>(*most) < infinite ? "mostly " : "",
                       methods[static_cast<std::size_t>(most - least.begin())].name);
}

/// "1.2 to 9.5 times less than the next", over the scenes in which a method is shown to have the smallest error, from
/// the lowest to the highest end of the intervals; "least" where none of them has one.
std::string how_much_less(const StudyResults& results, const std::vector<const HiddenPair*>& scenes,
                          const std::string& taken) {
    std::optional<stats::Interval> hull;
    for (const HiddenPair* scene : scenes) {
        const bool won =
            scene->least && scene->decided && results.findings.plan.spec.methods[*scene->least].name == taken;
        if (!won || !scene->next) continue;
        if (!hull) hull = scene->next;
        hull->low = std::min(hull->low, scene->next->low);
        hull->high = std::max(hull->high, scene->next->high);
    }
    return hull ? ends_in_words(hull->low, hull->high) + " times less than the next" : "least";
}

}  // namespace

std::string least_errors_of_series(const StudyResults& results, const OcclusionSeries& series) {
    std::vector<std::string> parts;
    for (auto first = series.scenes.begin(); first != series.scenes.end();) {
        const std::string who = winner(results, *first);
        const auto end = std::find_if(first, series.scenes.end(),
                                      [&](const HiddenPair& scene) { return winner(results, scene) != who; });
        const std::string from = share(first->hidden);
        const std::string to = share(std::prev(end)->hidden);
        parts.push_back(fmt::format("{} at {}", who, from == to ? from : fmt::format("{} to {}", from, to)));
        first = end;
    }
    return fmt::format("Least error by occluded fraction, at about {} samples: {}.", series.samples,
                       fmt::join(parts, "; "));
}

std::string series_in_words(const StudyResults& results, const OcclusionSeries& series) {
    const Scene& scene = results.findings.plan.scenes[series.scenes.front().scene];
    return fmt::format("{}, {}. {}", series.family, quantity_label(scene, series.pair),
                       least_errors_of_series(results, series));
}

std::vector<std::string> occlusion_in_brief(const StudyResults& results) {
    std::vector<std::string> lines;
    if (results.occlusion.empty()) return lines;
    for (std::size_t method = 0; method < results.findings.plan.spec.methods.size(); ++method) {
        if (std::string line = slopes_in_words(results, method); !line.empty()) lines.push_back(std::move(line));
    }
    for (const OcclusionSeries& series : results.occlusion) lines.push_back(series_in_words(results, series));
    return lines;
}

std::optional<Slowed> slowest_where_occluded(const StudyResults& results) {
    std::optional<Slowed> slowest;
    bool alone = true;
    const auto hidden = scenes_where(results, std::mem_fn(&HiddenPair::is_partly_hidden));
    for (std::size_t method = 0; method < results.findings.plan.spec.methods.size(); ++method) {
        const Slopes slopes = slopes_of(hidden, method);
        if (slopes.flat == 0 || (slowest && slopes.flat < slowest->slow)) continue;
        alone = !slowest || slopes.flat > slowest->slow;
        slowest = {results.findings.plan.spec.methods[method].name, slopes.flat, slopes.values.size()};
    }
    return alone ? slowest : std::nullopt;
}

std::string occlusion_advice(const StudyResults& results) {
    const auto hidden = scenes_where(results, std::mem_fn(&HiddenPair::is_partly_hidden));
    const auto open = scenes_where(results, is_open);
    const auto wins = most_wins(results, hidden);
    const auto wins_open = most_wins(results, open);
    const auto* const best = most_often_least(wins, hidden.size());
    const auto* const best_open = most_often_least(wins_open, open.size());
    std::string text;
    if (best == nullptr) {
        text = fmt::format("no method is shown to err least on {} of {}", wins.empty() ? "any" : "most",
                           counted(hidden.size(), "partly occluded pair"));
        if (!wins.empty()) text += fmt::format(" ({} on {})", wins.front().first, wins.front().second);
    } else {
        text = fmt::format("at about equal samples take {} on partly occluded pairs (errs {} on {} of {})", best->first,
                           how_much_less(results, hidden, best->first), best->second, hidden.size());
        const std::string instead = where_variance_is_infinite(results, hidden, best->first);
        if (!instead.empty())
            text += instead;
        else if (wins.size() > 1)
            text += fmt::format("; {} errs least on {}", wins[1].first, wins[1].second);
    }
    if (best_open != nullptr && (best == nullptr || best_open->first != best->first))
        text += fmt::format("; unoccluded, {}{}", best_open->first,
                            open.size() == 1 ? "" : fmt::format(" ({} of {})", best_open->second, open.size()));
    return text;
}

std::string occlusion_clause(const StudyResults& results) {
    const auto tell = [&](const std::vector<const HiddenPair*>& scenes, const char* pair) {
        auto undecided = static_cast<int>(scenes.size());
        std::vector<std::string> parts;
        const auto on = [&](int count) {
            if (scenes.size() == 1) return fmt::format("the only {}", pair);
            return fmt::format("{} of {}{}", count, scenes.size(), parts.empty() ? fmt::format(" {}s", pair) : "");
        };
        for (const auto& [method, count] : most_wins(results, scenes)) {
            parts.push_back(fmt::format("{} on {}", method, on(count)));
            undecided -= count;
        }
        if (undecided > 0) parts.push_back(fmt::format("none for certain on {}", on(undecided)));
        return listed(std::move(parts));
    };
    const auto open = scenes_where(results, is_open);
    const auto hidden = scenes_where(results, std::mem_fn(&HiddenPair::is_partly_hidden));
    if (hidden.empty()) return {};
    return fmt::format("with about equal samples per pair, the smallest errors are those of {}{}",
                       tell(hidden, "partly occluded pair"),
                       open.empty() ? "" : fmt::format("; unoccluded, {}", tell(open, "pair")));
}

}  // namespace ff::reports
