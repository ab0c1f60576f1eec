#pragma once

#include "core/support/error.hpp"

#include <fmt/format.h>

#include <array>
#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace ff::studies::energyplus {

/// The kind of data after the fields of a class: rectangles have an origin and sizes instead of vertices, and are
/// refused.
enum class Shape { none, polygon, rectangle };

/// A class of objects, with the names of its fields in the order of the IDF format.
struct Class {
    std::string_view name;
    std::string_view fields;
    Shape shape = Shape::none;
};

/// A value of an object, as text whatever the file's format.
struct Field {
    std::string text;
    std::uint64_t line = 0;
};

using Vertex = std::array<Field, 3>;

/// An object of an input file.
struct Object {
    const Class* kind = nullptr;
    std::uint64_t line = 0;
    std::map<std::string, Field, std::less<>> fields;  ///< fields by their names in the schema of epJSON
    std::vector<Vertex> vertices;

    /// The text of a field; empty where there is none.
    [[nodiscard]] const std::string& text(std::string_view field) const;
    /// The same in lower case, in which names are compared.
    [[nodiscard]] std::string small_text(std::string_view field) const;
    /// The line of a field; that of the object where there is none.
    [[nodiscard]] std::uint64_t line_of(std::string_view field) const;
};

/// The problem may have values in it as for fmt::format. @throws UserError "file:line: problem"
template <class... Values>
[[noreturn]] void fail_at(std::string_view file, std::uint64_t line, fmt::format_string<Values...> problem,
                          Values&&... values) {
    throw UserError("{}:{}: {}", file, line, fmt::format(problem, std::forward<Values>(values)...));
}

/// @param what  names the field in messages  @throws UserError where it is not a finite number
double number_of_field(std::string_view file, const Field& field, std::string_view what);

/// The remark about an IDF file without a version.
inline constexpr std::string_view without_version =
    "no Version object: fields are taken as those of version 9.6 and later";

/// The bytes of an IDF file with ? for those of comments that are not ASCII: older files have degree signs in other
/// encodings than UTF-8.
std::string with_ascii_comments(std::string bytes);

// Each function reads a whole file, whose name is for messages.
// @throws UserError "file:line: problem (why). Suggestion."

/// The format with commas and semicolons, in which a field is known by its place. Version 9.0 took one out of windows,
/// and 9.6 put one into walls; a file without a version counts as new. @see [energyplus]
std::vector<Object> read_idf(std::string_view file, std::string_view text);

std::vector<Object> read_epjson(std::string_view file, std::string_view text);

}  // namespace ff::studies::energyplus
