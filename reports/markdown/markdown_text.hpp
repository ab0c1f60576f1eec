#pragma once

#include <string>
#include <string_view>

namespace ff::reports {

/// Text with names that users gave, as Markdown shows it letter by letter: no tag, link, entity, emphasis or code comes
/// of it. What needs no escape stays as it is, so that the source is read as easily.
std::string markdown_text(std::string_view text);

/// The same for a cell of a table, which a bar would end.
std::string markdown_cell(std::string_view text);

/// Lines of code of a language. The fence is longer than any run of backticks in them.
std::string markdown_code(std::string_view language, std::string_view lines);

}  // namespace ff::reports
