#include "reports/comparison/run_comparison.hpp"

#include "reports/comparison/comparison_words.hpp"
#include "reports/comparison/equal_cost.hpp"
#include "reports/html/html_view.hpp"
#include "reports/markdown/markdown_text.hpp"
#include "reports/templates/mustache.hpp"
#include "reports/text/json_values.hpp"
#include "reports/text/labels.hpp"
#include "reports/text/numbers.hpp"
#include "reports/text/text_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string_view>
#include <vector>

namespace ff::reports {
namespace {

using studies::CellComparison;
using studies::Likeness;
using studies::RunComparison;

/// "186 tests, 5 % together", or what replaces it.
std::string tests_in_words(const RunComparison& comparison) {
    if (comparison.tests == 0) return "no tests";
    return fmt::format("{}, {:g} % together", counted(comparison.tests, "test"), 100 * (1 - comparison.level));
}

std::string plain_rmse(const studies::CellAnalysis& found, PairClass pair_class) {
    const auto rmse = found.class_rmse(pair_class);
    return rmse ? fmt::format("{:.2e}", *rmse) : "infinite";
}

std::string trials_text(const RunComparison& comparison, const CellComparison& cell) {
    const auto a = comparison.first.cells[cell.first].trials;
    const auto b = comparison.second.cells[cell.second].trials;
    return a == b ? std::to_string(a) : fmt::format("{} | {}", a, b);
}

Table cells_table(const RunComparison& comparison) {
    const studies::StudyPlan& plan = comparison.first.plan;
    Table table{
        "runs",
        "Method by method",
        "RMSE of a run against the exact form factors, where they are known." +
            (comparison.tests == 0
                 ? std::string()
                 : fmt::format(" Verdicts: means by Welch's t, standard deviations by intervals of the logarithm of "
                               "their ratio, on every distinct pair, RMSEs likewise; {} (Holm); in parentheses what is "
                               "found with power {:g}.",
                               tests_in_words(comparison), comparison.power)),
        {{"method"},
         {"size"},
         {"trials", true},
         {"pairs"},
         {comparison.names[0], true, "RMSE"},
         {comparison.names[1], true, "RMSE"},
         {"verdict"}}};
    for (const CellComparison& compared : comparison.cells) {
        const studies::Cell& cell = plan.cells[compared.first];
        TableCell method{scene_and_method(comparison, compared)};
        TableCell size{size_label(plan, cell)};
        TableCell trials{trials_text(comparison, compared)};
        TableCell verdict = likeness_in_words(comparison, compared);
        for (const studies::RmseRatio& ratio : compared.ratios) {
            table.rows.push_back(
                {std::exchange(method, {}), std::exchange(size, {}), std::exchange(trials, {}), name(ratio.pair_class),
                 plain_rmse(comparison.first.cells[compared.first], ratio.pair_class),
                 plain_rmse(comparison.second.cells[compared.second], ratio.pair_class), std::exchange(verdict, {})});
        }
        if (compared.ratios.empty()) table.rows.push_back({method, size, trials, "–", "–", "–", verdict});
    }
    return table;
}

/// A value of a study file: for a long one the part around the first difference, for the text of a scene its length.
std::string shown(const std::string& value, const std::string& other) {
    constexpr std::size_t longest = 60;
    constexpr std::size_t before = 20;
    if (value.empty()) return "–";
    if (value.size() <= longest) return value;
    if (value.find('\n') != std::string::npos) return fmt::format("{} characters", value.size());
    const auto is_within_character = [&](std::size_t at) { return at < value.size() && (value[at] & 0xc0) == 0x80; };
    const auto same = std::mismatch(value.begin(), value.end(), other.begin(), other.end()).first - value.begin();
    std::size_t begin = std::max(static_cast<std::size_t>(same), before) - before;
    std::size_t end = std::min(begin + longest, value.size());
    while (begin > 0 && is_within_character(begin)) --begin;
    while (is_within_character(end)) ++end;
    return fmt::format("{}{}{}", begin > 0 ? "…" : "", value.substr(begin, end - begin), end < value.size() ? "…" : "");
}

Table differences_table(const RunComparison& comparison) {
    Table table{"studies",
                "What the study files say differently",
                "",
                {{"where"}, {"key"}, {comparison.names[0]}, {comparison.names[1]}}};
    for (const auto& [place, key, first, second] : comparison.differences) {
        table.rows.push_back({place, key, shown(first, second), shown(second, first)});
    }
    return table;
}

void add_unmatched(const studies::Analysis& findings, const std::vector<std::size_t>& cells, std::string_view run,
                   std::vector<std::string>& lines) {
    if (!findings.complete) lines.push_back(fmt::format("{} is partial: some of its trials are missing.", run));
    if (findings.plan.spec.until)
        lines.push_back(
            fmt::format("{} is adaptive: the number of its trials follows from their spread, and error rates "
                        "are approximate.",
                        run));
    if (cells.empty()) return;
    std::vector<std::string> labels;
    for (const std::size_t cell : cells) labels.push_back(cell_label(findings.plan, findings.plan.cells[cell]));
    lines.push_back(fmt::format("Only {} has {}.", run, fmt::join(labels, "; ")));
}

/// Sizes have the same numbers, which count rays of a patch in one method and points of a pair of patches in another.
std::string costs_in_words(const RunComparison& comparison) {
    if (comparison.lead_at_equal_evaluations().compared > 0) return {};  // a table of its own says more
    for (const CellComparison& compared : comparison.cells) {
        const studies::Cell& first = comparison.first.plan.cells[compared.first];
        const studies::Cell& second = comparison.second.plan.cells[compared.second];
        const auto a = studies::evaluations_per_trial(comparison.first.plan, first);
        const auto b = studies::evaluations_per_trial(comparison.second.plan, second);
        if (a == b) continue;
        return fmt::format(
            "Methods are compared at sizes of the same number, not at the same cost: with {} a trial takes {} "
            "evaluations in {} and {} in {}.",
            size_label(comparison.first.plan, first), a, comparison.names[0], b, comparison.names[1]);
    }
    return {};
}

std::vector<std::string> remarks(const RunComparison& comparison) {
    std::vector<std::string> lines;
    for (const studies::ChangedScene& scene : comparison.changed_scenes) {
        lines.push_back(scene.difference.empty()
                            ? fmt::format("Scene '{}' is not the same in both runs, but its faces are.", scene.name)
                            : fmt::format("Scene '{}' has other faces in each run ({}): not compared.", scene.name,
                                          scene.difference));
    }
    // Of two methods without a common size nothing is missing.
    const bool by_size = !comparison.cells.empty();
    add_unmatched(comparison.first, by_size ? comparison.only_first : std::vector<std::size_t>(), comparison.names[0],
                  lines);
    add_unmatched(comparison.second, by_size ? comparison.only_second : std::vector<std::size_t>(), comparison.names[1],
                  lines);
    if (std::string costs = costs_in_words(comparison); !costs.empty()) lines.push_back(std::move(costs));
    return lines;
}

/// "halton: study shallow_box, seed 1"
std::string description(const RunComparison& comparison, std::size_t run) {
    const studies::StudySpec& spec = (run == 0 ? comparison.first : comparison.second).plan.spec;
    return fmt::format("{}: study {}, seed {}", comparison.names.at(run), spec.name, spec.seed.value);
}

/// Which run is better, and by how much; empty where no RMSE is compared.
std::string answer(const RunComparison& comparison, const studies::Lead& lead) {
    const auto& [first, second] = comparison.names;
    const std::string_view what = comparison.bouts.empty() ? "run" : "method";
    if (lead.compared == 0) return {};
    const auto range = [](const stats::Interval& interval) {
        return fmt::format("{} to {}", brief(interval.low), brief(interval.high));
    };
    if (lead.first + lead.second == 0) {
        return fmt::format("Neither {} is shown to be better: the RMSE of {} is {} times that of {}{}. ", what, second,
                           range(*lead.ratios), first,
                           lead.compared == 1 ? "" : fmt::format(" in each of {} comparisons", lead.compared));
    }
    if (lead.first > 0 && lead.second > 0) {
        return fmt::format("Neither {} is better throughout: of {} RMSEs {} smaller in {}, and {} in {}. ", what,
                           lead.compared, fmt::format("{} {}", lead.first, lead.first == 1 ? "is" : "are"), first,
                           lead.second, second);
    }
    const bool first_leads = lead.first > 0;
    const std::string& better = first_leads ? first : second;
    const std::size_t led = lead.first + lead.second;
    std::string where = fmt::format(" in {} of {} comparisons (no difference shown in the others)", led, lead.compared);
    if (led == lead.compared) where = led == 1 ? "" : fmt::format(" in all {} comparisons", led);
    if (!lead.decided) return fmt::format("{} is better: it is exact{}. ", better, where);
    return fmt::format("{} is better: its RMSE is {} times smaller than that of {}{}. ", better, range(*lead.decided),
                       first_leads ? second : first, where);
}

/// The same, of two methods at equal evaluations where they are compared so.
std::string answer_at_equal_cost(const RunComparison& comparison) {
    const studies::Lead lead = comparison.lead_at_equal_evaluations();
    if (lead.compared == 0) return answer(comparison, comparison.lead());
    return "At equal evaluations: " + answer(comparison, lead);
}

std::string verdict(const RunComparison& comparison) {
    const std::size_t untestable = comparison.count(Likeness::untestable);
    const std::size_t different = comparison.count(Likeness::different);
    std::string said = answer_at_equal_cost(comparison);
    if (comparison.cells.empty()) {
        if (said.empty()) return "The methods have no cost in common at which both have an error.";
        said.pop_back();  // the blank
        return said;
    }
    if (comparison.cells.size() == 1)
        return fmt::format("{}The only method and size in both runs {}.", said,
                           different == 1    ? "differs"
                           : untestable == 1 ? "cannot be tested"
                                             : "shows no difference");
    return fmt::format("{}Of the {} methods and sizes in both runs, {} {}{}.", said, comparison.cells.size(),
                       different == 0 ? "none" : std::to_string(different), different > 1 ? "differ" : "differs",
                       untestable == 0 ? "" : fmt::format("; {} cannot be tested", untestable));
}

/// Those that have rows.
std::vector<Table> tables_of(const RunComparison& comparison) {
    std::vector<Table> tables{equal_cost_table(comparison), cells_table(comparison), differences_table(comparison)};
    std::erase_if(tables, [](const Table& table) { return table.rows.empty(); });
    return tables;
}

}  // namespace

std::string comparison_text(const RunComparison& comparison, const TextStyle& style) {
    std::string out =
        fmt::format("{}\n{}\n\n{}\n\n", description(comparison, 0), description(comparison, 1), verdict(comparison));
    if (const std::string plot = ratio_plot(comparison); !plot.empty()) out += plot + '\n';
    bool begins = true;
    for (const Table& table : tables_of(comparison)) {
        // The first table needs no title where it is the one of methods.
        if (!begins || table.id != "runs") out += fmt::format("{}{}\n", begins ? "" : "\n", table.title);
        out += text_table(table, style);
        begins = false;
    }
    const auto lines = remarks(comparison);
    if (!lines.empty()) out += fmt::format("\n{}\n", fmt::join(lines, "\n"));
    if (comparison.cells.empty()) return out;
    return out + fmt::format("\n{}{}\n", tests_in_words(comparison),
                             comparison.tests == 0 ? "" : "; intervals hold together too");
}

std::string comparison_markdown(const RunComparison& comparison) {
    std::string out = fmt::format("# Two runs side by side\n\n**{}**\n\n- {}\n- {}\n\n", verdict(comparison),
                                  description(comparison, 0), description(comparison, 1));
    if (const std::string plot = ratio_plot(comparison); !plot.empty()) out += fmt::format("```\n{}```\n\n", plot);
    for (const Table& table : tables_of(comparison)) {
        out += fmt::format("## {}\n\n", table.title);
        if (!table.note.empty()) out += table.note + "\n\n";
        out += markdown_table(table);
    }
    for (const std::string& line : remarks(comparison)) out += fmt::format("- {}\n", line);
    return out;
}

std::string comparison_json(const RunComparison& comparison) {
    const studies::StudyPlan& plan = comparison.first.plan;
    auto cells = Json::array();
    for (const CellComparison& compared : comparison.cells) {
        const studies::Cell& cell = plan.cells[compared.first];
        auto ratios = Json::array();
        for (const studies::RmseRatio& ratio : compared.ratios) {
            ratios.push_back({{"pairs", name(ratio.pair_class)},
                              {"first", ratio.first},
                              {"second", ratio.second},
                              {"ratio", optional_json(ratio.ratio)},
                              {"interval", interval_json(ratio.interval)},
                              {"adjusted_p", ratio.adjusted_p}});
        }
        cells.push_back({{"scene", plan.scenes.name(cell.scene)},
                         {"method", method_names(comparison, compared)},
                         {"size", size_label(plan, cell)},
                         {"verdict", likeness_in_words(comparison, compared).text},
                         {"differs", compared.likeness == Likeness::different},
                         {"testable", compared.likeness != Likeness::untestable},
                         {"rmse", std::move(ratios)}});
    }
    const Json whole{{"schema", "ffstudy.comparison/1"},
                     {"runs", comparison.names},
                     {"verdict", verdict(comparison)},
                     {"level", comparison.level},
                     {"tests", comparison.tests},
                     {"cells", std::move(cells)},
                     {"equal_cost", equal_cost_json(comparison)},
                     {"remarks", remarks(comparison)}};
    return whole.dump(2);
}

std::string comparison_html(const RunComparison& comparison, const Templates& templates) {
    Json tables = Json::array();
    for (const Table& table : tables_of(comparison)) tables.push_back(table_view(table));
    const std::vector<std::string_view> styles{templates.text("report.css")};
    return fill_template(templates, "comparison",
                         {{"policy", security_policy(styles, {})},
                          {"style", templates.text("report.css")},
                          {"first", description(comparison, 0)},
                          {"second", description(comparison, 1)},
                          {"verdict", verdict(comparison)},
                          {"forest", ratio_plot(comparison)},
                          {"tables", std::move(tables)},
                          {"remarks", texts_view(remarks(comparison))}},
                         escape_html);
}

}  // namespace ff::reports
