#pragma once

#include "reports/templates/templates.hpp"
#include "reports/text/table.hpp"
#include "studies/results/results.hpp"

#include <string>
#include <vector>

namespace ff::reports {

/// A file of a report, by its path below the folder of results.
struct NamedText {
    std::string path;
    std::string text;
};

/// tables.tex, a document that compiles, and the tables that it includes, one per file of tables/: methods, slopes, the
/// published tables, claims, the pairs of every cell. Byte-identical for the same store.
std::vector<NamedText> latex_report(const studies::StudyResults& results, const Templates& templates);

/// One table. Where all columns except the first form groups of equal titles, as in published tables, the groups are
/// stacked vertically: paper is narrow.
std::string latex_table(const Table& table, const Templates& templates);

/// Text escaped for LaTeX, in any font encoding: special characters, ASCII ligatures and the signs that reports use are
/// written out, control characters become spaces. Letters of other scripts stay UTF-8.
std::string escape_latex(const std::string& text);

/// The same, with numbers set as mathematics: "-7.2e-05" becomes $-7.2\times10^{-5}$.
std::string latex_with_numbers(const std::string& text);

}  // namespace ff::reports
