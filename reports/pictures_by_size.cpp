#include "reports/labels.hpp"
#include "reports/numbers.hpp"
#include "reports/picture_values.hpp"
#include "reports/pictures.hpp"
#include "reports/slope_words.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace ff::reports {
namespace {

/// A method at one size on a class of pairs.
struct Point {
    const studies::CellFindings* found = nullptr;
    double error = 0;  ///< RMSE of a run; where it does not exist the median of the absolute error
    bool is_median = false;
};

/// A method's sizes on one class of pairs, by ascending number of evaluations, and its ladders.
struct Series {
    std::string method;
    std::vector<Point> points;
    std::vector<const studies::ClassSlopes*> ladders;
};

/// The slopes of a method on a class of pairs.
std::vector<const studies::ClassSlopes*> ladders_of(const studies::StudyResults& results, std::size_t scene,
                                                    std::size_t method, PairClass pair_class) {
    std::vector<const studies::ClassSlopes*> found;
    for (const studies::LadderSlopes& ladder : results.slopes) {
        if (ladder.ladder.scene != scene || ladder.ladder.method != method) continue;
        for (const studies::ClassSlopes& slopes : ladder.classes) {
            if (slopes.pair_class == pair_class) found.push_back(&slopes);
        }
    }
    return found;
}

std::optional<Point> point_of(const studies::CellFindings& found, PairClass pair_class) {
    const studies::ClassError* error = found.class_error(pair_class);
    if (error == nullptr || found.evaluations_per_face == 0) return std::nullopt;
    const bool is_median = found.has_infinite_variance(pair_class);
    const Point point{&found, is_median ? error->median_abs_error : error->rmse, is_median};
    return point.error < studies::rounding_error ? std::nullopt : std::optional(point);
}

std::vector<Series> series_of(const studies::StudyResults& results, std::size_t scene, PairClass pair_class) {
    const studies::Findings& findings = results.findings;
    std::vector<Series> all;
    for (std::size_t method = 0; method < findings.plan.spec.methods.size(); ++method) {
        Series series{findings.plan.spec.methods[method].name, {}, ladders_of(results, scene, method, pair_class)};
        for (const studies::CellFindings& found : findings.cells) {
            const studies::Cell& cell = findings.plan.cells[found.cell];
            if (cell.scene != scene || cell.method != method) continue;
            if (const auto point = point_of(found, pair_class)) series.points.push_back(*point);
        }
        std::stable_sort(series.points.begin(), series.points.end(), [](const Point& a, const Point& b) {
            return a.found->evaluations_per_face < b.found->evaluations_per_face;
        });
        if (!series.points.empty()) all.push_back(std::move(series));
    }
    return all;
}

/// The method, with its slope where it has one ladder.
std::string legend_of(const Series& series) {
    if (series.ladders.size() != 1) return series.method;
    const studies::Slope& slope = series.ladders.front()->judged();
    if (!slope.slope) return series.method;
    const std::string theory = slope.expected ? fmt::format(" (theory {})", expected_text(slope)) : "";
    return fmt::format("{}: {}{}{}", series.method, series.points.front().is_median ? "median, " : "",
                       slope_text(slope), theory);
}

std::string where(const studies::StudyPlan& plan, std::size_t scene, PairClass pair_class) {
    const std::string of_scene = plan.scenes.size() == 1 ? "" : fmt::format(" of {}", plan.scenes[scene].name);
    return fmt::format("{} pairs{}", name(pair_class), of_scene);
}

nlohmann::ordered_json names_of(const std::vector<Series>& all) {
    auto names = nlohmann::ordered_json::array();
    for (const Series& series : all) names.push_back(series.method);
    return names;
}

nlohmann::ordered_json interval_end(const std::optional<stats::Interval>& interval, double stats::Interval::*end) {
    return interval ? drawn((*interval).*end) : nlohmann::ordered_json();
}

/// The two ends of a line with the slope that theory allows, through the middle of the points of a ladder.
void add_expected(const Series& series, const studies::ClassSlopes& slopes, PictureValues& values) {
    const studies::Slope& slope = slopes.judged();
    if (!slope.slope || !slope.expected) return;
    std::vector<const Point*> points;
    for (const Point& point : series.points) {
        const bool on_ladder = std::any_of(slopes.sizes.begin(), slopes.sizes.end(), [&](const auto& size) {
            return size.evaluations == point.found->evaluations_per_face;
        });
        if (on_ladder) points.push_back(&point);
    }
    if (points.size() < 2) return;
    const auto log_size = [](const Point& point) {
        return std::log(static_cast<double>(point.found->evaluations_per_face));
    };
    double mean_size = 0;
    double mean_error = 0;
    for (const Point* point : points) {
        mean_size += log_size(*point) / static_cast<double>(points.size());
        mean_error += std::log(point->error) / static_cast<double>(points.size());
    }
    for (const Point* end : {points.front(), points.back()}) {
        const double error = std::exp(mean_error + slopes.judged().slowest_expected * (log_size(*end) - mean_size));
        values.add(
            {series.method, "expected", "", end->found->evaluations_per_face, drawn(error, 4), nullptr, nullptr});
    }
}

void add_measured(const studies::StudyPlan& plan, PairClass pair_class, const Series& series, PictureValues& values) {
    for (const Point& point : series.points) {
        const auto interval = point.is_median ? std::nullopt : point.found->class_error(pair_class)->interval;
        values.add({series.method, point.is_median ? "median" : "RMSE", size_label(plan, plan.cells[point.found->cell]),
                    point.found->evaluations_per_face, drawn(point.error),
                    interval_end(interval, &stats::Interval::low), interval_end(interval, &stats::Interval::high)});
    }
}

/// The point with the smallest RMSE; of medians where there is no other.
const Point& least_error(const std::vector<Series>& all) {
    const Point* best = &all.front().points.front();
    for (const Series& series : all) {
        for (const Point& point : series.points) {
            if (std::pair(point.is_median, point.error) < std::pair(best->is_median, best->error)) best = &point;
        }
    }
    return *best;
}

Picture convergence_picture(const studies::Findings& findings, std::size_t scene, PairClass pair_class,
                            const std::vector<Series>& all) {
    PictureValues values({"method", "role", "size", "evaluations", "error", "low", "high"});
    auto labels = nlohmann::ordered_json::object();
    for (const Series& series : all) {
        labels[series.method] = legend_of(series);
        add_measured(findings.plan, pair_class, series, values);
        for (const studies::ClassSlopes* slopes : series.ladders) add_expected(series, *slopes, values);
    }
    values.set("isolate", names_of(all));
    values.set("signals", {{"labels", std::move(labels)}});
    const Point& best = least_error(all);
    const std::string place = where(findings.plan, scene, pair_class);
    Picture picture;
    picture.id = slug(fmt::format("convergence-{}", place));
    picture.kind = "convergence";
    picture.title = fmt::format("Error against evaluations, {}.", place);
    picture.finding =
        fmt::format("Of what is not exact to rounding, {} errs least: {} {} in a run of {} evaluations.",
                    cell_label(findings.plan, findings.plan.cells[best.found->cell]),
                    best.is_median ? "median error" : "RMSE", brief(best.error), best.found->evaluations_per_face);
    picture.description = fmt::format(
        "RMSE of a run on {} against evaluations for a face, both logarithmic, with {:g} % intervals, a line for each "
        "method; where the variance is infinite, the median of the absolute error. Thin dashed lines have the slope "
        "that theory expects; the legend has the measured slopes, ± half of their intervals. {}",
        place, 100 * findings.plan.spec.level, picture.finding);
    picture.values = values.text();
    return picture;
}

std::optional<Picture> efficiency_picture(const studies::Findings& findings, std::size_t scene, PairClass pair_class,
                                          const std::vector<Series>& all) {
    PictureValues values({"method", "size", "evaluations", "efficiency", "low", "high"});
    auto names = nlohmann::ordered_json::array();
    const studies::CellFindings* best = nullptr;
    const studies::CellFindings* least = nullptr;
    const auto efficiency = [&](const studies::CellFindings& found) {
        return found.class_error(pair_class)->efficiency;
    };
    for (const Series& series : all) {
        bool any = false;
        for (const Point& point : series.points) {
            const studies::CellFindings& found = *point.found;
            if (!efficiency(found)) continue;
            const studies::ClassError& error = *found.class_error(pair_class);
            values.add({series.method, size_label(findings.plan, findings.plan.cells[found.cell]),
                        found.evaluations_per_face, drawn(error.efficiency),
                        interval_end(error.efficiency_interval, &stats::Interval::low),
                        interval_end(error.efficiency_interval, &stats::Interval::high)});
            if (best == nullptr || *efficiency(found) > *efficiency(*best)) best = &found;
            if (least == nullptr || *efficiency(found) < *efficiency(*least)) least = &found;
            any = true;
        }
        if (any) names.push_back(series.method);
    }
    if (best == nullptr) return std::nullopt;
    values.set("isolate", std::move(names));
    const std::string place = where(findings.plan, scene, pair_class);
    Picture picture;
    picture.id = slug(fmt::format("efficiency-{}", place));
    picture.kind = "efficiency";
    picture.title = fmt::format("Efficiency against evaluations, {}.", place);
    picture.finding = fmt::format("Per evaluation {} achieves most, {} times as much as {}.",
                                  cell_label(findings.plan, findings.plan.cells[best->cell]),
                                  brief(*efficiency(*best) / *efficiency(*least)),
                                  cell_label(findings.plan, findings.plan.cells[least->cell]));
    if (best == least) picture.finding = fmt::format("The efficiency is {}.", brief(*efficiency(*best)));
    picture.description = fmt::format(
        "1 / (RMSE² N) of the sampled methods on {} against N, the evaluations for a face, "
        "with {:g} % intervals. {}",
        place, 100 * findings.plan.spec.level, picture.finding);
    picture.values = values.text();
    return picture;
}

}  // namespace

std::vector<Picture> pictures_by_size(const studies::StudyResults& results) {
    const studies::Findings& findings = results.findings;
    std::vector<Picture> pictures;
    for (std::size_t scene = 0; scene < findings.plan.scenes.size(); ++scene) {
        for (const PairClass pair_class : {PairClass::parallel, PairClass::adjacent, PairClass::other}) {
            const auto all = series_of(results, scene, pair_class);
            if (all.empty()) continue;
            pictures.push_back(convergence_picture(findings, scene, pair_class, all));
            if (auto efficiency = efficiency_picture(findings, scene, pair_class, all))
                pictures.push_back(std::move(*efficiency));
        }
    }
    return pictures;
}

}  // namespace ff::reports
