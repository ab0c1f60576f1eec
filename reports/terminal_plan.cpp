#include "reports/labels.hpp"
#include "reports/table.hpp"
#include "reports/terminal.hpp"
#include "reports/text_table.hpp"
#include "studies/resources.hpp"

#include <fmt/format.h>

namespace ff::reports {
namespace {

std::string seconds_in_words(double seconds) {
    return seconds < 100 ? fmt::format("{:.1f} s", seconds) : fmt::format("{:.1f} min", seconds / 60);
}

}  // namespace

std::string terminal_plan(const studies::StudyPlan& plan, unsigned threads) {
    Table table{"plan",
                "",
                "",
                {{"method", false, ""},
                 {"size", false, ""},
                 {"trials", true, ""},
                 {"samples/trial", true, ""},
                 {"core time", true, ""}},
                {},
                {}};
    double total = 0;
    for (const studies::Cell& cell : plan.cells) {
        const double seconds = static_cast<double>(cell.trials) * studies::expected_seconds_per_trial(plan, cell);
        total += seconds;
        table.rows.push_back({{plan.spec.methods[cell.method].name, Mark::none},
                              {size_label(plan, cell), Mark::none},
                              {std::to_string(cell.trials), Mark::none},
                              {std::to_string(studies::evaluations_per_trial(plan, cell)), Mark::none},
                              {seconds_in_words(seconds), Mark::none}});
    }
    const double expected = total / threads + studies::expected_seconds_of_results(plan);
    return fmt::format("{}: {} work units\n\n{}\nabout {} on {} thread{}\n", plan.spec.name, plan.units.size(),
                       text_table(table, Colour::none), seconds_in_words(expected), threads, threads == 1 ? "" : "s");
}

}  // namespace ff::reports
