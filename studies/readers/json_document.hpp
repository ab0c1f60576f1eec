#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace ff::studies {

/// A place in a text file, both counted from 1; columns count bytes.
struct TextPosition {
    int line = 1;
    int column = 1;
};

/// A JSON value with its position, so that messages about its meaning can point at it.
struct JsonValue {
    enum class Kind { null, boolean, number, string, array, object };

    Kind kind = Kind::null;
    TextPosition position;
    double number = 0;              ///< 0 or 1 for booleans
    std::string text;               ///< strings only
    std::vector<std::string> keys;  ///< names of an object's members, in file order
    std::vector<JsonValue> items;   ///< elements of an array, or values of an object's members in the order of `keys`

    /// The member called `key`, or nullptr.
    [[nodiscard]] const JsonValue* find(std::string_view key) const;
};

/// Parses a whole JSON text. @param origin names the text in messages, usually a file name.
/// @throws UserError "origin:line:column: ..." where it is malformed or an object has the same key twice
JsonValue parse_json(std::string_view text, std::string_view origin);

/// "origin:line:column: ", the start of every message about a file.
std::string describe(std::string_view origin, TextPosition position);

}  // namespace ff::studies
