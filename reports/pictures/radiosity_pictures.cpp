#include "reports/pictures/method_styles.hpp"
#include "reports/pictures/picture_values.hpp"
#include "reports/text/labels.hpp"
#include "reports/text/numbers.hpp"
#include "reports/words/findings/radiosity_words.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <utility>

namespace ff::reports {
namespace {

using studies::StudyPlan;
using studies::radiosity::Consequences;

struct Shown {
    std::string method;
    std::string size;
    studies::radiosity::Treatment treatment;
    bool own = true;  ///< whether the method itself completes the matrix in this way: its line is solid, others dashed
    const Consequences* found;
    std::string label = {};
};

/// The cells that the verdict compares, with each treatment except those that change nothing.
std::vector<Shown> shown_of(const studies::StudyResults& results, std::size_t scene) {
    const StudyPlan& plan = results.findings.plan;
    std::vector<Shown> shown;
    for (const std::size_t cell : lit_cells(plan, scene)) {
        for (const studies::radiosity::Treatment treatment : studies::radiosity::all_treatments) {
            const Consequences* found = results.radiosity->find(cell, treatment);
            const studies::Method& method = plan.spec.methods[plan.cells[cell].method];
            const bool own = treatment == studies::radiosity::treatment_of(method.completion);
            if (found->settings.empty()) continue;
            if (!own && treatment != studies::radiosity::Treatment::balanced) continue;
            shown.push_back({method.name, size_label(plan, plan.cells[cell]), treatment, own, found});
        }
    }
    for (Shown& each : shown) {
        const bool several = std::any_of(shown.begin(), shown.end(), [&](const Shown& other) {
            return other.method == each.method && other.size != each.size;
        });
        each.label = each.method + (several ? ", " + each.size : "") + (each.own ? "" : ", balanced");
    }
    return shown;
}

/// The reflectance that all faces share; empty where they differ.
std::optional<double> same_everywhere(const StudyPlan& plan, std::size_t setting) {
    const auto& reflectance = plan.spec.radiosity->reflectance[setting];
    return reflectance.size() == 1 ? std::optional(reflectance.front()) : std::nullopt;
}

constexpr const char* dashes_in_words = "Dashed: after the matrix is balanced.";

std::optional<Picture> errors_picture(const studies::StudyResults& results, std::size_t scene,
                                      const std::vector<Shown>& shown) {
    const StudyPlan& plan = results.findings.plan;
    PictureValues values(
        {"method", "size", "treatment", "own", "reflectance", "absorbed", "rmse", "low", "high", "bias", "negative"});
    MethodLines lines(method_styles(results), HeightAxis::logarithmic);
    double largest = 0;
    std::string where;
    for (const Shown& each : shown) {
        lines.begin(each.method, each.label);
        for (const studies::radiosity::SettingStatistics& at : each.found->settings) {
            const auto reflectance = same_everywhere(plan, at.setting);
            if (!reflectance || at.exitance.empty()) continue;
            const double rmse = at.light_error.value_or(0);
            if (rmse < 1e-11) continue;  // rounding, or no mean
            values.add({each.method, each.size, studies::radiosity::name(each.treatment), each.own, drawn(reflectance),
                        drawn(1 - *reflectance), drawn(rmse), drawn_low(at.light_interval),
                        drawn_high(at.light_interval), drawn(*at.exitance.front().bias / at.exitance.front().exact),
                        at.negative});
            lines.add(rmse, at.light_interval);
            if (rmse <= largest) continue;
            largest = rmse;
            where = setting_text(plan, at.setting);
        }
    }
    if (where.empty()) return std::nullopt;
    lines.set(values);
    return picture_of(values, "light_errors", fmt::format("light-errors{}", of_scene(plan, scene)),
                      fmt::format("How the exitance error grows with reflectance{}.", of_scene(plan, scene)),
                      fmt::format("Errors reach {}, at reflectance {}. {} Bars: {:g} % intervals.", percent(largest),
                                  where, dashes_in_words, 100 * plan.spec.level),
                      "Relative RMSE of the exitance, over faces and runs, against the reflectance, both axes "
                      "logarithmic (in 1 − reflectance), a line for each method as it completes its matrix, and one "
                      "after the matrix is balanced.");
}

std::optional<Picture> radius_picture(const studies::StudyResults& results, std::size_t scene,
                                      const std::vector<Shown>& shown) {
    const StudyPlan& plan = results.findings.plan;
    PictureValues values({"method", "size", "treatment", "own", "reflectance", "radius", "least", "largest"});
    MethodLines lines(method_styles(results), HeightAxis::linear);
    lines.make_room(1);
    double limit = 1;
    for (const Shown& each : shown) {
        lines.begin(each.method, each.label);
        for (const studies::radiosity::SettingStatistics& at : each.found->settings) {
            const auto reflectance = same_everywhere(plan, at.setting);
            if (!reflectance) continue;
            const auto& radius = at.spectral_radius;
            values.add({each.method, each.size, studies::radiosity::name(each.treatment), each.own, drawn(reflectance),
                        drawn(radius.median, 8), drawn(radius.least, 8), drawn(radius.largest, 8)});
            lines.make_room(radius.least);
            lines.make_room(radius.largest);
            lines.add(radius.median);
        }
        limit = std::min(limit, each.found->convergent_below.least);
    }
    if (values.empty()) return std::nullopt;
    lines.set(values);
    const std::string reach = limit < 1 - 1e-12
                                  ? fmt::format("In some run it reaches 1 at reflectance {}.", brief(limit, 4))
                                  : "It stays below 1 for every reflectance below 1, whatever the method.";
    return picture_of(values, "spectral_radius", fmt::format("spectral-radius{}", of_scene(plan, scene)),
                      fmt::format("Spectral radius against reflectance{}.", of_scene(plan, scene)),
                      fmt::format("{} {}", reach, dashes_in_words),
                      "Spectral radius of P F, median and range over runs, against the reflectance of all faces, with "
                      "the line above which iterations diverge.");
}

/// Some iterations of a long history: all at the start, then ever fewer.
bool is_drawn(std::size_t iteration, std::size_t last) {
    if (iteration <= 10 || iteration == last) return true;
    std::size_t step = 1;
    while (iteration / step >= 10) step *= 2;
    return iteration % step == 0;
}

std::optional<Picture> residuals_picture(const studies::StudyResults& results, std::size_t scene) {
    const StudyPlan& plan = results.findings.plan;
    PictureValues values({"system", "solver", "iteration", "residual"});
    auto systems = Json::array();
    std::set<std::string> failed;
    const auto add = [&](const std::string& label, const std::vector<studies::radiosity::SolverStatistics>& solvers) {
        if (solvers.empty()) return;
        systems.push_back(label);
        for (const studies::radiosity::SolverStatistics& found : solvers) {
            if (found.solver == Solver::lu) continue;
            if (found.diverged > 0) failed.insert(label);
            for (std::size_t i = 0; i < found.residuals.size(); ++i) {
                if (found.residuals[i] > 0 && is_drawn(i, found.residuals.size() - 1))
                    values.add({label, ff::name(found.solver), i, drawn(found.residuals[i], 3)});
            }
        }
    };
    for (const studies::radiosity::ExactSystem& system : results.radiosity->exact) {
        if (system.scene == scene && system.m == 0)
            add(fmt::format("exact factors, reflectance {}", setting_text(plan, system.setting)), system.solvers);
    }
    for (const std::size_t cell : lit_cells(plan, scene)) {
        const auto own = studies::radiosity::treatment_of(plan.spec.methods[plan.cells[cell].method].completion);
        const Consequences* found = results.radiosity->find(cell, own);
        for (const studies::radiosity::SettingStatistics& at : found->settings) {
            add(fmt::format("{}, reflectance {}", cell_label(plan, plan.cells[cell]), setting_text(plan, at.setting)),
                at.solvers);
        }
    }
    if (values.empty()) return std::nullopt;
    const std::size_t count = systems.size();
    values.set("choose", {{"signal", "system"}, {"label", "System"}, {"values", std::move(systems)}});
    return picture_of(
        values, "residuals", fmt::format("residuals{}", of_scene(plan, scene)),
        fmt::format("Residual histories{}.", of_scene(plan, scene)),
        failed.empty() ? fmt::format("No solver diverges on any of the {} systems.", count)
                       : fmt::format("Some solver diverges on {} of the {} systems: {}.", failed.size(), count,
                                     fmt::join(failed, "; ")),
        "Largest residual against iteration, a line for each solver, on the first trial of the chosen system.");
}

}  // namespace

std::optional<PictureGroup> radiosity_pictures(const studies::StudyResults& results) {
    if (!results.radiosity) return std::nullopt;
    PictureGroup group{"What the errors do to the light", true, {}};
    for (std::size_t scene = 0; scene < results.findings.plan.scenes.size(); ++scene) {
        const auto shown = shown_of(results, scene);
        for (auto& picture : {errors_picture(results, scene, shown), radius_picture(results, scene, shown),
                              residuals_picture(results, scene)}) {
            if (picture) group.pictures.push_back(*picture);
        }
        for (Picture& picture : exitance_pictures(results, scene)) group.pictures.push_back(std::move(picture));
    }
    return group;
}

}  // namespace ff::reports
