#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace ff::studies {

/// A field of a CSV record, without its quotes.
struct CsvField {
    std::string text;
    std::size_t line = 0;    ///< where it begins, from 1
    std::size_t column = 0;  ///< first byte in its line, from 1
};

/// Records of a CSV text [rfc4180]: fields between commas, quoted where they hold commas, quotes (doubled) or line
/// ends. Line ends may be LF or CR LF, a byte order mark may come first, and empty lines are skipped.
class CsvReader {
  public:
    /// @throws UserError for a text in UTF-16
    CsvReader(std::string_view text, std::string_view origin);

    /// The next record; false at the end. @throws UserError "origin:line:column: ..." where quotes do not match
    bool next(std::vector<CsvField>& record);

    /// Fails at a field: "origin:line:column: problem (why). Suggestion."
    [[noreturn]] void fail(const CsvField& field, std::string_view problem) const;

    /// The text of a field, trimmed. @param name  of its column @throws UserError where nothing is left
    [[nodiscard]] std::string_view filled(const CsvField& field, std::string_view name) const;

  private:
    [[nodiscard]] bool at_end() const { return place_ == text_.size(); }
    [[nodiscard]] bool at_line_end() const;
    void step();
    void end_line();
    void read(CsvField& field);
    void quoted(CsvField& field);

    std::string_view text_;
    std::string_view origin_;
    std::size_t place_ = 0;
    std::size_t line_ = 1;
    std::size_t column_ = 1;
};

/// What becomes of columns that nobody asked for.
enum class OtherColumns { refused, left_out };

/// Position of each named column in a header, in the order of `names`; empty for a missing one. Case does not matter.
/// @throws UserError for a column that stands twice, and for one of another name where these are refused
std::vector<std::optional<std::size_t>> find_columns(const CsvReader& reader, const std::vector<CsvField>& header,
                                                     std::span<const std::string_view> names,
                                                     OtherColumns others = OtherColumns::refused);

}  // namespace ff::studies
