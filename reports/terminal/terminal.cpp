#include "reports/terminal/terminal.hpp"

#include "reports/tables/tables.hpp"
#include "reports/terminal/gates_terminal.hpp"
#include "reports/text/labels.hpp"
#include "reports/text/numbers.hpp"
#include "reports/text/table.hpp"
#include "reports/text/text_plot.hpp"
#include "reports/text/text_table.hpp"
#include "reports/words/answer.hpp"
#include "reports/words/findings/coverage_words.hpp"
#include "reports/words/findings/occlusion_words.hpp"
#include "reports/words/findings/radiosity_words.hpp"
#include "reports/words/findings/verdicts.hpp"
#include "reports/words/in_brief.hpp"
#include "reports/words/published_words.hpp"
#include "reports/words/sizes.hpp"
#include "studies/results/resources.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>
#include <tuple>
#include <utility>
#include <vector>

namespace ff::reports {
namespace {

/// The work of the cells with one method and size in all scenes.
struct PlanRow {
    std::string method;
    std::string size;
    std::uint64_t trials = 0;  ///< trials in each scene
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

/// More rows than this nobody reads in a terminal; a file has them all.
constexpr std::size_t most_rows = 100;

/// The table, or where its rows are if it is long.
std::string table_or_place(const Table& table, std::string_view file, const TextStyle& style) {
    if (table.rows.empty()) return {};
    return table.rows.size() <= most_rows || style.is_endless()
               ? text_table(table, style)
               : fmt::format("({} rows: {})\n", table.rows.size(), file);
}

/// Nothing for a table without rows.
std::string titled(const Table& table, std::string_view file, const TextStyle& style) {
    if (table.rows.empty()) return {};
    return fmt::format("\n{}\n{}", table.title, table_or_place(table, file, style));
}

std::string terminal_slopes(const studies::StudyResults& results, const TextStyle& style) {
    if (results.slopes.empty()) return {};
    return fmt::format("\nSlopes of ln(error) on ln(N), ± half of the {:g} % interval\n{}",
                       100 * results.findings.plan.spec.level,
                       table_or_place(slopes_table(results), "slopes.csv", style));
}

/// More series than this would be unreadable: then only the best and the worst are drawn.
constexpr std::size_t at_most = 6;
constexpr std::size_t best_of_many = 3;

constexpr std::size_t widest = 56;
constexpr std::size_t margin = 12;  // room for the labels of a y axis
constexpr std::size_t narrowest = margin + 20;

PlottedSeries plotted(const SizeSeries& series) {
    PlottedSeries letters{series.method + (series.points.front().is_median ? " (median)" : ""), {}};
    for (const SizePoint& point : series.points)
        letters.points.emplace_back(static_cast<double>(point.found->evaluations_per_face), point.error);
    return letters;
}

std::string plot_of(const studies::StudyPlan& plan, std::size_t scene, PairClass pair_class,
                    std::vector<SizeSeries> all, const TextStyle& style) {
    std::string which;
    if (all.size() > at_most) {
        // The single error of a deterministic method may be small by luck.
        std::erase_if(
            all, [&](const SizeSeries& series) { return plan.cells[series.points.back().found->cell].deterministic; });
    }
    if (all.size() > at_most) {
        which = fmt::format(" (of {1} sampled methods those whose lines end lowest, {0}, and highest)", best_of_many,
                            all.size());
        std::ranges::stable_sort(all, {}, [](const SizeSeries& series) { return series.points.back().error; });
        all.erase(all.begin() + best_of_many, all.end() - 1);
    }
    std::vector<PlottedSeries> letters;
    for (const SizeSeries& series : all) letters.push_back(plotted(series));
    const std::string plot = text_plot(letters, std::min(widest, std::max(style.width, narrowest) - margin));
    if (plot.empty()) return {};
    return fmt::format("\nRMSE of a run against evaluations per face, {} pairs{}{}\n{}", name(pair_class),
                       of_scene(plan, scene), which, plot);
}

/// Error against evaluations, drawn with letters, where a class of pairs has two ladders or more; only the best and the
/// worst of more than six. A terminal shows no more than six such pictures below each other.
std::string terminal_plots(const studies::StudyResults& results, const TextStyle& style) {
    if (results.slopes.empty()) return {};
    const studies::StudyPlan& plan = results.findings.plan;
    std::vector<std::string> plots;
    for (std::size_t scene = 0; scene < plan.scenes.size(); ++scene) {
        for (const PairClass pair_class : pair_classes) {
            std::vector<SizeSeries> ladders = size_series(results, scene, pair_class);
            std::erase_if(ladders, [](const SizeSeries& s) { return s.ladders.empty() || s.points.size() <= 2; });
            // A single ladder is described by its slope.
            if (ladders.size() > 1) plots.push_back(plot_of(plan, scene, pair_class, std::move(ladders), style));
        }
    }
    std::erase(plots, std::string());
    return plots.size() <= at_most || style.is_endless() ? fmt::format("{}", fmt::join(plots, ""))
                                                         : fmt::format("({} pictures: report.html)\n", plots.size());
}

/// The table with the sentences below it; only these where there are no rows.
std::string explained(const Table& table, std::string_view file, const TextStyle& style) {
    std::string out = titled(table, file, style);
    if (out.empty() && !table.remarks.empty()) out = fmt::format("\n{}\n", table.title);
    for (const std::string& remark : table.remarks) out += remark + "\n";
    return out;
}

/// Two significant digits where nothing is known about the error of the third.
std::string rmse(const studies::StudyPlan& plan, const studies::CellAnalysis& found, PairClass pair_class) {
    const auto value = found.class_rmse(pair_class);
    if (!value) return found.has_infinite_variance(pair_class) ? "infinite" : "-";
    const bool known = plan.cells[found.cell].deterministic || found.class_error(pair_class)->interval;
    return fmt::format("{:.{}e}", *value, known ? 2 : 1);
}

/// The method's name, after that of the scene where there are several.
std::string scene_and_method(const studies::StudyPlan& plan, const studies::CellAnalysis& found) {
    const studies::Cell& cell = plan.cells[found.cell];
    const std::string scene = plan.scenes.size() == 1 ? std::string() : plan.scenes.name(cell.scene) + " ";
    return scene + plan.spec.methods[cell.method].name;
}

/// A row for each method and size that is not hidden.
Table summary_table(const studies::StudyResults& results, const std::set<std::size_t>& hidden) {
    const studies::StudyPlan& plan = results.findings.plan;
    const bool equivalence = plan.spec.equivalence_margin.has_value();
    Table table{"summary",
                "",
                "",
                {{"method"},
                 {"size (patches per face)"},
                 {"trials", true},
                 {"parallel", true, "RMSE of a run"},
                 {"adjacent", true, "RMSE of a run"},
                 {"bias (would detect)"}}};
    if (equivalence) table.columns.push_back({margin_title(plan.spec)});
    for (const studies::CellAnalysis& found : results.findings.cells) {
        if (hidden.contains(found.cell)) continue;
        std::vector<TableCell> row{scene_and_method(plan, found),          size_label(plan, plan.cells[found.cell]),
                                   std::to_string(found.trials),           rmse(plan, found, PairClass::parallel),
                                   rmse(plan, found, PairClass::adjacent), {bias_in_words(found), bias_mark(found)}};
        if (found.lost_rays > 0)
            row.back() = {fmt::format("{} rays LOST; {}", found.lost_rays, row.back().text), Mark::bad};
        if (equivalence) row.push_back({equivalence_in_words(found), equivalence_mark(found.equivalence)});
        table.rows.push_back(std::move(row));
    }
    return table;
}

std::string trials_in_words(const studies::gates::Plan& plan) {
    const auto [least, most] = std::minmax_element(plan.trials.begin(), plan.trials.end());
    const std::string text = *least == *most ? fmt::format("{}", *most) : fmt::format("{}-{}", *least, *most);
    return plan.wanted_trials > 0 ? text + "!" : text;
}

}  // namespace

std::string terminal_plan(const studies::StudyPlan& plan, unsigned threads, const TextStyle& style) {
    const bool several_scenes = plan.scenes.size() > 1;
    Table table{"plan", "", "", columns({"method", "size", ">trials", ">samples/trial", ">core time"})};
    if (several_scenes) table.columns.insert(table.columns.begin() + 2, TableColumn{"scenes", true});
    double total = 0;
    for (const PlanRow& row : plan_rows(plan)) {
        total += row.seconds;
        table.rows.push_back({row.method, row.size, std::to_string(row.trials), std::to_string(row.samples),
                              seconds_in_words(row.seconds)});
        auto& cells = table.rows.back();
        if (several_scenes) cells.insert(cells.begin() + 2, std::to_string(row.scenes));
    }
    const double expected = total / threads + studies::expected_seconds_of_results(plan);
    return fmt::format("{}: {} work units\n\n{}\nabout {} on {}\n", plan.spec.name, plan.units.size(),
                       text_table(table, style), seconds_in_words(expected), counted(threads, "thread"));
}

std::string gates_plan(const studies::gates::Spec& spec, std::span<const studies::gates::EstimatesPlan> files,
                       std::span<const studies::gates::Plan> plans, unsigned threads) {
    std::string out = estimates_plan(spec, files);
    const std::size_t width = name_width(spec);
    double total = 0;
    double most = 0;
    bool capped = false;
    for (const studies::gates::Plan& plan : plans) {
        const studies::gates::Gate& gate = spec.gates[plan.gate];
        const double seconds = expected_seconds(plan);
        const double looks = plan.deterministic ? 1 : static_cast<double>(spec.looks);
        total += seconds;
        most += seconds * looks;
        capped = capped || plan.wanted_trials > 0;
        out += fmt::format("{:<{}}  {:<11}  {:>11}  {:>10}  {:>10}  {}\n", gate.name, width, name(gate.kind),
                           plan.effects.size(), trials_in_words(plan), seconds_in_words(seconds),
                           seconds_in_words(seconds * looks));
    }
    if (capped) out += fmt::format("! more are needed; max_trials allows {} a look\n", spec.max_trials);
    return out + fmt::format("\nabout {} on {}, at most {} ({} looks)\n", seconds_in_words(total / threads),
                             counted(threads, "thread"), seconds_in_words(most / threads), spec.looks);
}

std::string terminal_summary(const studies::StudyResults& results, const TextStyle& style) {
    const studies::StudyPlan& plan = results.findings.plan;
    const std::string title = plan.spec.title == plan.spec.name ? "" : fmt::format(": {}", plan.spec.title);
    const auto hidden = cells_in_between(results);
    std::string out = fmt::format("{}{}\nseed {}{}\n\n{}", plan.spec.name, title, plan.spec.seed.value,
                                  results.findings.complete ? "" : "  (PARTIAL: stopped early)",
                                  table_or_place(summary_table(results, hidden), "summary.csv", style));
    for (const studies::CellAnalysis& found : results.findings.cells) {
        if (found.repeated_trials > 0) out += fmt::format("WARNING {}\n", studies::repeats_in_words(plan, found));
    }
    if (!hidden.empty())
        out += fmt::format("({} sizes{}: summary.csv)\n", hidden.size(),
                           results.occlusion.empty() ? " in between" : " of scenes below");
    out += titled(occlusion_table(results), "summary.csv", style);
    if (results.occlusion.empty()) {
        out += titled(configurations_table(results), "summary.csv", style);
        out += terminal_slopes(results, style);
        out += terminal_plots(results, style);
    }
    for (const auto& lines : {occlusion_in_brief(results), heavy_tails_in_brief(results), reductions_in_brief(results),
                              coverage_in_brief(results), one_run_errors_in_brief(results), radiosity_in_brief(results),
                              until_in_brief(results)}) {
        if (!lines.empty()) out += fmt::format("\n{}\n", fmt::join(lines, "\n"));
    }
    if (results.occlusion.empty()) {
        out += explained(decisions_table(results, true), "results.json", style);
        out += explained(timed_decisions_table(results), "comparisons_by_time.csv", style);
        out += explained(contests_table(results, true), "comparisons.csv", style);
    }
    out += explained(claimed_errors_table(results, Claims::stated), "claimed_errors.csv", style);
    if (results.published) {
        out += fmt::format("\nPublished: {}\n", results.published->tables.source);
        for (const std::string& line : published_in_brief(*results.published, 1 - plan.spec.level))
            out += fmt::format("{}\n", line);
        if (!results.published->tables.figures.empty())
            out += audit_summary(results.published->tables, results.published->audit);
    }
    // Last, since it is what a terminal then shows.
    return out + fmt::format("\n{}\n", answer(results).text);
}

}  // namespace ff::reports
