#include "reports/tables/tables.hpp"
#include "reports/text/numbers.hpp"
#include "reports/words/published_words.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace ff::reports {
namespace {

using studies::FigureComparison;

/// Sentences about a table's figures taken together.
std::vector<std::string> remarks_of(const studies::PublishedTable& table, const studies::TableComparison& comparison) {
    std::vector<std::string> remarks;
    for (const studies::ColumnChiSquared& column : comparison.chi_squared) {
        const auto& chi = column.form.chi_squared;
        remarks.push_back(
            fmt::format("{}: χ² of its {} figures together = {:.1f} with {} degrees of freedom, {} (Hotelling).",
                        table.column_titles[column.column], column.figures, chi.statistic, chi.freedom, p_text(chi.p)));
    }
    if (comparison.together)
        remarks.push_back(fmt::format("The columns combined (Fisher): {}.", p_text(comparison.together->p)));
    return remarks;
}

}  // namespace

Table published_table(const studies::PublishedResults& published, std::size_t index, double alpha) {
    const studies::PublishedTable& printed = published.tables.tables[index];
    const studies::TableComparison& comparison = published.comparisons[index];
    const auto blamed = blamed_figures(published.audit);
    Table table{printed.id,   fmt::format("{}: {}", printed.id, printed.title),
                printed.note, columns({""}),
                {},           remarks_of(printed, comparison)};
    for (const std::string& column : printed.column_titles) {
        table.columns.push_back({"printed", true, column});
        table.columns.push_back({"ours", true, column});
        table.columns.push_back({"position", false, column});
    }
    const std::size_t columns = printed.column_titles.size();
    for (std::size_t row = 0; row < printed.row_titles.size(); ++row) {
        std::vector<TableCell> cells{printed.row_titles[row]};
        for (std::size_t column = 0; column < columns; ++column) {
            const auto figure = printed.figures[row * columns + column];
            if (!figure) {
                cells.resize(cells.size() + 3);
                continue;
            }
            const auto& c = *std::find_if(comparison.figures.begin(), comparison.figures.end(),
                                          [&](const FigureComparison& f) { return f.figure == *figure; });
            const std::string& text = published.tables.figures[*figure].printed;
            cells.push_back({text, blamed.contains(*figure) ? Mark::misprint : Mark::none});
            cells.push_back(ours_text(c, text));
            cells.push_back({place_text(c, text), is_surprising(c, alpha) ? Mark::surprising : Mark::none});
        }
        table.rows.push_back(std::move(cells));
    }
    return table;
}

Table claims_table(const studies::PublishedResults& published) {
    Table table{"claims", "The publication's claims, judged", "", columns({"claim", "verdict", "section", "evidence"})};
    for (const studies::JudgedClaim& claim : published.claims) {
        const Mark mark = claim.verdict == studies::ClaimVerdict::supported ? Mark::good
                          : claim.verdict == studies::ClaimVerdict::refuted ? Mark::bad
                                                                            : Mark::open;
        table.rows.push_back({claim.claim.statement + tested_as(claim.claim),
                              {std::string(studies::name(claim.verdict)), mark},
                              claim.claim.section,
                              claim.evidence});
    }
    return table;
}

}  // namespace ff::reports
