#include "reports/json/json_records.hpp"

#include "reports/text/labels.hpp"
#include "reports/words/findings/radiosity_words.hpp"

#include <string>
#include <vector>

namespace ff::reports {
namespace {

Json range_json(const studies::radiosity::OverTrials& range) {
    return {{"least", finite_json(range.least)},
            {"median", finite_json(range.median)},
            {"largest", finite_json(range.largest)}};
}

Json solvers_json(const std::vector<studies::radiosity::SolverStatistics>& solvers) {
    Json list = Json::array();
    for (const studies::radiosity::SolverStatistics& found : solvers) list.push_back(solver_json(found));
    return list;
}

/// Exitance of all faces together and of each face. Between patches, only that of all together and of the worst patch
/// is given: the rest is in exitance.csv.
Json exitances_json(const studies::StudyPlan& plan, const studies::radiosity::Consequences& of,
                    const studies::radiosity::SettingStatistics& at) {
    Json list = Json::array();
    if (of.between == studies::radiosity::Between::faces) {
        for (const auto& found : at.exitance) list.push_back(exitance_json(plan, of, found));
    } else if (!at.exitance.empty()) {
        list.push_back(exitance_json(plan, of, at.exitance.front()));
        if (const auto* worst = worst_element(at)) list.push_back(exitance_json(plan, of, *worst));
    }
    return list;
}

Json order_json(const studies::StudyPlan& plan, const studies::radiosity::BiasOrder& order) {
    Json points = Json::array();
    for (const auto& point : order.points)
        points.push_back({{"evaluations", point.evaluations}, {"bias", point.bias}, {"error", point.error}});
    return {{"scene", plan.scenes.name(order.scene)},
            {"label", order.label},
            {"treatment", studies::radiosity::name(order.treatment)},
            {"reflectance", plan.spec.radiosity->reflectance[order.setting]},
            {"points", std::move(points)},
            {"slope", optional_json(order.slope)},
            {"interval", interval_json(order.interval)}};
}

}  // namespace

Json solver_json(const studies::radiosity::SolverStatistics& found) {
    return {{"solver", ff::name(found.solver)},
            {"runs", found.runs},
            {"converged", found.converged},
            {"diverged", found.diverged},
            {"stalled", found.stalled},
            {"exhausted", found.exhausted},
            {"iterations", found.iterations ? range_json(*found.iterations) : Json(nullptr)},
            {"flops", optional_json(found.flops)}};
}

Json exitance_json(const studies::StudyPlan& plan, const studies::radiosity::Consequences& of,
                   const studies::radiosity::ExitanceStatistics& found) {
    const studies::Cell& cell = plan.cells[of.cell];
    const Place place = found.element == 0
                            ? Place{"all"}
                            : place_of(plan.scenes[cell.scene], cell.subdivision, of.between, found.element);
    return {{"face", place.face},
            {"row", place.row == 0 ? Json(nullptr) : Json(place.row)},
            {"column", place.column == 0 ? Json(nullptr) : Json(place.column)},
            {"exact", found.exact},
            {"mean", optional_json(found.mean)},
            {"bias", optional_json(found.bias)},
            {"bias_interval", interval_json(found.bias_interval)},
            {"std", optional_json(found.std)},
            {"rmse", optional_json(found.rmse)},
            {"q025", found.q025},
            {"median", found.median},
            {"q975", found.q975}};
}

Json setting_json(const studies::StudyPlan& plan, const studies::radiosity::Consequences& of,
                  const studies::radiosity::SettingStatistics& at) {
    return {{"reflectance", plan.spec.radiosity->reflectance[at.setting]},
            {"dominant", at.dominant},
            {"convergent", at.convergent},
            {"divergent", at.divergent},
            {"singular", at.singular},
            {"negative", at.negative},
            {"spectral_radius", range_json(at.spectral_radius)},
            {"spectral_radius_uncertainty", at.spectral_radius_uncertainty},
            {"condition", range_json(at.condition)},
            {"energy_defect", at.energy_defect ? range_json(*at.energy_defect) : Json(nullptr)},
            {"light_error", optional_json(at.light_error)},
            {"exitance", exitances_json(plan, of, at)},
            {"solvers", solvers_json(at.solvers)}};
}

Json consequences_json(const studies::StudyPlan& plan, const studies::radiosity::Consequences& found) {
    const auto some = [&](const studies::radiosity::OverTrials& range) {
        return found.trials > 0 ? range_json(range) : Json(nullptr);
    };
    Json settings = Json::array();
    for (const auto& at : found.settings) settings.push_back(setting_json(plan, found, at));
    return {{"cell", cell_label(plan, plan.cells[found.cell])},
            {"between", studies::radiosity::name(found.between)},
            {"treatment", studies::radiosity::name(found.treatment)},
            {"trials", found.trials},
            {"not_balanced", found.not_balanced},
            {"closure_defect", some(found.closure_defect)},
            {"reciprocity_defect", some(found.reciprocity_defect)},
            {"correction", some(found.correction)},
            {"factor_error", some(found.factor_error)},
            {"dominant_below", some(found.dominant_below)},
            {"convergent_below", some(found.convergent_below)},
            {"settings", std::move(settings)}};
}

Json exact_json(const studies::StudyPlan& plan, const studies::radiosity::ExactSystem& system) {
    const std::vector<double> exitance(system.exitance.begin(), system.exitance.end());
    return {{"scene", plan.scenes.name(system.scene)},
            {"patches_per_face", system.m == 0 ? Json(nullptr) : Json(system.m * system.m)},
            {"reflectance", plan.spec.radiosity->reflectance[system.setting]},
            {"exitance", exitance},
            {"spectral_radius", system.properties.spectral_radius.middle()},
            {"condition", finite_json(system.properties.condition)},
            {"solvers", solvers_json(system.solvers)}};
}

Json radiosity_json(const studies::StudyResults& results) {
    if (!results.radiosity) return nullptr;
    const studies::StudyPlan& plan = results.findings.plan;
    Json exact = Json::array();
    for (const auto& system : results.radiosity->exact) exact.push_back(exact_json(plan, system));
    Json cells = Json::array();
    for (const auto& found : results.radiosity->consequences) cells.push_back(consequences_json(plan, found));
    Json orders = Json::array();
    for (const auto& order : results.bias_orders) orders.push_back(order_json(plan, order));
    return {{"tolerance", plan.spec.radiosity->tolerance},
            {"exact", std::move(exact)},
            {"consequences", std::move(cells)},
            {"bias_orders", std::move(orders)}};
}

}  // namespace ff::reports
