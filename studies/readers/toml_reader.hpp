#pragma once

#include "studies/readers/names.hpp"

#include <cstdint>
#include <initializer_list>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <toml++/toml.h>

namespace ff::studies {

/// A table of a TOML file, read with messages that name file, line and column. Every key has to be read or listed:
/// `expect_only` rejects the others.
class TomlReader {
  public:
    TomlReader(const toml::table& table, std::string_view origin) : table_(&table), origin_(origin) {}

    /// @throws UserError at the first key that is not in `known`, with the nearest known key
    void expect_only(std::span<const std::string_view> known) const;
    void expect_only(std::initializer_list<std::string_view> known) const { expect_only(std::span(known)); }

    [[nodiscard]] bool has(std::string_view key) const { return table_->contains(key); }
    [[nodiscard]] const toml::node* find(std::string_view key) const { return table_->get(key); }

    [[nodiscard]] std::string text(std::string_view key) const;
    [[nodiscard]] std::optional<std::string> optional_text(std::string_view key) const;
    /// A string, or a list of at least one.
    [[nodiscard]] std::vector<std::string> texts(std::string_view key) const;

    /// Index of the text at `key` among `names`; missing is an error, as an unknown name is.
    [[nodiscard]] std::size_t index_of(std::string_view key, std::span<const std::string_view> names) const;
    /// The value whose name is the text at `key`; without `fallback` the key has to be there.
    template <class Enum>
    [[nodiscard]] Enum choice(std::string_view key) const {
        if (const auto value = value_named<Enum>(optional_text(key).value_or(""))) return *value;
        refuse_name(key, suggested_names<Enum>());
    }
    template <class Enum>
    [[nodiscard]] Enum choice(std::string_view key, Enum fallback) const {
        return has(key) ? choice<Enum>(key) : fallback;
    }

    [[nodiscard]] std::uint64_t count(std::string_view key) const;
    [[nodiscard]] std::optional<std::uint64_t> optional_count(std::string_view key) const;
    /// A positive integer, or a list of at least one.
    [[nodiscard]] std::vector<std::uint64_t> counts(std::string_view key) const;
    [[nodiscard]] std::optional<double> optional_number(std::string_view key) const;
    /// Finite numbers: one, or a list of at least one.
    [[nodiscard]] std::vector<double> numbers(std::string_view key) const;

    /// Tables of an array `[[key]]` or of a list of inline tables; empty where the key is missing.
    [[nodiscard]] std::vector<TomlReader> tables(std::string_view key) const;
    [[nodiscard]] std::optional<TomlReader> optional_table(std::string_view key) const;

    /// The file name as given.
    [[nodiscard]] std::string_view origin() const { return origin_; }
    /// All keys, in alphabetical order.
    [[nodiscard]] std::vector<std::string> keys() const;

    /// The position where the table begins.
    [[nodiscard]] std::uint64_t line() const { return table_->source().begin.line; }

    /// "origin:line:column" of the value of `key`, or of the table where it is missing.
    [[nodiscard]] std::string place(std::string_view key) const;

    /// Fails at the value of `key` (at the table itself where it is missing): "origin:line:column: key = value (why).
    /// Suggestion."
    [[noreturn]] void fail(std::string_view key, std::string_view problem) const;
    /// The same, unless the problem is empty.
    void expect_none(std::string_view key, std::string_view problem) const {
        if (!problem.empty()) fail(key, problem);
    }

  private:
    /// Fails at a text that is not among those names, or is missing.
    [[noreturn]] void refuse_name(std::string_view key, std::span<const std::string_view> names) const;

    const toml::table* table_;
    std::string_view origin_;
};

/// @param manual  where the reader of a message may find what such a file looks like
/// @throws UserError with the parser's own message and place
toml::table parse_toml(std::string_view text, std::string_view origin, std::string_view manual = "docs/study-files.md");

}  // namespace ff::studies
