#include "reports/tables/tables.hpp"

#include "reports/text/labels.hpp"
#include "reports/text/numbers.hpp"
#include "reports/words/findings/radiosity_words.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <functional>
#include <utility>

namespace ff::reports {
namespace {

using studies::radiosity::Consequences;

/// The cells that name a row: method and size.
std::vector<TableCell> row_of(const studies::StudyPlan& plan, std::size_t index) {
    return {method_label(plan, plan.cells[index]), size_label(plan, plan.cells[index])};
}

using studies::radiosity::Between;

/// Tables of systems between patches have titles and ids of their own.
std::string title_of(Between between, const std::string& title) {
    return between == Between::faces ? title : title + ", between patches";
}
std::string id_of(Between between, const std::string& id) {
    return between == Between::faces ? id : id + "-patches";
}

Table matrices_table(const studies::StudyResults& results, Between between) {
    const studies::StudyPlan& plan = results.findings.plan;
    Table table{
        id_of(between, "radiosity-matrices"), title_of(between, "What is wrong with the matrices"),
        "Median over trials, in brackets the range. Closure defect: largest |row sum − 1|. Reciprocity defect: largest "
        "|F_ij − F_ji A_j / A_i|. Correction: largest change of a factor by the treatment. Error: root mean "
        "square over pairs against the exact factors. The last two columns are reflectances, the same "
        "everywhere, below which I − P F is strictly diagonally dominant, and the spectral radius of P F below 1; "
        "above 1 they hold for every surface.",
        columns({"method", "size (patches per face)", "treatment", ">closure defect", ">reciprocity defect",
                 ">correction", ">error", ">dominant below", ">convergent below"})};
    for (const Consequences& found : results.radiosity->consequences) {
        if (found.between != between) continue;
        if (found.trials == 0) continue;
        auto row = row_of(plan, found.cell);
        row.push_back(studies::radiosity::name(found.treatment));
        for (const auto* range :
             {&found.closure_defect, &found.reciprocity_defect, &found.correction, &found.factor_error})
            row.push_back(over_trials_text(*range, found.trials, 2));
        for (const auto* range : {&found.dominant_below, &found.convergent_below}) {
            row.push_back(
                {over_trials_text(*range, found.trials, 5), range->least < 1 - 1e-12 ? Mark::bad : Mark::good});
        }
        table.rows.push_back(std::move(row));
        if (found.not_balanced > 0) {
            table.remarks.push_back(fmt::format("{}: {} of {} trials have no closed reciprocal matrix near.",
                                                cell_label(plan, plan.cells[found.cell]), found.not_balanced,
                                                found.not_balanced + found.trials));
        }
    }
    return table;
}

/// The cells and the reflectance whose rows are shown.
using IsShown = std::function<bool(std::size_t cell, std::size_t setting)>;

Table exitance_table(const studies::StudyResults& results, Between between, const IsShown& is_shown) {
    const studies::StudyPlan& plan = results.findings.plan;
    Table table{
        id_of(between, "radiosity-exitance"), title_of(between, "Exitance errors"),
        fmt::format("Dominant: trials in which I − P F is strictly diagonally dominant. Spectral radius of P F, "
                    "condition of I − P F (1-norm, estimated) and energy lost (share of the emitted power that "
                    "nothing absorbs; negative: energy created): medians and ranges over trials. Mean "
                    "exitance: of all {0} by area, relative to that with exact factors; ± half of its {1:g} % "
                    "interval. Error of the light: root mean square over trials and {0}, relative to "
                    "the mean exact exitance; at the worst: relative to its own. Negative light: trials "
                    "with a negative exitance. Where some of several trials are not convergent, the "
                    "exitance passes a pole and has no mean.",
                    studies::radiosity::name(between), 100 * plan.spec.level),
        columns({"method", "~size (patches per face)", "treatment", ">reflectance", ">exitance error",
                 between == Between::patches ? ">~on the worst patch" : ">~on the worst face",
                 ">~bias of mean exitance", ">~energy lost (%)", ">~dominant", ">~spectral radius", ">~condition",
                 ">~negative light"})};
    for (const Consequences& found : results.radiosity->consequences) {
        if (found.between != between) continue;
        for (const studies::radiosity::SettingStatistics& at : found.settings) {
            if (!is_shown(found.cell, at.setting)) continue;
            auto row = row_of(plan, found.cell);
            row.push_back(studies::radiosity::name(found.treatment));
            row.push_back(setting_text(plan, at.setting));
            const Mark mark = at.negative > 0 ? Mark::bad : Mark::none;
            row.push_back({at.light_error ? percent(*at.light_error) : "–", mark});
            const auto* worst = worst_element(at);
            row.push_back({worst == nullptr ? "–"
                                            : fmt::format("{} ({})", percent(relative_error(*worst)),
                                                          element_text(plan, found, worst->element)),
                           mark});
            row.push_back({at.exitance.empty() ? "singular" : bias_text(at.exitance.front()), mark});
            const auto& lost = at.energy_defect;
            row.push_back(
                lost ? over_trials_text({100 * lost->least, 100 * lost->median, 100 * lost->largest}, at.trials, 2)
                     : "–");
            row.push_back(
                {fmt::format("{} of {}", at.dominant, at.trials), at.dominant < at.trials ? Mark::bad : Mark::good});
            row.push_back({over_trials_text(at.spectral_radius, at.trials, 5),
                           at.convergent < at.trials ? Mark::bad : Mark::none});
            row.push_back(over_trials_text(at.condition, at.trials, 3));
            row.push_back({at.negative == 0 ? "" : fmt::format("{} of {}", at.negative, at.trials), mark});
            table.rows.push_back(std::move(row));
        }
    }
    return table;
}

TableCell solver_cell(const studies::radiosity::SolverStatistics& found) {
    return {iterations_text(found), found.converged == found.runs ? Mark::none : Mark::bad};
}

Table solvers_table(const studies::StudyResults& results, Between between) {
    const studies::StudyPlan& plan = results.findings.plan;
    const std::uint64_t trials = plan.spec.radiosity->solver_trials;
    Table table{id_of(between, "radiosity-solvers"), title_of(between, "How many iterations solvers take"),
                fmt::format("Until the largest |e − G m| is {:g} of the largest emission, from m = e: sweeps over all "
                            "{}, or n shots; {}, as each method is completed. Flops: solvers.csv.",
                            plan.spec.radiosity->tolerance, studies::radiosity::name(between),
                            between == Between::patches
                                ? std::string("the first trial")
                                : fmt::format("median and range over the first {} trials at most", trials)),
                columns({"method", "size (patches per face)", ">reflectance"})};
    for (const Solver solver : all_solvers) {
        if (solver != Solver::lu) table.columns.push_back({std::string(ff::name(solver)), true, "iterations"});
    }
    const auto add = [&](std::vector<TableCell> row, std::size_t setting,
                         const std::vector<studies::radiosity::SolverStatistics>& solvers) {
        if (solvers.empty()) return;
        row.push_back(setting_text(plan, setting));
        for (const studies::radiosity::SolverStatistics& found : solvers) {
            if (found.solver != Solver::lu) row.push_back(solver_cell(found));
        }
        table.rows.push_back(std::move(row));
    };
    for (const studies::radiosity::ExactSystem& system : results.radiosity->exact) {
        if ((system.m != 0) != (between == Between::patches)) continue;
        const std::string size = system.m == 0 ? "–" : std::to_string(system.m * system.m);
        add({scene_prefix(plan, system.scene) + "exact factors", size}, system.setting, system.solvers);
    }
    for (const Consequences& found : results.radiosity->consequences) {
        if (found.between != between) continue;
        for (const studies::radiosity::SettingStatistics& at : found.settings)
            add(row_of(plan, found.cell), at.setting, at.solvers);
    }
    return table;
}

Table bias_order_table(const studies::StudyResults& results) {
    const studies::StudyPlan& plan = results.findings.plan;
    Table table{"radiosity-bias", "The bias of the exitance",
                fmt::format("Of the mean exitance of all faces, relative, at each size; and N times that, which stays "
                            "where the bias is of order 1/N, N evaluations for a face. Slope of ln |bias| on ln N with "
                            "its {:g} % interval, where the bias is beyond three standard errors at every size.",
                            100 * plan.spec.level),
                columns({"ladder", "treatment", ">reflectance", ">N", ">bias", ">N × bias", ">slope"})};
    for (const studies::radiosity::BiasOrder& order : results.bias_orders) {
        std::vector<std::string> sizes, biases, products;
        for (const auto& point : order.points) {
            sizes.push_back(fmt::format("{:.0f}", point.evaluations));
            biases.push_back(percent_with_half_width(point.bias, point.error));
            products.push_back(brief(point.evaluations * point.bias, 2));
        }
        const std::string slope = order.slope ? fmt::format("{:.2f} [{:.2f}, {:.2f}]", *order.slope,
                                                            order.interval->low, order.interval->high)
                                              : "–";
        table.rows.push_back({scene_prefix(plan, order.scene) + order.label, studies::radiosity::name(order.treatment),
                              setting_text(plan, order.setting), fmt::format("{}", fmt::join(sizes, "; ")),
                              fmt::format("{}", fmt::join(biases, "; ")), fmt::format("{}", fmt::join(products, "; ")),
                              slope});
    }
    return table;
}

}  // namespace

Table told_light_table(const studies::StudyResults& results) {
    if (!results.radiosity) return {};
    const studies::StudyPlan& plan = results.findings.plan;
    const auto cells = all_lit_cells(plan);
    const std::size_t told = told_setting(plan);
    Table table = exitance_table(results, Between::faces, [&](std::size_t cell, std::size_t setting) {
        return setting == told && std::ranges::find(cells, cell) != cells.end();
    });
    table.id = "told-light";
    table.title = fmt::format("Exitance errors at reflectance {}", setting_text(plan, told));
    table.note = fmt::format(
        "Exitance error: root mean square over trials and faces, relative to the mean exact "
        "exitance; on the worst face: relative to its own. Bias: of the mean exitance of all "
        "faces by area, ± half of its {:g} % interval. Other reflectances and columns: below.",
        100 * plan.spec.level);
    return with_columns(std::move(table),
                        {"method", "treatment", "exitance error", "on the worst face", "bias of mean exitance"});
}

std::vector<Table> radiosity_tables(const studies::StudyResults& results) {
    if (!results.radiosity) return {};
    std::vector<Table> tables;
    for (const Between between : {Between::faces, Between::patches}) {
        for (const Table& table : {matrices_table(results, between),
                                   exitance_table(results, between, [](std::size_t, std::size_t) { return true; }),
                                   solvers_table(results, between)}) {
            if (!table.rows.empty()) tables.push_back(table);
        }
    }
    if (!results.bias_orders.empty()) tables.push_back(bias_order_table(results));
    return tables;
}

}  // namespace ff::reports
