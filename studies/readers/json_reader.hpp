#pragma once

#include "studies/readers/json_document.hpp"

#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

namespace ff::studies {

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
