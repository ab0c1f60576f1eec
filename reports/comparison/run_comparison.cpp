#include "reports/comparison/run_comparison.hpp"

#include "reports/html/html_view.hpp"
#include "reports/html/security_policy.hpp"
#include "reports/markdown/markdown_table.hpp"
#include "reports/templates/mustache.hpp"
#include "reports/text/labels.hpp"
#include "reports/text/numbers.hpp"
#include "reports/text/text_table.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <vector>

namespace ff::reports {
namespace {

using studies::Basis;
using studies::CellComparison;
using studies::Likeness;
using studies::RunComparison;

const Scene& scene_of(const RunComparison& comparison, const CellComparison& cell) {
    const studies::StudyPlan& plan = comparison.first.plan;
    return plan.scenes[plan.cells[cell.first].scene];
}

std::string independent_in_words(const RunComparison& comparison, const CellComparison& cell) {
    const double alpha = 1 - comparison.level;
    const Scene& scene = scene_of(comparison, cell);
    std::vector<std::string> parts;
    if (cell.mean && cell.mean->adjusted_p < alpha) {
        parts.push_back(fmt::format("mean of {} by {:+.1e} ± {:.0e} ({})", quantity_label(scene, cell.mean->pair),
                                    cell.mean->size, cell.mean->error, p_text(cell.mean->adjusted_p)));
    }
    if (cell.spread && cell.spread->adjusted_p < alpha) {
        parts.push_back(fmt::format("standard deviation of {} by a factor {} ({})",
                                    quantity_label(scene, cell.spread->pair), brief(std::sqrt(cell.spread->size), 2),
                                    p_text(cell.spread->adjusted_p)));
    }
    for (const studies::RmseRatio& ratio : cell.ratios) {
        if (ratio.adjusted_p >= alpha) continue;
        parts.push_back(fmt::format("RMSE on {} pairs by a factor {} ({})", name(ratio.pair_class),
                                    brief(ratio.second / ratio.first), p_text(ratio.adjusted_p)));
    }
    if (!parts.empty()) return fmt::format("DIFFERENT: {}", fmt::join(parts, "; "));
    const std::string untested = cell.untestable == 0
                                     ? std::string()
                                     : fmt::format(" on {} of {} pairs", cell.pairs - cell.untestable, cell.pairs);
    return fmt::format("no difference found{} (would detect {} in a mean, a factor {} in a standard deviation)",
                       untested, brief(cell.detectable_difference, 2), brief(cell.detectable_ratio, 2));
}

std::string ratio_text(const studies::RmseRatio& ratio) {
    if (!ratio.ratio) return "–";
    if (!ratio.interval) return brief(*ratio.ratio);
    const double reach = ratio.interval->width() / 2;
    return fmt::format("{} [{}, {}]", to_error(*ratio.ratio, reach), to_error(ratio.interval->low, reach),
                       to_error(ratio.interval->high, reach));
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
        fmt::format("RMSE of a run against the exact form factors. B / A with its {:g} % interval (Student t of "
                    "the logarithm, over trials), each by itself. Verdicts: means by Welch's t, variances by "
                    "Brown and Forsythe, on every distinct pair, RMSEs by that t; {} tests, {:g} % together (Holm); in "
                    "parentheses what is found with power {:g}.",
                    100 * comparison.level, comparison.tests, 100 * (1 - comparison.level), comparison.power),
        {{"method", false, ""},
         {"size", false, ""},
         {"trials", true, ""},
         {"pairs", false, ""},
         {"A", true, "RMSE"},
         {"B", true, "RMSE"},
         {"B / A", false, ""},
         {"verdict", false, ""}},
        {},
        {}};
    for (const CellComparison& compared : comparison.cells) {
        const studies::Cell& cell = plan.cells[compared.first];
        const std::string scene = plan.scenes.size() == 1 ? std::string() : plan.scenes[cell.scene].name + ": ";
        TableCell method{scene + plan.spec.methods[cell.method].name, Mark::none};
        TableCell size{size_label(plan, cell), Mark::none};
        TableCell trials{trials_text(comparison, compared), Mark::none};
        TableCell verdict = likeness_in_words(comparison, compared);
        for (const studies::RmseRatio& ratio : compared.ratios) {
            table.rows.push_back({std::exchange(method, {}),
                                  std::exchange(size, {}),
                                  std::exchange(trials, {}),
                                  {std::string(name(ratio.pair_class)), Mark::none},
                                  {fmt::format("{:.2e}", ratio.first), Mark::none},
                                  {fmt::format("{:.2e}", ratio.second), Mark::none},
                                  {ratio_text(ratio), Mark::none},
                                  std::exchange(verdict, {})});
        }
    }
    return table;
}

Table differences_table(const RunComparison& comparison) {
    Table table{"studies", "What the study files say differently",
                "",        {{"where", false, ""}, {"key", false, ""}, {"A", false, ""}, {"B", false, ""}},
                {},        {}};
    for (const auto& [place, key, first, second] : comparison.differences) {
        table.rows.push_back({{place, Mark::none},
                              {key, Mark::none},
                              {first.empty() ? "–" : first, Mark::none},
                              {second.empty() ? "–" : second, Mark::none}});
    }
    return table;
}

void add_unmatched(const studies::Findings& findings, const std::vector<std::size_t>& cells, std::string_view run,
                   std::vector<std::string>& lines) {
    if (!findings.complete) lines.push_back(fmt::format("{} is partial: it was stopped early.", run));
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

std::vector<std::string> remarks(const RunComparison& comparison) {
    std::vector<std::string> lines;
    add_unmatched(comparison.first, comparison.only_first, "A", lines);
    add_unmatched(comparison.second, comparison.only_second, "B", lines);
    return lines;
}

std::string names(const RunComparison& comparison) {
    const auto one = [](const studies::Findings& findings) {
        return fmt::format("{} (seed {})", findings.plan.spec.name, findings.plan.spec.seed.value);
    };
    return fmt::format("A: {}, B: {}", one(comparison.first), one(comparison.second));
}

std::string verdict(const RunComparison& comparison) {
    const std::size_t untestable = comparison.count(Likeness::untestable);
    return fmt::format("Of {} methods and sizes in both runs {} differ{}.", comparison.cells.size(),
                       comparison.count(Likeness::different),
                       untestable == 0 ? "" : fmt::format("; {} cannot be tested", untestable));
}

}  // namespace

TableCell likeness_in_words(const RunComparison& comparison, const CellComparison& cell) {
    const Mark mark = cell.likeness == Likeness::alike       ? Mark::good
                      : cell.likeness == Likeness::different ? Mark::bad
                                                             : Mark::open;
    switch (cell.basis) {
        case Basis::independent:
            if (cell.likeness == Likeness::untestable) return {"no test: no variance, or too few trials or hits", mark};
            return {independent_in_words(comparison, cell), mark};
        case Basis::same_random_numbers:
            if (cell.likeness == Likeness::untestable) return {"same random numbers, no trial in both", mark};
            if (cell.differing == 0)
                return {fmt::format("the same random numbers, equal in all {} trials", cell.trials), mark};
            return {fmt::format("DIFFERENT: {} of {} trials with the same random numbers", cell.differing, cell.trials),
                    mark};
        case Basis::deterministic:
            if (cell.likeness == Likeness::untestable) return {"not run yet", mark};
            if (cell.likeness == Likeness::alike) return {"equal", mark};
            return {fmt::format("DIFFERENT: {} by {:+.2e}",
                                quantity_label(scene_of(comparison, cell), cell.largest_pair), cell.largest_difference),
                    mark};
        case Basis::mixed:
            break;
    }
    return {"no test: only one of them is random", mark};
}

std::string comparison_text(const RunComparison& comparison, Colour colour) {
    const Table cells = cells_table(comparison);
    std::string out = fmt::format("{}\n\n{}\n", names(comparison), text_table(cells, colour));
    if (!comparison.differences.empty()) {
        const Table differences = differences_table(comparison);
        out += fmt::format("{}\n{}\n", differences.title, text_table(differences, colour));
    }
    for (const std::string& line : remarks(comparison)) out += line + "\n";
    return out + fmt::format("{} ({} tests, {:g} % together)\n", verdict(comparison), comparison.tests,
                             100 * (1 - comparison.level));
}

std::string comparison_markdown(const RunComparison& comparison) {
    std::string out =
        fmt::format("# Two runs side by side\n\n{}\n\n**{}**\n\n", names(comparison), verdict(comparison));
    for (const Table& table : {cells_table(comparison), differences_table(comparison)}) {
        if (table.rows.empty()) continue;
        out += fmt::format("## {}\n\n", table.title);
        if (!table.note.empty()) out += table.note + "\n\n";
        out += markdown_table(table);
    }
    for (const std::string& line : remarks(comparison)) out += fmt::format("- {}\n", line);
    return out;
}

std::string comparison_html(const RunComparison& comparison, const Templates& templates) {
    nlohmann::ordered_json tables = nlohmann::ordered_json::array();
    for (const Table& table : {cells_table(comparison), differences_table(comparison)}) {
        if (!table.rows.empty()) tables.push_back(table_view(table));
    }
    nlohmann::ordered_json lines = nlohmann::ordered_json::array();
    for (const std::string& line : remarks(comparison)) lines.push_back({{"text", line}});
    const std::vector<std::string_view> styles{templates.text("report.css")};
    return fill_template(templates, "comparison",
                         {{"policy", security_policy(styles, {})},
                          {"style", templates.text("report.css")},
                          {"names", names(comparison)},
                          {"verdict", verdict(comparison)},
                          {"tables", std::move(tables)},
                          {"remarks", std::move(lines)}},
                         escape_html);
}

}  // namespace ff::reports
