#include "reports/csv/csv.hpp"

#include "reports/csv/csv_records.hpp"
#include "reports/json/json_records.hpp"

#include <fmt/format.h>

#include <cmath>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace ff::reports {
namespace {

using studies::StudyPlan;

constexpr std::string_view system_columns = "study,scene,method,patches_per_face,samples_per_patch,between";

/// Three columns: NAME_least, NAME_median, NAME_largest.
std::string columns_of(std::string_view name) {
    return fmt::format("{0}_least={0}/least,{0}_median={0}/median,{0}_largest={0}/largest", name);
}

/// Calls `row` for every setting, with the record that identifies it: study .. trials.
template <class Row>
void for_each_setting(const studies::StudyResults& results, const Row& row) {
    const StudyPlan& plan = results.findings.plan;
    for (const studies::radiosity::Consequences& found : results.radiosity->consequences) {
        for (const studies::radiosity::SettingStatistics& at : found.settings) {
            row(in_cell(plan, found.cell,
                        {{"between", studies::radiosity::name(found.between)},
                         {"treatment", studies::radiosity::name(found.treatment)},
                         {"reflectance", plan.spec.radiosity->reflectance[at.setting]},
                         {"trials", at.trials}}),
                found, at);
        }
    }
}

/// Calls `row` for every solver of every system, with its record.
template <class Row>
void for_each_solver(const studies::StudyResults& results, const Row& row) {
    const StudyPlan& plan = results.findings.plan;
    const auto add = [&](Json record, const std::vector<studies::radiosity::SolverStatistics>& solvers) {
        for (const auto& found : solvers) {
            record.update(solver_json(found));
            row(record, found);
        }
    };
    for (const studies::radiosity::ExactSystem& system : results.radiosity->exact) {
        Json record = exact_json(plan, system);
        record.update({{"study", plan.spec.name}, {"method", nullptr}, {"samples_per_patch", nullptr}});
        record["between"] = studies::radiosity::name(system.m == 0 ? studies::radiosity::Between::faces
                                                                   : studies::radiosity::Between::patches);
        add(std::move(record), system.solvers);
    }
    for_each_setting(results, [&](const Json& record, const auto&, const auto& at) { add(record, at.solvers); });
}

/// Whether an iteration is among those that are written: all of the first 20, then some 20 a power of ten.
bool is_written(std::size_t iteration, std::size_t last) {
    if (iteration <= 20 || iteration == last) return true;
    const auto step = [](std::size_t i) { return std::floor(20 * std::log10(static_cast<double>(i))); };
    return step(iteration) > step(iteration - 1);
}

}  // namespace

void write_matrices_csv(std::ostream& out, const studies::StudyResults& results) {
    CsvRecords csv(
        out, fmt::format("{},treatment,trials,not_balanced,{},{},{},{},{},{}", system_columns,
                         columns_of("closure_defect"), columns_of("reciprocity_defect"), columns_of("correction"),
                         columns_of("factor_error"), columns_of("dominant_below"), columns_of("convergent_below")));
    const StudyPlan& plan = results.findings.plan;
    for (const studies::radiosity::Consequences& found : results.radiosity->consequences)
        csv.add(in_cell(plan, found.cell, consequences_json(plan, found)));
}

void write_systems_csv(std::ostream& out, const studies::StudyResults& results) {
    CsvRecords csv(out, fmt::format("{},treatment,reflectance,trials,dominant,convergent,divergent,singular,negative,"
                                    "{},spectral_radius_uncertainty,{},{},light_error",
                                    system_columns, columns_of("spectral_radius"), columns_of("condition"),
                                    columns_of("energy_defect")));
    for_each_setting(results, [&](Json record, const auto& found, const auto& at) {
        record.update(setting_json(results.findings.plan, found, at));
        csv.add(record);
    });
}

void write_exitance_csv(std::ostream& out, const studies::StudyResults& results) {
    CsvRecords csv(out, fmt::format("{},treatment,reflectance,trials,face,row,column,exact,mean,bias,"
                                    "bias_ci_low=bias_interval/low,bias_ci_high=bias_interval/high,"
                                    "interval_method=bias_interval/method,level=bias_interval/level,std,rmse,q025,"
                                    "median,q975",
                                    system_columns));
    for_each_setting(results, [&](Json record, const auto& found, const auto& at) {
        for (const studies::radiosity::ExitanceStatistics& element : at.exitance) {
            record.update(exitance_json(results.findings.plan, found, element));
            csv.add(record);
        }
    });
}

void write_solvers_csv(std::ostream& out, const studies::StudyResults& results) {
    CsvRecords csv(out, fmt::format("{},reflectance,solver,runs,converged,diverged,stalled,exhausted,{},flops",
                                    system_columns, columns_of("iterations")));
    for_each_solver(results, [&](const Json& record, const auto&) { csv.add(record); });
}

void write_residuals_csv(std::ostream& out, const studies::StudyResults& results) {
    CsvRecords csv(out, fmt::format("{},reflectance,solver,iteration,residual", system_columns));
    for_each_solver(results, [&](Json record, const studies::radiosity::SolverStatistics& found) {
        for (std::size_t i = 0; i < found.residuals.size(); ++i) {
            if (!is_written(i, found.residuals.size() - 1)) continue;
            record["iteration"] = i;
            record["residual"] = found.residuals[i];
            csv.add(record);
        }
    });
}

}  // namespace ff::reports
