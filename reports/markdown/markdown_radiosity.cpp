#include "reports/markdown/markdown_sections.hpp"
#include "reports/markdown/markdown_table.hpp"
#include "reports/markdown/markdown_text.hpp"
#include "reports/tables/radiosity_tables.hpp"
#include "reports/words/findings/radiosity_words.hpp"

#include <fmt/format.h>

namespace ff::reports {

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
        const bool is_long = table.rows.size() > 40;
        if (is_long) out += fmt::format("<details><summary>{} rows</summary>\n\n", table.rows.size());
        out += markdown_table(table);
        if (is_long) out += "</details>\n";
    }
    return out + "\n";
}

}  // namespace ff::reports
