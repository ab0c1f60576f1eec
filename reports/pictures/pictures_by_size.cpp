#include "reports/pictures/line_labels.hpp"
#include "reports/pictures/method_styles.hpp"
#include "reports/pictures/picture_values.hpp"
#include "reports/pictures/pictures.hpp"
#include "reports/text/labels.hpp"
#include "reports/text/numbers.hpp"
#include "reports/words/findings/standing.hpp"
#include "reports/words/size_series.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace ff::reports {
namespace {

bool in_colour(const std::vector<MethodStyle>& styles, const std::string& method) {
    return std::any_of(styles.begin(), styles.end(),
                       [&](const MethodStyle& style) { return style.method == method && style.in_colour; });
}

std::string where(const studies::StudyPlan& plan, std::size_t scene, PairClass pair_class) {
    return fmt::format("{} pairs{}", name(pair_class), of_scene(plan, scene));
}

nlohmann::ordered_json names_of(const std::vector<SizeSeries>& all) {
    auto names = nlohmann::ordered_json::array();
    for (const SizeSeries& series : all) names.push_back(series.method);
    return names;
}

nlohmann::ordered_json interval_end(const std::optional<stats::Interval>& interval, double stats::Interval::*end) {
    return interval ? drawn((*interval).*end) : nlohmann::ordered_json();
}

/// Ends that a logarithmic axis can show.
std::vector<double> ends_of(const std::optional<stats::Interval>& interval) {
    return interval && interval->low > 0 ? std::vector{interval->low, interval->high} : std::vector<double>();
}

/// The two ends of a line with the slope that theory allows, through the middle of the points of a ladder.
void add_expected(const SizeSeries& series, const studies::ClassSlopes& slopes, PictureValues& values) {
    const studies::Slope& slope = slopes.judged();
    if (!slope.slope || !slope.expected) return;
    std::vector<const SizePoint*> points;
    for (const SizePoint& point : series.points) {
        const bool on_ladder = std::any_of(slopes.sizes.begin(), slopes.sizes.end(), [&](const auto& size) {
            return size.evaluations == point.found->evaluations_per_face;
        });
        if (on_ladder) points.push_back(&point);
    }
    if (points.size() < 2) return;
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
}

void add_measured(const studies::StudyPlan& plan, PairClass pair_class, const SizeSeries& series,
                  PictureValues& values) {
    const std::optional<stats::Interval> of_median;  // there is none
    for (const SizePoint& point : series.points) {
        const auto& interval = point.is_median ? of_median : point.found->class_error(pair_class)->interval;
        values.add({series.method, point.is_median ? "median" : "RMSE", size_label(plan, plan.cells[point.found->cell]),
                    point.found->evaluations_per_face, drawn(point.error),
                    interval_end(interval, &stats::Interval::low), interval_end(interval, &stats::Interval::high)});
    }
}

/// Names the lines of methods in colour: those in grey have their names on the buttons below.
void label_errors(const std::vector<SizeSeries>& all, PairClass pair_class, const std::vector<MethodStyle>& styles,
                  PictureValues& values) {
    LineLabels labels(HeightAxis::logarithmic);
    for (const SizeSeries& series : all) {
        for (const SizePoint& point : series.points) {
            labels.make_room(point.error);
            if (point.is_median) continue;
            for (const double end : ends_of(point.found->class_error(pair_class)->interval)) labels.make_room(end);
        }
        if (in_colour(styles, series.method)) labels.add(series.method, series.method, series.points.back().error);
    }
    labels.set(values, style_scales(styles));
}

std::vector<std::size_t> cells_of(const studies::StudyPlan& plan, const std::vector<SizeSeries>& all,
                                  bool deterministic) {
    std::vector<std::size_t> cells;
    for (const SizeSeries& series : all) {
        for (const SizePoint& point : series.points) {
            if (plan.cells[point.found->cell].deterministic == deterministic) cells.push_back(point.found->cell);
        }
    }
    return cells;
}

/// The one error of a deterministic method may be small by luck, so that it is not set against those of samples.
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

Picture convergence_picture(const studies::Analysis& findings, std::size_t scene, PairClass pair_class,
                            const std::vector<SizeSeries>& all, const std::vector<MethodStyle>& styles) {
    PictureValues values({"method", "role", "size", "evaluations", "error", "low", "high"});
    for (const SizeSeries& series : all) {
        add_measured(findings.plan, pair_class, series, values);
        for (const studies::ClassSlopes* slopes : series.ladders) add_expected(series, *slopes, values);
    }
    values.set("isolate", names_of(all));
    label_errors(all, pair_class, styles, values);
    const std::string place = where(findings.plan, scene, pair_class);
    Picture picture;
    picture.id = slug(fmt::format("convergence-{}", place));
    picture.kind = "convergence";
    picture.title = fmt::format("Error against evaluations, {}.", place);
    const std::string smallest = smallest_errors_in_words(findings, all, pair_class);
    picture.finding = fmt::format("{}Bands and bars: {:g} % intervals; dashed: the slope that theory expects.",
                                  smallest, 100 * findings.plan.spec.level);
    picture.description = fmt::format(
        "RMSE of a run on {} against evaluations per face, both logarithmic, with {:g} % intervals, a line for each "
        "method; where the variance is infinite, the median of the absolute error. Thin dashed lines have the slope "
        "that theory expects. {}",
        place, 100 * findings.plan.spec.level, smallest);
    picture.values = values.text();
    return picture;
}

std::optional<Picture> efficiency_picture(const studies::Analysis& findings, std::size_t scene, PairClass pair_class,
                                          const std::vector<SizeSeries>& all, const std::vector<MethodStyle>& styles) {
    PictureValues values({"method", "size", "evaluations", "efficiency", "low", "high"});
    auto names = nlohmann::ordered_json::array();
    std::vector<std::size_t> cells;
    LineLabels labels(HeightAxis::logarithmic);
    const auto efficiency = [&](const studies::CellAnalysis& found) {
        return found.class_error(pair_class)->efficiency;
    };
    for (const SizeSeries& series : all) {
        std::optional<double> last;
        for (const SizePoint& point : series.points) {
            const studies::CellAnalysis& found = *point.found;
            if (!efficiency(found)) continue;
            const studies::ClassError& error = *found.class_error(pair_class);
            values.add({series.method, size_label(findings.plan, findings.plan.cells[found.cell]),
                        found.evaluations_per_face, drawn(error.efficiency),
                        interval_end(error.efficiency_interval, &stats::Interval::low),
                        interval_end(error.efficiency_interval, &stats::Interval::high)});
            cells.push_back(found.cell);
            last = *efficiency(found);
            labels.make_room(*last);
            for (const double end : ends_of(error.efficiency_interval)) labels.make_room(end);
        }
        if (!last) continue;
        names.push_back(series.method);
        if (in_colour(styles, series.method)) labels.add(series.method, series.method, *last);
    }
    if (cells.size() < 2) return std::nullopt;
    values.set("isolate", std::move(names));
    labels.set(values, style_scales(styles));
    const std::string place = where(findings.plan, scene, pair_class);
    Picture picture;
    picture.id = slug(fmt::format("efficiency-{}", place));
    picture.kind = "efficiency";
    picture.title = fmt::format("Efficiency against evaluations, {}.", place);
    const std::string largest = largest_efficiencies(findings, cells, pair_class);
    picture.finding = largest.empty() ? "Bars: intervals." : fmt::format("Per evaluation {}.", largest);
    picture.description = fmt::format(
        "1 / (RMSE² N) of the sampled methods on {} against N, the evaluations for a face, "
        "with {:g} % intervals. {}",
        place, 100 * findings.plan.spec.level, picture.finding);
    picture.values = values.text();
    return picture;
}

}  // namespace

std::vector<Picture> pictures_of_scene(const studies::StudyResults& results, std::size_t scene,
                                       const MethodChoice& methods) {
    const studies::Analysis& findings = results.findings;
    std::vector<Picture> pictures;
    const auto styles = method_styles(results, methods);
    for (const PairClass pair_class : {PairClass::parallel, PairClass::adjacent, PairClass::other}) {
        auto all = size_series(results, scene, pair_class);
        std::erase_if(all, [&](const SizeSeries& series) { return !methods.has(series.method); });
        if (all.empty() || (all.size() == 1 && all.front().points.size() == 1)) continue;  // one point is no picture
        pictures.push_back(convergence_picture(findings, scene, pair_class, all, styles));
        if (auto efficiency = efficiency_picture(findings, scene, pair_class, all, styles))
            pictures.push_back(std::move(*efficiency));
    }
    return pictures;
}

std::vector<Picture> pictures_by_size(const studies::StudyResults& results, const MethodChoice& methods) {
    if (!results.occlusion.empty()) return occlusion_pictures(results, methods);
    std::vector<Picture> pictures;
    for (std::size_t scene = 0; scene < results.findings.plan.scenes.size(); ++scene) {
        for (Picture& picture : pictures_of_scene(results, scene, methods)) pictures.push_back(std::move(picture));
    }
    return pictures;
}

}  // namespace ff::reports
