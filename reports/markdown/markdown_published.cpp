#include "reports/markdown/markdown_sections.hpp"
#include "reports/markdown/markdown_text.hpp"
#include "reports/text/numbers.hpp"
#include "reports/words/published_cells.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>
#include <vector>

namespace ff::reports {
namespace {

using studies::FigureComparison;

std::string table_text(const studies::PublishedResults& published, std::size_t index,
                       const std::set<std::size_t>& blamed, double alpha) {
    const studies::PublishedTable& table = published.tables.tables[index];
    const studies::TableComparison& comparison = published.comparisons[index];
    std::string out = fmt::format("### {}: {}\n\n", markdown_text(table.id), markdown_text(table.title));
    if (!table.note.empty()) out += fmt::format("*{}*\n\n", markdown_text(table.note));
    out += "| |";
    std::string rule = "|---|";
    for (const std::string& column : table.column_titles) {
        out += fmt::format(" {}: printed | ours | where it falls |", markdown_cell(column));
        rule += "--:|--:|:--|";
    }
    out += "\n" + rule + "\n";
    const std::size_t columns = table.column_titles.size();
    std::vector<std::string> above(columns);
    for (std::size_t row = 0; row < table.row_titles.size(); ++row) {
        out += fmt::format("| {} |", markdown_cell(table.row_titles[row]));
        for (std::size_t column = 0; column < columns; ++column) {
            const auto figure = table.figures[row * columns + column];
            if (!figure) {
                out += " | | |";
                above[column].clear();
                continue;
            }
            const auto& c = *std::find_if(comparison.figures.begin(), comparison.figures.end(),
                                          [&](const auto& f) { return f.figure == *figure; });
            const std::string& printed = published.tables.figures[*figure].printed;
            const std::string_view mark = is_surprising(c, alpha) ? "**" : "";
            std::string text = fmt::format(" {}{} | {} | {}{}{} |", printed, blamed.contains(*figure) ? " †" : "",
                                           ours_text(c, printed), mark, place_text(c, printed), mark);
            // A deterministic method treats congruent faces alike: rows and rows of the same figures.
            out += text == above[column] ? std::string(" ″ | ″ | ″ |") : text;
            above[column] = std::move(text);
        }
        out += "\n";
    }
    out += "\n";
    for (const studies::ColumnChiSquared& column : comparison.chi_squared) {
        const auto& chi = column.form.chi_squared;
        const std::size_t fixed = column.figures - std::min(column.figures, chi.freedom);
        out += fmt::format("- {}: χ² of its figures together = {:.1f} with {} degrees of freedom, {}{}.\n",
                           table.column_titles[column.column], chi.statistic, chi.freedom, p_text(chi.p),
                           fixed == 0 ? "" : " (a figure that every run fixes is left out)");
    }
    if (comparison.together) {
        out += fmt::format("- The whole table, its columns combined (Fisher): {}.\n", p_text(comparison.together->p));
    }
    double least = 2;
    for (const FigureComparison& c : comparison.figures) least = std::min(least, c.adjusted_p.value_or(2));
    if (least <= 1)
        out += fmt::format("- Most surprising sampled figure of the table: Holm-adjusted {}.\n", p_text(least));
    return out + "\n";
}

}  // namespace

std::string published_tables_section(const studies::StudyResults& results) {
    if (!results.published) return {};
    const studies::PublishedResults& published = *results.published;
    const double alpha = 1 - results.findings.plan.spec.level;
    const std::set<std::size_t> blamed = blamed_figures(published.audit);
    std::string out = fmt::format(
        "## The published tables, three things side by side\n\n"
        "{}\n\n"
        "*Printed* is the figure as published († : the audit finds that it contradicts others). *Ours* is the value of "
        "a "
        "deterministic method; of a sampled one the mean over trials and the range of {:g} % of single runs. ″: as in "
        "the row above. "
        "*Where it "
        "falls*: (printed − mean) in standard deviations of a single run, and the share of our runs below it; bold "
        "where a "
        "run as described would give it, or something further out, less often than {:g} % allows over the whole table "
        "(Student t, Holm; χ² by Hotelling's T²).\n\n",
        markdown_text(published.tables.source), 100 * (1 - alpha), 100 * alpha);
    for (std::size_t i = 0; i < published.tables.tables.size(); ++i) out += table_text(published, i, blamed, alpha);
    return out;
}

std::string claims_section(const studies::StudyResults& results) {
    if (!results.published || results.published->claims.empty()) return {};
    std::string out = "## The paper's claims, judged\n\n| claim (section) | verdict | evidence |\n|---|---|---|\n";
    for (const studies::JudgedClaim& claim : results.published->claims) {
        out += fmt::format("| {} ({}) | **{}** | {} |\n", markdown_cell(claim.claim.statement),
                           markdown_cell(claim.claim.section), studies::name(claim.verdict),
                           markdown_cell(claim.evidence));
    }
    return out + "\n";
}

std::string audit_section(const studies::StudyResults& results) {
    if (!results.published) return {};
    const studies::PublishedResults& published = *results.published;
    std::string out = fmt::format(
        "## The audit\n\nFrom the printed figures alone: **{} contradictions**; details in [audit.md](audit.md).\n\n",
        published.audit.contradictions());
    std::size_t number = 0;
    for (const studies::audit::Finding& finding : published.audit.findings) {
        const bool note = finding.severity == studies::audit::Severity::note;
        out += fmt::format("{}. {}{}\n", ++number, note ? "(note) " : "", markdown_text(finding.statement));
    }
    return out + "\n";
}

}  // namespace ff::reports
