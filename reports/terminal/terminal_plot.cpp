#include "reports/terminal/terminal_sections.hpp"
#include "reports/text/labels.hpp"
#include "reports/text/text_plot.hpp"
#include "reports/words/size_series.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace ff::reports {
namespace {

/// More series than this are a thicket: then the best and the worst are drawn.
constexpr std::size_t at_most = 6;
constexpr std::size_t best_of_many = 3;

constexpr std::size_t widest = 56;
constexpr std::size_t margin = 12;  // of a plot: the labels of its y axis
constexpr std::size_t narrowest = margin + 20;

bool is_ladder(const SizeSeries& series) {
    return !series.ladders.empty() && series.points.size() > 2;
}

bool ends_lower(const SizeSeries& a, const SizeSeries& b) {
    return a.points.back().error < b.points.back().error;
}

PlottedSeries plotted(const SizeSeries& series) {
    PlottedSeries letters{series.method + (series.points.front().is_median ? " (median)" : ""), {}};
    for (const SizePoint& point : series.points)
        letters.points.emplace_back(static_cast<double>(point.found->evaluations_per_face), point.error);
    return letters;
}

std::string plot_of(const studies::StudyPlan& plan, std::size_t scene, PairClass pair_class,
                    std::vector<SizeSeries> all, const TextStyle& style) {
    std::string which;
    if (all.size() > at_most) {
        // The one error of a deterministic method may be small by luck.
        std::erase_if(
            all, [&](const SizeSeries& series) { return plan.cells[series.points.back().found->cell].deterministic; });
    }
    if (all.size() > at_most) {
        which = fmt::format(" (of {1} sampled methods those whose lines end lowest, {0}, and highest)", best_of_many,
                            all.size());
        std::stable_sort(all.begin(), all.end(), ends_lower);
        all.erase(all.begin() + best_of_many, all.end() - 1);
    }
    std::vector<PlottedSeries> letters;
    for (const SizeSeries& series : all) letters.push_back(plotted(series));
    const std::string plot = text_plot(letters, std::min(widest, std::max(style.width, narrowest) - margin));
    if (plot.empty()) return {};
    return fmt::format("\nRMSE of a run against evaluations per face, {} pairs{}{}\n{}", name(pair_class),
                       of_scene(plan, scene), which, plot);
}

}  // namespace

std::string terminal_plots(const studies::StudyResults& results, const TextStyle& style) {
    if (results.slopes.empty()) return {};
    const studies::StudyPlan& plan = results.findings.plan;
    std::string out;
    for (std::size_t scene = 0; scene < plan.scenes.size(); ++scene) {
        for (const PairClass pair_class : {PairClass::parallel, PairClass::adjacent, PairClass::other}) {
            std::vector<SizeSeries> ladders;
            for (SizeSeries& series : size_series(results, scene, pair_class)) {
                if (is_ladder(series)) ladders.push_back(std::move(series));
            }
            // A ladder alone is told by its slope.
            if (ladders.size() > 1) out += plot_of(plan, scene, pair_class, std::move(ladders), style);
        }
    }
    return out;
}

}  // namespace ff::reports
