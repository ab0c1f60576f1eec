#include "reports/tables/tables.hpp"
#include "reports/words/findings/slope_words.hpp"

#include <fmt/format.h>

namespace ff::reports {
namespace {

/// What is faster than theory is marked too: theory does not explain it.
Mark mark_against_theory(const studies::ClassSlopes& found) {
    switch (found.finding) {
        case studies::RateFinding::as_expected:
            return Mark::good;
        case studies::RateFinding::slower:
            return Mark::bad;
        case studies::RateFinding::faster:
            return Mark::surprising;
        case studies::RateFinding::no_theory:
        case studies::RateFinding::no_slope:
            break;
    }
    return Mark::none;
}

}  // namespace

Table slopes_table(const studies::StudyResults& results) {
    const studies::StudyPlan& plan = results.findings.plan;
    Table table{
        "slopes",
        "Slopes of ln(error) on ln(N)",
        fmt::format("± half of the {:g} % interval (bootstrap over trials). Verdicts: Holm over all rows with a "
                    "theory, {:g} % together.",
                    100 * plan.spec.level, 100 * (1 - plan.spec.level)),
        {{"method", false, ""},
         {"sizes", false, ""},
         {"pairs", false, ""},
         {"RMSE", true, ""},
         {"median", true, ""},
         {"theory", false, ""},
         {"verdict", false, ""}},
        {},
        {}};
    for (const studies::LadderSlopes& ladder : results.slopes) {
        const std::string scene = plan.scenes.size() == 1 ? std::string() : plan.scenes[ladder.ladder.scene].name + " ";
        std::string method = scene + ladder.ladder.label;
        std::string sizes = sizes_text(plan, ladder.ladder);
        for (const studies::ClassSlopes& found : ladder.classes) {
            table.rows.push_back({{std::move(method), Mark::none},
                                  {std::move(sizes), Mark::none},
                                  {std::string(name(found.pair_class)), Mark::none},
                                  {slope_text(found.rmse), Mark::none},
                                  {slope_text(found.median), Mark::none},
                                  {expected_text(found.judged()), Mark::none},
                                  {finding_in_words(found), mark_against_theory(found)}});
            method.clear();
            sizes.clear();
        }
    }
    return table;
}

}  // namespace ff::reports
