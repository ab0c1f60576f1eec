#include "studies/claims/error_law.hpp"

#include <cmath>
#include <cstdlib>
#include <map>

namespace ff::studies {
namespace {

using ErrorsByM = std::map<double, std::vector<double>>;

std::optional<ErrorLaw> fit(const std::string& method, bool published, const ErrorsByM& errors) {
    ErrorLaw law;
    law.method = method;
    law.published = published;
    for (const auto& [m, values] : errors) {
        double sum = 0;
        for (const double value : values) sum += value;
        law.m.push_back(m);
        law.closure_errors.push_back(sum / static_cast<double>(values.size()));
    }
    if (law.m.size() < 2) return std::nullopt;
    const auto first_order = stats::fit_power_law(law.m, law.closure_errors, 1.0);
    if (!first_order) return std::nullopt;
    law.first_order = *first_order;
    law.free = stats::fit_power_law(law.m, law.closure_errors);
    return law;
}

bool is_deterministic(const StudySpec& spec, const StudyPlan& plan, const std::string& method) {
    for (const Cell& cell : plan.cells) {
        if (spec.methods[cell.method].name == method) return cell.deterministic;
    }
    return false;
}

}  // namespace

std::vector<ErrorLaw> fit_error_laws(const Analysis& findings, const PublishedTables* tables) {
    const StudyPlan& plan = findings.plan;
    std::vector<ErrorLaw> laws;
    for (std::size_t scene = 0; scene < plan.scenes.size(); ++scene) {
        if (!plan.scenes.is_closed(scene)) continue;
        for (std::size_t method = 0; method < plan.spec.methods.size(); ++method) {
            if (estimator_info(plan.spec.methods[method]).exact) continue;
            ErrorsByM errors;
            for (std::size_t i = 0; i < plan.cells.size(); ++i) {
                const Cell& cell = plan.cells[i];
                if (cell.scene != scene || cell.method != method || !cell.deterministic) continue;
                for (const Summary& summary : findings.cells[i].summaries) {
                    if (summary.quantity.kind == QuantityKind::row_sum)
                        errors[cell.subdivision.m].push_back(*summary.bias);
                }
            }
            const std::string& name = plan.spec.methods[method].name;
            const std::string label = plan.scenes.size() == 1 ? name : plan.scenes.name(scene) + ": " + name;
            if (auto law = fit(label, false, errors)) laws.push_back(std::move(*law));
        }
    }
    if (tables == nullptr) return laws;
    std::map<std::string, ErrorsByM> printed;
    for (const Figure& figure : tables->figures) {
        if (figure.kind != FigureKind::row_sum || !is_deterministic(plan.spec, plan, figure.method)) continue;
        printed[figure.method][std::sqrt(figure.patches_per_face)].push_back(
            std::strtod(figure.printed.c_str(), nullptr) - 1.0);
    }
    for (const auto& [method, errors] : printed) {
        if (auto law = fit(method, true, errors)) laws.push_back(std::move(*law));
    }
    return laws;
}

}  // namespace ff::studies
