#pragma once

#include <cstddef>
#include <cstdint>
#include <initializer_list>
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

/// Extracts typed values from a JSON document. Anything invalid is a UserError that says where it is, what is wrong and
/// what to do. `key` names a value in messages, `what` an object.
class JsonReader {
  public:
    /// @param origin names the document; outlives the reader
    explicit JsonReader(std::string_view origin) : origin_(origin) {}

    [[noreturn]] void fail(const JsonValue& at, const std::string& message) const;

    /// Requires that the value is an object with no keys other than these.
    void expect_object(const JsonValue& value, std::string_view what,
                       std::initializer_list<std::string_view> keys) const;

    const JsonValue& member(const JsonValue& object, std::string_view key, std::string_view what) const;
    const std::vector<JsonValue>& array(const JsonValue& value, std::string_view key) const;
    std::string text(const JsonValue& value, std::string_view key) const;
    /// Empty where the object has no such member.
    std::string optional_text(const JsonValue& object, std::string_view key) const;
    /// A whole number from 1 to `largest`, at most 2^53.
    std::uint64_t count(const JsonValue& value, std::string_view key, double largest) const;
    bool flag(const JsonValue& value, std::string_view key) const;
    /// The index of the value in a list of words.
    std::size_t choice(const JsonValue& value, std::string_view key,
                       std::initializer_list<std::string_view> words) const;
    /// A string of digits with at most one decimal point, as printed.
    std::string number_as_printed(const JsonValue& value, std::string_view key) const;

  private:
    std::string_view origin_;
};

}  // namespace ff::studies
