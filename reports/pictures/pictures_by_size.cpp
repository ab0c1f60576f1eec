#include "reports/pictures/method_styles.hpp"
#include "reports/text/labels.hpp"
#include "reports/text/numbers.hpp"
#include "reports/words/findings/occlusion_words.hpp"
#include "reports/words/findings/printed_errors.hpp"
#include "reports/words/findings/standing.hpp"
#include "reports/words/published_words.hpp"
#include "reports/words/sizes.hpp"
#include "studies/comparison/ranking.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>
#include <vector>

namespace ff::reports {
namespace {

std::string where(const studies::StudyPlan& plan, std::size_t scene, PairClass pair_class) {
    return fmt::format("{} pairs{}", name(pair_class), of_scene(plan, scene));
}

/// The two ends of a line with the slope that theory allows, through the middle of the points of a ladder, if there are
/// two. @return whether there are
bool add_expected(const SizeSeries& series, const studies::ClassSlopes& slopes, PictureValues& values) {
    const studies::Slope& slope = slopes.judged();
    if (!slope.slope || !slope.expected) return false;
    std::vector<const SizePoint*> points;
    for (const SizePoint& point : series.points) {
        const bool on_ladder = std::any_of(slopes.sizes.begin(), slopes.sizes.end(), [&](const auto& size) {
            return size.evaluations == point.found->evaluations_per_face;
        });
        if (on_ladder) points.push_back(&point);
    }
    if (points.size() < 2) return false;
    const auto log_size = [](const SizePoint& point) {
        return std::log(static_cast<double>(point.found->evaluations_per_face));
    };
    double mean_size = 0;
    double mean_error = 0;
    for (const SizePoint* point : points) {
        mean_size += log_size(*point) / static_cast<double>(points.size());
        mean_error += std::log(point->error) / static_cast<double>(points.size());
    }
    for (const SizePoint* end : {points.front(), points.back()}) {
        const double error = std::exp(mean_error + slopes.judged().slowest_expected * (log_size(*end) - mean_size));
        values.add(
            {series.method, "expected", "", end->found->evaluations_per_face, drawn(error, 4), nullptr, nullptr});
    }
    return true;
}

/// The single error of a deterministic method may be small by luck, so it is not compared with errors of samples.
std::string smallest_errors_in_words(const studies::Analysis& findings, const std::vector<SizeSeries>& all,
                                     PairClass pair_class) {
    std::string text;
    for (const bool deterministic : {true, false}) {
        const std::string smallest = smallest_errors(findings, cells_of(findings.plan, all, deterministic), pair_class);
        if (smallest.empty()) continue;
        text +=
            fmt::format("Among {} methods in this picture {}. ", deterministic ? "deterministic" : "sampled", smallest);
    }
    return text;
}

/// A logarithmic axis has no place for errors at the level of rounding: " Not drawn: PDM (exact)." Empty without any.
std::string not_drawn(std::vector<std::string> exact) {
    return exact.empty() ? std::string() : fmt::format(" Not drawn: {} (exact).", listed(std::move(exact)));
}

/// @param finding  what is said before the key of lines and marks
Picture convergence_picture(const studies::StudyResults& results, std::size_t scene, PairClass pair_class,
                            const std::vector<SizeSeries>& all, const MethodChoice& methods,
                            const std::vector<MethodStyle>& styles, const std::string& finding = {}) {
    const studies::Analysis& findings = results.findings;
    auto exact = exact_methods(results, scene, pair_class);
    std::erase_if(exact, [&](const std::string& method) { return !methods.has(method); });
    for (std::string& method : exact) {
        if (std::ranges::find(all, method, &SizeSeries::method) != all.end()) method += " at other sizes";
    }
    bool is_expected = false;
    bool is_printed = false;
    std::set<std::string> not_as_described;  // methods that do not give their printed figures
    PictureValues values({"method", "role", "size", "evaluations", "error", "low", "high"});
    MethodLines lines(styles, HeightAxis::logarithmic);
    for (const SizeSeries& series : all) {
        lines.begin(series.method, series.method);
        for (const SizePoint& point : series.points) {
            const auto interval = point.is_median ? std::nullopt : point.found->class_error(pair_class)->interval;
            values.add({series.method, point.is_median ? "median" : "RMSE",
                        size_label(findings.plan, findings.plan.cells[point.found->cell]),
                        point.found->evaluations_per_face, drawn(point.error), drawn_low(interval),
                        drawn_high(interval)});
            lines.add(point.error, interval);
            if (!results.published) continue;
            const PrintedErrors errors = printed_errors(results, point.found->cell, pair_class);
            const double printed = errors.printed_rms;
            if (printed < studies::rounding_error) continue;
            if (errors.differs && findings.plan.cells[point.found->cell].deterministic)
                not_as_described.insert(series.method);
            values.add({series.method, "printed", size_label(findings.plan, findings.plan.cells[point.found->cell]),
                        point.found->evaluations_per_face, drawn(printed), nullptr, nullptr});
            lines.make_room(printed);
            is_printed = true;
        }
        for (const studies::ClassSlopes* slopes : series.ladders) is_expected |= add_expected(series, *slopes, values);
    }
    lines.set(values);
    const std::string place = where(findings.plan, scene, pair_class);
    const double percents = 100 * findings.plan.spec.level;
    return picture_of(
        values, "convergence", fmt::format("convergence-{}", place),
        fmt::format("Error against evaluations, {}.", place),
        fmt::format("{}Bands and bars: {:g} % intervals{}{}{}.{}", finding, percents,
                    is_expected ? "; dashed: the slope that theory expects" : "",
                    is_printed ? "; hollow: the printed figures, one run" : "",
                    not_as_described.empty()
                        ? ""
                        : fmt::format(" (which {} as described does not give)", fmt::join(not_as_described, ", ")),
                    not_drawn(std::move(exact))),
        fmt::format("RMSE of a run on {} against evaluations per face, both logarithmic, with {:g} % intervals, a line "
                    "for each method; where the variance is infinite, the median of the absolute error.",
                    place, percents));
}

std::optional<Picture> efficiency_picture(const studies::Analysis& findings, std::size_t scene, PairClass pair_class,
                                          const std::vector<SizeSeries>& all, const std::vector<MethodStyle>& styles) {
    PictureValues values({"method", "size", "evaluations", "efficiency", "low", "high"});
    std::vector<std::size_t> cells;
    MethodLines lines(styles, HeightAxis::logarithmic);
    for (const SizeSeries& series : all) {
        lines.begin(series.method, series.method);
        for (const SizePoint& point : series.points) {
            const studies::CellAnalysis& found = *point.found;
            const studies::ClassError& error = *found.class_error(pair_class);
            if (!error.efficiency) continue;
            values.add({series.method, size_label(findings.plan, findings.plan.cells[found.cell]),
                        found.evaluations_per_face, drawn(error.efficiency), drawn_low(error.efficiency_interval),
                        drawn_high(error.efficiency_interval)});
            cells.push_back(found.cell);
            lines.add(*error.efficiency, error.efficiency_interval);
        }
    }
    if (cells.size() < 2) return std::nullopt;
    lines.set(values);
    const std::string place = where(findings.plan, scene, pair_class);
    const std::string largest = largest_efficiencies(findings, cells, pair_class);
    return picture_of(values, "efficiency", fmt::format("efficiency-{}", place),
                      fmt::format("Efficiency against evaluations, {}.", place),
                      largest.empty() ? "Bars: intervals." : fmt::format("Per evaluation {}.", largest),
                      fmt::format("1 / (RMSE² N) of the sampled methods on {} against N, the evaluations for a face, "
                                  "with {:g} % intervals.",
                                  place, 100 * findings.plan.spec.level));
}

/// Error against the occluded fraction at the common number of samples of a pair, for a family of scenes.
Picture picture_of_series(const studies::StudyResults& results, const studies::OcclusionSeries& series,
                          const MethodChoice& methods) {
    const studies::StudyPlan& plan = results.findings.plan;
    PictureValues values({"method", "scene", "occluded_fraction", "size", "error", "low", "high"});
    MethodLines lines(method_styles(results, methods), HeightAxis::logarithmic);
    std::vector<std::string> exact;
    for (std::size_t method = 0; method < plan.spec.methods.size(); ++method) {
        const std::string& name = plan.spec.methods[method].name;
        if (!methods.has(name)) continue;
        lines.begin(name, name);
        for (const studies::HiddenPair& scene : series.scenes) {
            const auto& found = scene.methods[method];
            if (!found) continue;
            if (found->size() < studies::rounding_error) {
                if (scene.least) exact.push_back(fmt::format("{} at {:.3g}", name, scene.hidden));
                continue;
            }
            const bool infinite = found->error.status == studies::VarianceStatus::infinite;
            const auto interval = infinite ? std::nullopt : found->error.interval;
            values.add({name, plan.scenes.name(scene.scene), drawn(scene.hidden, 4),
                        size_label(plan, plan.cells[found->cell]), drawn(found->size()), drawn_low(interval),
                        drawn_high(interval)});
            lines.add(found->size(), interval);
        }
    }
    lines.set(values);
    const std::string pair = quantity_label(plan.scenes[series.scenes.front().scene], series.pair);
    return picture_of(
        values, "occlusion", fmt::format("occlusion-{}-{}", series.family, pair),
        fmt::format("Error against the occluded fraction: {}, {}.", series.family, pair),
        fmt::format("{} Bars: {:g} % intervals, where longer than the marks.{}",
                    least_errors_of_series(results, series), 100 * plan.spec.level, not_drawn(std::move(exact))),
        fmt::format("RMSE of a run (logarithmic) on {} against the occluded fraction of its form factor, "
                    "in {} scenes with another {}, a line for each method, with {:g} % intervals.",
                    pair, series.scenes.size(), series.measure, 100 * plan.spec.level));
}

}  // namespace

std::vector<Picture> pictures_of_scene(const studies::StudyResults& results, std::size_t scene,
                                       const std::vector<MethodStyle>& styles, const MethodChoice& methods) {
    const studies::Analysis& findings = results.findings;
    std::vector<Picture> pictures;
    for (const PairClass pair_class : pair_classes) {
        auto all = size_series(results, scene, pair_class);
        std::erase_if(all, [&](const SizeSeries& series) { return !methods.has(series.method); });
        if (all.empty() || (all.size() == 1 && all.front().points.size() == 1))
            continue;  // one point does not make a picture
        pictures.push_back(convergence_picture(results, scene, pair_class, all, methods, styles,
                                               smallest_errors_in_words(findings, all, pair_class)));
        if (auto efficiency = efficiency_picture(findings, scene, pair_class, all, styles))
            pictures.push_back(std::move(*efficiency));
    }
    return pictures;
}

std::optional<Picture> publication_picture(const studies::StudyResults& results, const MethodChoice& methods) {
    const studies::StudyPlan& plan = results.findings.plan;
    const auto styles = method_styles(results, methods);
    std::optional<Picture> picture;
    for (std::size_t scene = 0; scene < plan.scenes.size(); ++scene) {
        std::set<std::string> compared;
        for (const std::size_t cell : studies::compared_cells(results.findings, scene, results.published->comparisons))
            compared.insert(plan.spec.methods[plan.cells[cell].method].name);
        for (const PairClass pair_class : {PairClass::adjacent, PairClass::parallel, PairClass::other}) {
            auto all = size_series(results, scene, pair_class);
            std::erase_if(all, [&](const SizeSeries& series) {
                return !compared.contains(series.method) || !methods.has(series.method);
            });
            if (all.size() < 2) continue;
            Picture each = convergence_picture(results, scene, pair_class, all, methods, styles);
            each.name = where(plan, scene, pair_class);
            if (!picture) {
                each.id = "answer";
                picture = std::move(each);
            } else {
                each.id = fmt::format("answer-{}", picture->alternatives.size() + 1);
                picture->alternatives.push_back(std::move(each));
            }
        }
    }
    return picture;
}

std::vector<Picture> pictures_by_size(const studies::StudyResults& results, const MethodChoice& methods) {
    std::vector<Picture> pictures;
    for (const studies::OcclusionSeries& series : results.occlusion)
        pictures.push_back(picture_of_series(results, series, methods));
    if (!pictures.empty()) return pictures;
    const auto styles = method_styles(results, methods);
    for (std::size_t scene = 0; scene < results.findings.plan.scenes.size(); ++scene) {
        for (Picture& picture : pictures_of_scene(results, scene, styles, methods))
            pictures.push_back(std::move(picture));
    }
    return pictures;
}

}  // namespace ff::reports
