#pragma once

#include "studies/scene_files/scene_source.hpp"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace ff::studies {

/// The quantity that a printed figure states.
enum class FigureKind {
    form_factor,         ///< F(from, to)
    row_sum,             ///< sum over `to` of F(from, to)
    relative_error,      ///< 100 |F(from, to) - reference| / reference, percent
    sum_relative_error,  ///< sum over all faces of 100 |row sum - 1|, percent
};

/// One printed figure of a published table.
struct Figure {
    std::string table;    ///< table id
    std::size_t row = 0;  ///< position in the table as printed, from 0
    std::size_t column = 0;
    std::string method;  ///< as the study file names it, e.g. "SR"
    std::uint32_t patches_per_face = 1;
    std::optional<std::uint64_t> samples_per_patch;  ///< empty for a deterministic method
    FigureKind kind = FigureKind::form_factor;
    std::string from;     ///< face label; empty for sum_relative_error
    std::string to;       ///< face label; empty for sums
    std::string printed;  ///< digits exactly as printed
    int line = 0;         ///< line in the file, for messages
    int character = 0;
};

/// Whether the figure states a form factor, or a sum of them, rather than an error.
inline bool is_value(const Figure& figure) {
    return figure.kind == FigureKind::form_factor || figure.kind == FigureKind::row_sum;
}

/// A printed table: `figures` has indices into PublishedTables::figures, row by row; empty for a blank cell.
struct PublishedTable {
    std::string id;
    std::string title;
    std::vector<std::string> column_titles;
    std::vector<std::string> row_titles;
    std::vector<std::optional<std::size_t>> figures;  ///< [row * columns + column]
    std::string note;
};

/// A verbal claim of the publication, in the small vocabulary of docs/published-tables.md.
struct PublishedClaim {
    std::string id;
    std::string section;
    std::string statement;
    std::string tested_as;  ///< what of the statement a study tests; empty where that is plain
    std::string kind;
    std::vector<std::string> methods;
    std::string pair_class;  ///< "parallel", "adjacent", "all" or empty
    std::vector<std::uint32_t> patches_per_face;
    std::vector<std::uint64_t> samples_per_patch;
    std::optional<double> number;
};

/// How a publication says that it prints numbers.
enum class PrintingRule { unstated, rounded, truncated };

/// Another way to read what a table's columns mean, e.g. "rays in total" for "rays per patch".
struct Reading {
    std::string table;
    std::string statement;
    std::string stated_in;                     ///< where the publication says so, e.g. "text"; empty for a conjecture
    std::vector<std::uint64_t> rays_per_face;  ///< one per column
};

/// The tables of one publication: the printed figures, and the meaning of each.
struct PublishedTables {
    std::string source;
    SceneSource scene;
    PrintingRule rule = PrintingRule::unstated;
    int decimals = 6;                               ///< printed decimals the publication claims
    std::optional<std::string> reference_parallel;  ///< exact values as printed
    std::optional<std::string> reference_adjacent;
    std::vector<std::string> reciprocal_methods;  ///< methods whose (j, i) follows from (i, j), i < j, by reciprocity
    std::vector<std::string> sampling_methods;    ///< methods whose estimates are hits / rays
    std::vector<PublishedTable> tables;
    std::vector<Figure> figures;
    std::vector<Reading> readings;
    std::vector<PublishedClaim> claims;
};

/// Parses the text of a tables file (docs/published-tables.md), with that of its scene if it is a file; `origin` names
/// it in messages.
/// @throws UserError "origin:line:column: ..." where it is malformed
PublishedTables parse_published_tables(std::string_view text, std::string_view origin);

/// The text of a tables file, with that of the scene file beside it that it may name. @throws IoError, UserError
std::string read_tables_text(const std::filesystem::path& file);

/// Reads a tables file.
/// @throws IoError where the file cannot be read; UserError as above
PublishedTables read_published_tables(const std::filesystem::path& file);

/// The figure in words, e.g. "table4, row 3 (Σ of face 3), column SR".
std::string describe(const PublishedTables& tables, std::size_t figure);

}  // namespace ff::studies
