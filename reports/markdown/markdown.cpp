#include "reports/markdown/markdown.hpp"

#include "reports/markdown/markdown_sections.hpp"
#include "reports/markdown/markdown_text.hpp"
#include "reports/pictures/answer_svg.hpp"
#include "reports/tables/tables.hpp"
#include "reports/text/numbers.hpp"
#include "reports/words/answer.hpp"
#include "reports/words/findings/radiosity_words.hpp"
#include "reports/words/findings/verdicts.hpp"
#include "reports/words/in_brief.hpp"
#include "reports/words/published_words.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace ff::reports {
namespace {

std::string bias_line(const studies::Analysis& findings) {
    BiasTally tally = tally_of(findings);
    if (tally.sampled == 0) return {};
    const auto biased = tally.found[studies::BiasFinding::biased];
    const std::string lost = tally.lost_rays ? fmt::format(" Lost rays: {}.", *tally.lost_rays) : std::string();
    if (tally.found[studies::BiasFinding::untestable] == tally.sampled)
        return fmt::format("- Bias: not tested in any of {} {}.{}\n", tally.sampled, counted_cells(findings.plan),
                           lost);
    std::string out =
        fmt::format("- Bias: {}none found in {} of {} {}{} ({:g} % over all of them)",
                    biased > 0 ? fmt::format("found in {}, ", biased) : "",
                    tally.found[studies::BiasFinding::no_bias_found], tally.sampled, counted_cells(findings.plan),
                    tally.partly > 0 ? fmt::format(", in {} of them on a part of the pairs", tally.partly) : "",
                    100 * (1 - findings.plan.spec.level));
    if (const auto untested = tally.found[studies::BiasFinding::untestable]; untested > 0)
        out += fmt::format("; {} cannot be tested", untested);
    if (const auto open = tally.found[studies::BiasFinding::inconclusive]; open > 0)
        out += fmt::format("; {} may be biased or skewed", open);
    if (const auto margin = findings.plan.spec.equivalence_margin) {
        out += fmt::format("; for {} every pair is shown to lie within ±{}", tally.shown, brief(*margin, 2));
    }
    return out + fmt::format(".{}\n", lost);
}

std::string brief_section(const studies::StudyResults& results) {
    const Answer said = answer(results);
    std::string out = said.question.empty() ? std::string() : fmt::format("*{}*\n\n", markdown_text(said.question));
    out += fmt::format("**{}**\n\n", markdown_text(said.text));
    if (const auto lead = answer_picture(results))
        out += fmt::format("![{}](answer.svg)\n\n{}\n\n", markdown_text(lead->title), markdown_text(lead->finding));
    out += "## In brief\n\n";
    out += bias_line(results.findings);
    if (const auto light = light_in_brief(results)) {
        std::string clause = markdown_text(light->clause);
        clause.front() = 'A';
        out += fmt::format("- {}; see [what the errors do to the light](#what-the-errors-do-to-the-light).\n", clause);
    }
    for (const std::string& line : results_in_brief(results)) out += fmt::format("- {}\n", markdown_text(line));
    if (results.published) {
        for (const std::string& line : published_in_brief(*results.published, 1 - results.findings.plan.spec.level))
            out += fmt::format("- {}\n", markdown_text(line));
        if (results.published->audit.figures > 0)
            out += fmt::format("- The {} printed figures contain {} contradictions; see [the audit](#the-audit).\n",
                               results.published->audit.figures, results.published->audit.contradictions());
    }
    return out + "\n";
}

std::string table_text(const studies::PublishedResults& published, std::size_t index, double alpha) {
    const studies::PublishedTable& table = published.tables.tables[index];
    const studies::TableComparison& comparison = published.comparisons[index];
    std::string out = fmt::format("### {}: {}\n\n", markdown_text(table.id), markdown_text(table.title));
    if (!table.note.empty()) out += fmt::format("*{}*\n\n", markdown_text(table.note));
    out += "| |";
    std::string rule = "|---|";
    for (const std::string& column : table.column_titles) {
        out += fmt::format(" {}: printed | ours | position |", markdown_cell(column));
        rule += "--:|--:|:--|";
    }
    out += "\n" + rule + "\n";
    std::vector<std::string> above(table.column_titles.size());
    for (const auto& row : published_table(published, index, alpha).rows) {
        out += fmt::format("| {} |", markdown_cell(row.front().text));
        for (std::size_t column = 0; column < above.size(); ++column) {
            const TableCell* const cell = &row[1 + 3 * column];  // printed, ours, position
            const bool has_figure = !cell[0].text.empty();
            const std::string_view mark = cell[2].mark == Mark::surprising ? "**" : "";
            std::string text = " | | |";
            if (has_figure)
                text = fmt::format(" {}{} | {} | {}{}{} |", cell[0].text, cell[0].mark == Mark::misprint ? " †" : "",
                                   cell[1].text, mark, cell[2].text, mark);
            // A deterministic method treats congruent faces alike: rows and rows of the same figures.
            out += has_figure && text == above[column] ? " ″ | ″ | ″ |" : text;
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
    for (const studies::FigureComparison& c : comparison.figures) least = std::min(least, c.adjusted_p.value_or(2));
    if (least <= 1)
        out += fmt::format("- Most surprising sampled figure of the table: Holm-adjusted {}.\n", p_text(least));
    return out + "\n";
}

std::string published_tables_section(const studies::StudyResults& results) {
    if (!results.published) return {};
    const studies::PublishedResults& published = *results.published;
    const double alpha = 1 - results.findings.plan.spec.level;
    std::string out = fmt::format(
        "## The published tables, three things side by side\n\n"
        "{}\n\n"
        "*Printed* is the figure as published († : the audit finds that it contradicts others). *Ours* is the value of "
        "a deterministic method; of a sampled one the mean over trials and the range of {:g} % of single runs. ″: as "
        "in "
        "the row above. *Position*: (printed − mean) in standard deviations of a single run, and the share of "
        "our "
        "runs below it; bold where a run as described would give it, or something further out, less often than {:g} % "
        "allows over the whole table (Student t, Holm; χ² by Hotelling's T²).\n\n",
        markdown_text(published.tables.source), 100 * (1 - alpha), 100 * alpha);
    for (std::size_t i = 0; i < published.tables.tables.size(); ++i) out += table_text(published, i, alpha);
    return out;
}

std::string claims_section(const studies::StudyResults& results) {
    if (!results.published || results.published->claims.empty()) return {};
    std::string out = "## The paper's claims, judged\n\n| claim (section) | verdict | evidence |\n|---|---|---|\n";
    for (const studies::JudgedClaim& claim : results.published->claims) {
        out += fmt::format("| {} ({}) | **{}** | {} |\n", markdown_cell(claim.claim.statement + tested_as(claim.claim)),
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
        out += fmt::format("{}. {}\n", ++number, markdown_text(finding.statement));
    }
    return out + "\n";
}

}  // namespace

std::string radiosity_section(const studies::StudyResults& results) {
    if (!results.radiosity) return {};
    std::string out =
        "## What the errors do to the light\n\n"
        "The radiosity system (I − P F) m = e with the factors F of every trial, as they are and repaired: *direct* "
        "(every row from its own samples), *reciprocal* (one triangle from the other), *normalised* (the reciprocal "
        "matrix, rows divided by their sums), *balanced* (weighted least squares with closure, reciprocity and no "
        "negative factor, errors those of counted hits).\n\n";
    for (const std::string& line : radiosity_in_brief(results)) out += fmt::format("- {}\n", markdown_text(line));
    for (const Table& table : radiosity_tables(results)) {
        out += fmt::format("\n### {}\n\n{}\n\n", table.title, table.note);
        out += folded_if_long(markdown_table(table), table.rows.size());
    }
    return out + "\n";
}

std::string markdown_report(const studies::StudyResults& results) {
    std::string out = fmt::format("# {}\n\n", markdown_text(results.findings.plan.spec.title));
    if (!results.findings.complete)
        out += "> **Partial result:** the study was stopped early; run it again to resume.\n\n";
    out += brief_section(results);
    out += markdown_section(methods_table(results));
    out += markdown_section(occlusion_table(results));
    out += markdown_section(configurations_table(results));
    out += markdown_section(convergence_table(results));
    out += markdown_section(decisions_table(results, false));
    out += markdown_section(contests_table(results, false));
    out += markdown_section(reductions_table(results));
    out += markdown_section(evenness_table(results));
    out += markdown_section(coverage_table(results));
    out += markdown_section(claimed_errors_table(results, Claims::all));
    out += radiosity_section(results);
    out += published_tables_section(results);
    out += claims_section(results);
    out += markdown_section(error_law_table(results));
    out += audit_section(results);
    out += bias_section(results);
    out += markdown_section(spreads_table(results));
    out += reproduction_section(results);
    return out;
}

}  // namespace ff::reports
