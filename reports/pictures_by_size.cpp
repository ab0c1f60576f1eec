#include "reports/labels.hpp"
#include "reports/numbers.hpp"
#include "reports/picture_values.hpp"
#include "reports/pictures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace ff::reports {
namespace {

/// A method's sizes on one class of pairs, by ascending number of evaluations.
struct Series {
    std::string method;
    std::vector<const studies::CellFindings*> cells;
};

std::vector<Series> series_of(const studies::Findings& findings, std::size_t scene, PairClass pair_class) {
    std::vector<Series> all;
    for (std::size_t method = 0; method < findings.plan.spec.methods.size(); ++method) {
        Series series{findings.plan.spec.methods[method].name, {}};
        for (const studies::CellFindings& found : findings.cells) {
            const studies::Cell& cell = findings.plan.cells[found.cell];
            const studies::ClassError* error = found.class_error(pair_class);
            if (cell.scene != scene || cell.method != method || error == nullptr || found.evaluations_per_face == 0)
                continue;
            if (error->rmse >= studies::rounding_error) series.cells.push_back(&found);
        }
        std::stable_sort(series.cells.begin(), series.cells.end(), [](const auto* a, const auto* b) {
            return a->evaluations_per_face < b->evaluations_per_face;
        });
        if (!series.cells.empty()) all.push_back(std::move(series));
    }
    return all;
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

/// The cell with the smallest, or largest, of some value.
template <class Value>
const studies::CellFindings* extreme(const std::vector<Series>& all, Value value) {
    const studies::CellFindings* best = nullptr;
    for (const Series& series : all) {
        for (const studies::CellFindings* found : series.cells) {
            if (value(*found) && (best == nullptr || *value(*found) > *value(*best))) best = found;
        }
    }
    return best;
}

Picture convergence_picture(const studies::Findings& findings, std::size_t scene, PairClass pair_class,
                            const std::vector<Series>& all) {
    PictureValues values({"method", "role", "size", "evaluations", "rmse", "low", "high"});
    for (const Series& series : all) {
        for (const studies::CellFindings* found : series.cells) {
            const studies::ClassError& error = *found->class_error(pair_class);
            values.add({series.method, "measured", size_label(findings.plan, findings.plan.cells[found->cell]),
                        found->evaluations_per_face, drawn(error.rmse),
                        interval_end(error.interval, &stats::Interval::low),
                        interval_end(error.interval, &stats::Interval::high)});
        }
    }
    values.set("isolate", names_of(all));
    const auto* best = extreme(
        all, [&](const studies::CellFindings& found) { return std::optional(-found.class_error(pair_class)->rmse); });
    const std::string place = where(findings.plan, scene, pair_class);
    Picture picture;
    picture.id = slug(fmt::format("convergence-{}", place));
    picture.kind = "convergence";
    picture.title = fmt::format("Error against evaluations, {}.", place);
    picture.finding =
        fmt::format("Of what is not exact to rounding, {} errs least: RMSE {} in a run of {} evaluations.",
                    cell_label(findings.plan, findings.plan.cells[best->cell]),
                    brief(best->class_error(pair_class)->rmse), best->evaluations_per_face);
    picture.description = fmt::format(
        "RMSE of a run on {} against evaluations for a face, both logarithmic, with {:g} % "
        "intervals, a line for each method. {}",
        place, 100 * findings.plan.spec.level, picture.finding);
    picture.values = values.text();
    return picture;
}

std::optional<Picture> efficiency_picture(const studies::Findings& findings, std::size_t scene, PairClass pair_class,
                                          const std::vector<Series>& all) {
    const auto efficiency = [&](const studies::CellFindings& found) {
        return found.class_error(pair_class)->efficiency;
    };
    PictureValues values({"method", "size", "evaluations", "efficiency", "low", "high"});
    std::vector<Series> sampled;
    for (const Series& series : all) {
        if (efficiency(*series.cells.front())) sampled.push_back(series);
    }
    for (const Series& series : sampled) {
        for (const studies::CellFindings* found : series.cells) {
            const studies::ClassError& error = *found->class_error(pair_class);
            values.add({series.method, size_label(findings.plan, findings.plan.cells[found->cell]),
                        found->evaluations_per_face, drawn(error.efficiency),
                        interval_end(error.efficiency_interval, &stats::Interval::low),
                        interval_end(error.efficiency_interval, &stats::Interval::high)});
        }
    }
    if (values.empty()) return std::nullopt;
    values.set("isolate", names_of(sampled));
    const auto* best = extreme(sampled, efficiency);
    const auto* least = extreme(sampled, [&](const studies::CellFindings& found) {
        const auto value = efficiency(found);
        return value ? std::optional(-*value) : std::nullopt;
    });
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
            const auto all = series_of(findings, scene, pair_class);
            if (all.empty()) continue;
            pictures.push_back(convergence_picture(findings, scene, pair_class, all));
            if (auto efficiency = efficiency_picture(findings, scene, pair_class, all))
                pictures.push_back(std::move(*efficiency));
        }
    }
    return pictures;
}

}  // namespace ff::reports
