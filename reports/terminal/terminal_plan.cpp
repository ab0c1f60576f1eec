#include "reports/terminal/terminal.hpp"
#include "reports/text/labels.hpp"
#include "reports/text/numbers.hpp"
#include "reports/text/table.hpp"
#include "reports/text/text_table.hpp"
#include "studies/results/resources.hpp"

#include <fmt/format.h>

#include <map>
#include <string>
#include <tuple>
#include <vector>

namespace ff::reports {
namespace {

/// What the cells of a method and a size ask for in all scenes.
struct PlanRow {
    std::string method;
    std::string size;
    std::uint64_t trials = 0;  ///< in each scene
    std::size_t scenes = 0;
    std::uint64_t samples = 0;  ///< evaluations in a trial, summed over the scenes
    double seconds = 0;
};

std::vector<PlanRow> plan_rows(const studies::StudyPlan& plan) {
    std::vector<PlanRow> rows;
    std::map<std::tuple<std::string, std::string, std::uint64_t>, std::size_t> known;
    for (const studies::Cell& cell : plan.cells) {
        const std::string& method = plan.spec.methods[cell.method].name;
        const std::string size = size_label(plan, cell);
        const auto [place, is_new] = known.try_emplace({method, size, cell.trials}, rows.size());
        if (is_new) rows.push_back({method, size, cell.trials});
        PlanRow& row = rows[place->second];
        ++row.scenes;
        row.samples += studies::evaluations_per_trial(plan, cell);
        row.seconds += static_cast<double>(cell.trials) * studies::expected_seconds_per_trial(plan, cell);
    }
    return rows;
}

}  // namespace

std::string terminal_plan(const studies::StudyPlan& plan, unsigned threads, const TextStyle& style) {
    const bool several_scenes = plan.scenes.size() > 1;
    Table table{"plan", "", "", columns({"method", "size"})};
    if (several_scenes) table.columns.push_back({"scenes", true});
    for (const char* name : {"trials", "samples/trial", "core time"}) table.columns.push_back({name, true});
    double total = 0;
    for (const PlanRow& row : plan_rows(plan)) {
        total += row.seconds;
        std::vector<TableCell> cells = {row.method, row.size};
        if (several_scenes) cells.push_back(std::to_string(row.scenes));
        for (const std::string& text :
             {std::to_string(row.trials), std::to_string(row.samples), seconds_in_words(row.seconds)}) {
            cells.push_back(text);
        }
        table.rows.push_back(std::move(cells));
    }
    const double expected = total / threads + studies::expected_seconds_of_results(plan);
    return fmt::format("{}: {} work units\n\n{}\nabout {} on {} thread{}\n", plan.spec.name, plan.units.size(),
                       text_table(table, style), seconds_in_words(expected), threads, threads == 1 ? "" : "s");
}

}  // namespace ff::reports
