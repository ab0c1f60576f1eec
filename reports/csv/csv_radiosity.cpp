#include "reports/csv/csv_radiosity.hpp"

#include "reports/csv/csv_field.hpp"
#include "reports/text/numbers.hpp"
#include "reports/words/radiosity_words.hpp"

#include <fmt/format.h>

#include <cmath>
#include <functional>
#include <string>

namespace ff::reports {
namespace {

using studies::StudyPlan;

/// study .. between
std::string system_fields(const StudyPlan& plan, const studies::Consequences& found) {
    const studies::Cell& cell = plan.cells[found.cell];
    return fmt::format("{},{},{},{},{},{}", csv_field(plan.spec.name), csv_field(plan.scenes[cell.scene].name),
                       csv_field(plan.spec.methods[cell.method].name), cell.subdivision.per_part(),
                       cell.samples == 0 ? std::string() : std::to_string(cell.samples), studies::name(found.between));
}

constexpr std::string_view system_columns = "study,scene,method,patches_per_face,samples_per_patch,between";

/// Three columns: label of the face, row and column of the patch.
std::string element_fields(const StudyPlan& plan, const studies::Consequences& found, std::size_t element) {
    if (element == 0) return "all,,";
    const studies::Cell& cell = plan.cells[found.cell];
    const auto place = place_of(plan.scenes[cell.scene], cell.subdivision, found.between, element);
    if (found.between == studies::Between::faces) return csv_field(place.face) + ",,";
    return fmt::format("{},{},{}", csv_field(place.face), place.row, place.column);
}

std::string setting_field(const StudyPlan& plan, std::size_t setting) {
    return fmt::format("{}", fmt::join(plan.spec.radiosity->reflectance[setting], ";"));
}

/// Three columns: name_least, name_median, name_largest.
std::string columns_of(std::string_view name) {
    return fmt::format("{0}_least,{0}_median,{0}_largest", name);
}

std::string fields_of(const std::optional<studies::OverTrials>& range) {
    if (!range) return ",,";
    return fmt::format("{},{},{}", exact(range->least), exact(range->median), exact(range->largest));
}

/// Calls `row` for every list of solvers, with the columns that name it: study .. reflectance.
void for_each_solver(const studies::StudyResults& results,
                     const std::function<void(const std::string&, const studies::SolverFindings&)>& row) {
    const StudyPlan& plan = results.findings.plan;
    for (const studies::ExactSystem& system : results.radiosity->exact) {
        const std::string prefix =
            fmt::format("{},{},,{},,{},{}", csv_field(plan.spec.name), csv_field(plan.scenes[system.scene].name),
                        system.m == 0 ? std::string() : std::to_string(system.m * system.m),
                        studies::name(system.m == 0 ? studies::Between::faces : studies::Between::patches),
                        setting_field(plan, system.setting));
        for (const auto& found : system.solvers) row(prefix, found);
    }
    for (const studies::Consequences& found : results.radiosity->consequences) {
        const std::string cell = system_fields(results.findings.plan, found);
        for (const studies::SettingFindings& at : found.settings) {
            const std::string prefix = fmt::format("{},{}", cell, setting_field(plan, at.setting));
            for (const auto& solver : at.solvers) row(prefix, solver);
        }
    }
}

/// Whether an iteration is among those that are written: all of the first 20, then some 20 a power of ten.
bool is_written(std::size_t iteration, std::size_t last) {
    if (iteration <= 20 || iteration == last) return true;
    const auto step = [](std::size_t i) { return std::floor(20 * std::log10(static_cast<double>(i))); };
    return step(iteration) > step(iteration - 1);
}

}  // namespace

void write_matrices_csv(std::ostream& out, const studies::StudyResults& results) {
    out << fmt::format("{},treatment,trials,not_balanced,{},{},{},{},{},{}\n", system_columns,
                       columns_of("closure_defect"), columns_of("reciprocity_defect"), columns_of("correction"),
                       columns_of("factor_error"), columns_of("dominant_below"), columns_of("convergent_below"));
    for (const studies::Consequences& found : results.radiosity->consequences) {
        const std::string cell = system_fields(results.findings.plan, found);
        const auto some = [&](const studies::OverTrials& range) {
            return fields_of(found.trials > 0 ? std::optional(range) : std::nullopt);
        };
        out << fmt::format("{},{},{},{},{},{},{},{},{},{}\n", cell, studies::name(found.treatment), found.trials,
                           found.not_balanced, some(found.closure_defect), some(found.reciprocity_defect),
                           some(found.correction), some(found.factor_error), some(found.dominant_below),
                           some(found.convergent_below));
    }
}

void write_systems_csv(std::ostream& out, const studies::StudyResults& results) {
    out << fmt::format(
        "{},treatment,reflectance,trials,dominant,convergent,divergent,singular,negative,{},spectral_radius_"
        "uncertainty,"
        "{},{},light_error\n",
        system_columns, columns_of("spectral_radius"), columns_of("condition"), columns_of("energy_defect"));
    for (const studies::Consequences& found : results.radiosity->consequences) {
        const std::string cell = system_fields(results.findings.plan, found);
        for (const studies::SettingFindings& at : found.settings) {
            out << fmt::format("{},{},{},{},{},{},{},{},{},{},{},{},{},{}\n", cell, studies::name(found.treatment),
                               setting_field(results.findings.plan, at.setting), at.trials, at.dominant, at.convergent,
                               at.divergent, at.singular, at.negative, fields_of(at.spectral_radius),
                               exact(at.radius_uncertainty), fields_of(at.condition), fields_of(at.energy_defect),
                               exact(at.light_error));
        }
    }
}

void write_exitance_csv(std::ostream& out, const studies::StudyResults& results) {
    out << system_columns
        << ",treatment,reflectance,trials,face,row,column,exact,mean,bias,bias_ci_low,bias_ci_high,interval_method,"
           "level,std,rmse,q025,median,q975\n";
    const StudyPlan& plan = results.findings.plan;
    for (const studies::Consequences& found : results.radiosity->consequences) {
        const std::string cell = system_fields(results.findings.plan, found);
        for (const studies::SettingFindings& at : found.settings) {
            for (const studies::ExitanceFindings& e : at.exitance) {
                const auto& interval = e.bias_interval;
                out << fmt::format("{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{}\n", cell,
                                   studies::name(found.treatment), setting_field(plan, at.setting), at.trials,
                                   element_fields(plan, found, e.element), exact(e.exact), exact(e.mean), exact(e.bias),
                                   interval ? exact(interval->low) : "", interval ? exact(interval->high) : "",
                                   interval ? interval->method : "", interval ? exact(interval->level) : "",
                                   exact(e.std), exact(e.rmse), exact(e.q025), exact(e.median), exact(e.q975));
            }
        }
    }
}

void write_solvers_csv(std::ostream& out, const studies::StudyResults& results) {
    out << system_columns << ",reflectance,solver,runs,converged,diverged,stalled,exhausted,"
        << columns_of("iterations") << ",flops\n";
    for_each_solver(results, [&](const std::string& prefix, const studies::SolverFindings& found) {
        out << fmt::format("{},{},{},{},{},{},{},{},{}\n", prefix, ff::name(found.solver), found.runs, found.converged,
                           found.diverged, found.stalled, found.exhausted, fields_of(found.iterations),
                           exact(found.flops));
    });
}

void write_residuals_csv(std::ostream& out, const studies::StudyResults& results) {
    out << system_columns << ",reflectance,solver,iteration,residual\n";
    for_each_solver(results, [&](const std::string& prefix, const studies::SolverFindings& found) {
        for (std::size_t i = 0; i < found.residuals.size(); ++i) {
            if (!is_written(i, found.residuals.size() - 1)) continue;
            out << fmt::format("{},{},{},{}\n", prefix, ff::name(found.solver), i, exact(found.residuals[i]));
        }
    });
}

}  // namespace ff::reports
