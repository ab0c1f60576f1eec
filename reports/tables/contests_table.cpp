#include "reports/tables/tables.hpp"
#include "reports/text/labels.hpp"
#include "reports/text/numbers.hpp"

#include "studies/comparison/decisions.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace ff::reports {
namespace {

using studies::Contest;
using studies::Equal;

/// "evaluations", "processor time"
std::string_view in_words(Equal equal) {
    switch (equal) {
        case Equal::evaluations:
            return "equal evaluations";
        case Equal::processor_time:
            return "equal processor time";
        case Equal::error:
            break;
    }
    return "equal error";
}

/// The method; with its patches where it enters with several numbers of them.
std::string name_of(const studies::StudyPlan& plan, const Contest& contest, std::size_t entrant) {
    const studies::Cell& cell = plan.cells[contest.entrants[entrant].cell];
    const std::string& name = plan.spec.methods[cell.method].name;
    const auto same = std::count_if(contest.entrants.begin(), contest.entrants.end(),
                                    [&](const auto& other) { return plan.cells[other.cell].method == cell.method; });
    if (same == 1) return name;
    const auto patches = cell.subdivision.per_part();
    return fmt::format("{} ({} {})", name, patches, patches == 1 ? "patch" : "patches");
}

/// "b  2.31 [2.10, 2.55]": the group, and the ratio to the first.
std::string standing(const Contest& contest, std::size_t entrant) {
    const char group = static_cast<char>('a' + std::min<std::size_t>(contest.entrants[entrant].group, 25));
    if (entrant == 0) return fmt::format("{}  1", group);
    const auto found = std::find_if(contest.handicaps.begin(), contest.handicaps.end(), [&](const auto& handicap) {
        return handicap.better == 0 && handicap.worse == entrant;
    });
    // Trials of microseconds tell no time: their intervals go over many decades.
    if (found->interval && found->interval->high > 1e4 * found->interval->low && contest.equal == Equal::processor_time)
        return fmt::format("{}  too short to time", group);
    return fmt::format(
        "{}  {}", group,
        found->interval ? with_ends(found->ratio, found->interval->low, found->interval->high) : brief(found->ratio));
}

std::vector<std::string> names_of_exact(const studies::StudyPlan& plan, const Contest& contest) {
    std::vector<std::string> names;
    for (const std::size_t cell : contest.exact) names.push_back(plan.spec.methods[plan.cells[cell].method].name);
    return names;
}

/// What each method does in a contest, as in a cell of the table; those that are exact come first.
std::vector<std::pair<std::string, std::string>> standings(const studies::StudyPlan& plan, const Contest& contest) {
    std::vector<std::pair<std::string, std::string>> all;
    for (std::string& method : names_of_exact(plan, contest)) all.emplace_back(std::move(method), "a  exact");
    for (std::size_t i = 0; i < contest.entrants.size(); ++i)
        all.emplace_back(name_of(plan, contest, i), standing(contest, i));
    return all;
}

/// The quantity that is equal in a table with room for one comparison.
Equal equal_for_one(const studies::StudyResults& results, bool timed) {
    const bool measured = timed && !studies::main_contests(results.contests, Equal::processor_time).empty();
    return measured ? Equal::processor_time : Equal::evaluations;
}

/// What it takes to tell the first two of each class of pairs apart; empty where that is done.
std::string what_would_tell(const studies::StudyResults& results) {
    std::vector<std::string> all;
    for (const Contest* contest : studies::main_contests(results.contests, Equal::evaluations)) {
        for (const studies::Handicap& handicap : contest->handicaps) {
            if (!contest->exact.empty() || handicap.better != 0 || handicap.worse != 1 || !handicap.times_trials)
                continue;
            all.push_back(fmt::format("{} times the trials on {} pairs", brief(*handicap.times_trials, 2),
                                      name(contest->pair_class)));
        }
    }
    if (all.empty()) return {};
    return fmt::format(
        "To show which of the first two is better at equal evaluations would take {}, if their ratio is "
        "as measured.",
        listed(all));
}

constexpr std::string_view measured_elsewhere =
    "What methods do in equal processor time differs from run to run: the run printed it, and "
    "comparisons_by_time.csv has it.";

/// The table for a study with one scene.
Table side_by_side(const studies::StudyResults& results, bool timed) {
    const studies::StudyPlan& plan = results.findings.plan;
    Table table{"side-by-side", "Methods side by side",
                "How many times the smallest mean square error each method makes at equal cost, and how many times the "
                "least evaluations it takes to an equal error. Methods that are not shown to differ from the first of "
                "their group share its letter.",
                columns({"method", "pairs"})};
    std::vector<std::vector<const Contest*>> columns;
    for (const Equal equal : {Equal::evaluations, Equal::processor_time, Equal::error}) {
        if (equal == Equal::processor_time && !timed) continue;
        auto contests = studies::main_contests(results.contests, equal);
        if (contests.empty()) continue;
        table.columns.push_back(
            {fmt::format("relative {} at {}", equal == Equal::error ? "evaluations" : "MSE", in_words(equal)), false,
             "", equal == Equal::error});
        columns.push_back(std::move(contests));
    }
    if (columns.empty()) return table;
    for (const Contest* lead : columns.front()) {
        std::vector<std::string> budgets;
        std::vector<const Contest*> contests;
        for (const auto& column : columns) {
            const auto found = std::find_if(column.begin(), column.end(), [&](const Contest* contest) {
                return contest->pair_class == lead->pair_class;
            });
            contests.push_back(found == column.end() ? nullptr : *found);
            if (contests.back() != nullptr)
                budgets.push_back(budget_label(contests.back()->equal, contests.back()->budget));
        }
        std::set<std::string> seen;
        for (const Contest* contest : contests) {
            if (contest == nullptr) continue;
            for (const auto& [method, unused] : standings(plan, *contest)) {
                if (!seen.insert(method).second) continue;
                std::vector<TableCell> row{method, name(lead->pair_class)};
                for (const Contest* column : contests) {
                    std::string text = "–";
                    if (column != nullptr) {
                        for (const auto& [other, standing] : standings(plan, *column)) {
                            if (other == method) text = standing;
                        }
                    }
                    row.push_back(text);
                }
                table.rows.push_back(std::move(row));
            }
        }
        table.remarks.push_back(
            fmt::format("On {} pairs methods are compared {}.", name(lead->pair_class), listed(budgets)));
    }
    const bool some_exact = std::any_of(results.contests.begin(), results.contests.end(),
                                        [](const Contest& contest) { return !contest.exact.empty(); });
    if (some_exact) table.remarks.emplace_back("exact: to rounding. Ratios are to the best of the others.");
    table.remarks.push_back(
        fmt::format("Intervals of level {:g} hold together for all pairs of methods, sizes and classes of pairs in a "
                    "column, of a scene (Bonferroni). All of them: comparisons.csv.",
                    plan.spec.level));
    if (std::string takes = what_would_tell(results); !takes.empty()) table.remarks.push_back(std::move(takes));
    if (!timed) table.remarks.emplace_back(measured_elsewhere);
    if (timed && studies::main_contests(results.contests, Equal::processor_time).empty())
        table.remarks.emplace_back("No processor time was measured of these trials.");
    return table;
}

/// The table for a study with several scenes: the best methods of each scene.
Table best_of_scenes(const studies::StudyResults& results, Equal equal) {
    const studies::StudyPlan& plan = results.findings.plan;
    Table table{"best-of-scenes", fmt::format("The best methods of each scene, at {}", in_words(equal)),
                "Methods that are exact to rounding, or else those that are not shown to be worse than the one with "
                "the smallest mean square error; and the first that is: how many times as large its mean square error "
                "is.",
                columns({"scene", "~pairs", "~kind", "best", "~next"})};
    for (const Contest* contest : studies::main_contests(results.contests, equal)) {
        std::vector<std::string> best = names_of_exact(plan, *contest);
        for (std::string& method : best) method += " (exact)";
        std::string next = best.empty() ? "–" : name_of(plan, *contest, 0);
        for (std::size_t i = 0; i < contest->entrants.size(); ++i) {
            if (contest->entrants[i].group == 0) best.push_back(name_of(plan, *contest, i));
            if (contest->entrants[i].group > 0 && next == "–")
                next = fmt::format("{}: {}", name_of(plan, *contest, i), standing(*contest, i).substr(3));
        }
        const Scene& scene = plan.scenes[contest->scene];
        table.rows.push_back({plan.scenes.name(contest->scene), std::string(name(contest->pair_class)),
                              std::string(kind_in_words(studies::pair_kind(scene, contest->pair_class))), listed(best),
                              next});
    }
    return table;
}

}  // namespace

Table contests_table(const studies::StudyResults& results, bool timed) {
    if (results.findings.plan.scenes.size() == 1) return side_by_side(results, timed);
    return best_of_scenes(results, equal_for_one(results, timed));
}

Table decisions_table(const studies::StudyResults& results, bool timed) {
    const studies::StudyPlan& plan = results.findings.plan;
    const Equal equal = equal_for_one(results, timed);
    Table table{
        "decisions", fmt::format("Which method to take, at {}", in_words(equal)),
        "Of each kind of pairs the methods that are best in the most cases (scenes and classes of pairs): nothing is "
        "shown to have a smaller mean square error, which may be that of rounding. In parentheses in how many of the "
        "cases that they can do (without a variance or a common cost, they are not compared), and how many times the "
        "smallest mean square error they make where they do worst.",
        columns({"pairs", ">cases", "take", "~or"})};
    for (const studies::Decision& decision : studies::decide(plan, results.contests, equal)) {
        // All methods that are best as often as the one at this place.
        const auto alike = [&](std::size_t place) {
            std::vector<std::string> names;
            for (; place < decision.choices.size(); ++place) {
                const studies::Choice& choice = decision.choices[place];
                if (!names.empty() &&
                    (choice.best != decision.choices[place - 1].best || choice.ran != decision.choices[place - 1].ran))
                    break;
                names.push_back(plan.spec.methods[choice.method].name);
            }
            return names;
        };
        const auto text = [&](std::size_t place) -> std::string {
            if (place >= decision.choices.size() || decision.choices[place].best == 0) return "–";
            const studies::Choice& choice = decision.choices[place];
            const auto names = alike(place);
            const std::string worst = names.size() > 1 ? " each"
                                      : choice.ran > choice.entered
                                          ? fmt::format(", not compared in {}", choice.ran - choice.entered)
                                      : std::isfinite(choice.largest_handicap)
                                          ? fmt::format(", at worst {}", brief(choice.largest_handicap, 2))
                                          : ", elsewhere another is exact";
            return fmt::format("{} ({} of {}{})", listed(names), choice.best, choice.ran, worst);
        };
        table.rows.push_back({std::string(kind_in_words(decision.kind)), std::to_string(decision.cases), text(0),
                              text(alike(0).size())});
    }
    if (!timed && !table.rows.empty()) table.remarks.emplace_back(measured_elsewhere);
    return table;
}

Table timed_decisions_table(const studies::StudyResults& results) {
    const studies::StudyPlan& plan = results.findings.plan;
    const auto times = studies::decide_by_time(plan, results.contests);
    Table table{"decisions-by-time", "Which method to take in how much processor time",
                "The methods that are best in the most cases of each kind of pairs when their runs are repeated until "
                "the time is used up; in parentheses of how many cases in which methods can be compared then.",
                columns({"pairs"})};
    std::map<studies::PairKind, std::vector<std::string>> rows;
    for (std::size_t i = 0; i < times.size(); ++i) {
        table.columns.push_back({fmt::format("{:g} s", times[i].seconds), false, "in"});
        for (const studies::Decision& decision : times[i].decisions) {
            std::vector<std::string> names;
            for (const std::size_t method : studies::most_often_best(decision))
                names.push_back(plan.spec.methods[method].name);
            std::vector<std::string>& row = rows[decision.kind];
            row.resize(times.size(), "–");
            if (!names.empty())
                row[i] = fmt::format("{} ({} of {})", listed(names, 2), decision.choices.front().best, decision.cases);
        }
    }
    for (auto& [kind, cells] : rows) {
        std::vector<TableCell> row{std::string(kind_in_words(kind))};
        row.insert(row.end(), cells.begin(), cells.end());
        table.rows.push_back(std::move(row));
    }
    return table;
}

}  // namespace ff::reports
