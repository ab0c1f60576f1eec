#include "studies/readers/json_reader.hpp"

#include "core/support/error.hpp"
#include "core/support/excerpt.hpp"
#include "core/support/nearest_name.hpp"
#include "studies/readers/printable.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>

namespace ff::studies {
namespace {

/// Lines and columns of a text, fast where places are asked for from the first to the last.
class Positions {
  public:
    explicit Positions(std::string_view text) : text_(text) {}

    TextPosition of(std::size_t byte) {
        if (byte < reached_) {
            reached_ = 0;
            position_ = {};
        }
        for (; reached_ < byte && reached_ < text_.size(); ++reached_) {
            const bool new_line = text_[reached_] == '\n';
            position_.line += new_line ? 1 : 0;
            position_.column = new_line ? 1 : position_.column + 1;
        }
        return position_;
    }

  private:
    std::string_view text_;
    std::size_t reached_ = 0;
    TextPosition position_;
};

/// Largest depth of nested objects and lists. No file of ours has more, and reading and destroying the tree recurse.
constexpr std::size_t most_levels = 100;

/// Builds the tree from the parser's events.
class TreeBuilder : public nlohmann::json_sax<nlohmann::json> {
  public:
    TreeBuilder(std::string_view text, std::string_view origin)
        : text_(text), origin_(origin), positions_(text), reached_(text.data()) {}

    /// The parser has come so far.
    void set_reached(const char* at) { reached_ = at; }
    JsonValue take() { return std::move(root_); }

    bool null() override { return add(token_start(), JsonValue::Kind::null); }
    bool boolean(bool value) override { return add(token_start(), JsonValue::Kind::boolean, value ? 1 : 0); }
    bool number_integer(number_integer_t value) override { return add_number(static_cast<double>(value)); }
    bool number_unsigned(number_unsigned_t value) override { return add_number(static_cast<double>(value)); }
    bool number_float(number_float_t value, const string_t& /*text*/) override { return add_number(value); }
    bool binary(binary_t& /*value*/) override { return false; }
    bool string(string_t& value) override { return add(string_start(), JsonValue::Kind::string, 0, std::move(value)); }
    bool key(string_t& value) override {
        const TextPosition position = positions_.of(string_start());
        if (open_.back()->find(value) != nullptr) {
            throw UserError("{}the key \"{}\" stands twice in one object (only one could be used). Remove one.",
                            describe(origin_, position), excerpt(value));
        }
        key_ = std::move(value);
        return true;
    }
    bool start_object(std::size_t /*size*/) override { return open(JsonValue::Kind::object); }
    bool start_array(std::size_t /*size*/) override { return open(JsonValue::Kind::array); }
    bool end_object() override { return close(); }
    bool end_array() override { return close(); }
    bool parse_error(std::size_t byte, const std::string& /*token*/,
                     const nlohmann::detail::exception& error) override {
        const std::string what = error.what();
        const std::size_t colon = what.find(": ");  // drops the library's own prefix and position
        throw UserError("{}this is not JSON ({}). Check quotes, commas and brackets here and just before.",
                        describe(origin_, positions_.of(byte == 0 ? 0 : byte - 1)),
                        excerpt(colon == std::string::npos ? what : what.substr(colon + 2)));
    }

  private:
    [[nodiscard]] std::size_t consumed() const { return static_cast<std::size_t>(reached_ - text_.data()); }

    /// The parser stands just behind a string's closing quote.
    [[nodiscard]] std::size_t string_start() const {
        std::size_t at = consumed() - 1;
        while (at > 0) {
            --at;
            if (text_[at] != '"') continue;
            std::size_t backslashes = 0;
            while (backslashes < at && text_[at - 1 - backslashes] == '\\') ++backslashes;
            if (backslashes % 2 == 0) break;
        }
        return at;
    }

    /// The parser stands on or just behind the last letter of a number or word.
    [[nodiscard]] std::size_t token_start() const {
        constexpr std::string_view letters = "+-.0123456789abcdefghijklmnopqrstuvwxyzE";
        std::size_t at = consumed();
        if (at > 0 && letters.find(text_[at - 1]) == std::string_view::npos) --at;
        while (at > 0 && letters.find(text_[at - 1]) != std::string_view::npos) --at;
        return at;
    }

    JsonValue& place(std::size_t start, JsonValue::Kind kind) {
        JsonValue value;
        value.kind = kind;
        value.position = positions_.of(start);
        if (open_.empty()) {
            root_ = std::move(value);
            return root_;
        }
        JsonValue& parent = *open_.back();
        if (parent.kind == JsonValue::Kind::object) parent.keys.push_back(std::move(key_));
        return parent.items.emplace_back(std::move(value));
    }
    bool add(std::size_t start, JsonValue::Kind kind, double number = 0, std::string text = {}) {
        JsonValue& value = place(start, kind);
        value.number = number;
        value.text = std::move(text);
        return true;
    }
    bool add_number(double value) { return add(token_start(), JsonValue::Kind::number, value); }
    bool open(JsonValue::Kind kind) {
        if (open_.size() >= most_levels) {
            throw UserError(
                "{}more than {} objects and lists within each other (no file of this program has more). Close some.",
                describe(origin_, positions_.of(consumed() - 1)), most_levels);
        }
        open_.push_back(&place(consumed() - 1, kind));
        return true;
    }
    bool close() {
        open_.pop_back();
        return true;
    }

    std::string_view text_;
    std::string_view origin_;
    Positions positions_;
    const char* reached_;
    JsonValue root_;
    std::vector<JsonValue*> open_;  ///< valid: a container grows only while none of its children is open
    std::string key_;
};

/// Events of the library carry no positions: the builder is told of every letter that the parser takes.
struct WatchedLetter {
    using iterator_category = std::input_iterator_tag;
    using value_type = char;
    using difference_type = std::ptrdiff_t;
    using pointer = const char*;
    using reference = char;

    char operator*() const {
        builder->set_reached(at + 1);
        return *at;
    }
    WatchedLetter& operator++() {
        ++at;
        return *this;
    }
    bool operator==(const WatchedLetter& other) const { return at == other.at; }

    const char* at;
    TreeBuilder* builder;
};

}  // namespace

const JsonValue* JsonValue::find(std::string_view key) const {
    for (std::size_t k = 0; k < keys.size(); ++k) {
        if (keys[k] == key) return &items[k];
    }
    return nullptr;
}

std::string describe(std::string_view origin, TextPosition position) {
    return fmt::format("{}:{}:{}: ", origin, position.line, position.column);
}

JsonValue parse_json(std::string_view text, std::string_view origin) {
    TreeBuilder builder(text, origin);
    const char* const begin = text.data();
    nlohmann::json::sax_parse(WatchedLetter{begin, &builder}, WatchedLetter{begin + text.size(), &builder}, &builder);
    return builder.take();
}

using Kind = JsonValue::Kind;

void JsonReader::fail(const JsonValue& at, const std::string& message) const {
    throw UserError(describe(origin_, at.position) + message);
}

void JsonReader::expect_object(const JsonValue& value, std::string_view what,
                               std::initializer_list<std::string_view> keys) const {
    if (value.kind != Kind::object)
        fail(value, fmt::format("{} is not an object. Write {{\"key\": value, ...}}.", what));
    for (std::size_t k = 0; k < value.keys.size(); ++k) {
        const std::string& key = value.keys[k];
        if (std::find(keys.begin(), keys.end(), key) != keys.end()) continue;
        const std::vector<std::string_view> known(keys);
        const std::string nearest = nearest_name(key, known);
        fail(value.items[k],
             fmt::format("unknown key \"{}\" in {} (it would be ignored silently). {}", excerpt(key), what,
                         nearest.empty() ? fmt::format("Known keys: {}.", fmt::join(known, ", "))
                                         : fmt::format("Did you mean \"{}\"?", nearest)));
    }
}

const JsonValue& JsonReader::member(const JsonValue& object, std::string_view key, std::string_view what) const {
    const JsonValue* found = object.find(key);
    if (found == nullptr) fail(object, fmt::format("{} has no \"{}\". Add it.", what, key));
    return *found;
}

const std::vector<JsonValue>& JsonReader::array(const JsonValue& value, std::string_view key) const {
    if (value.kind != Kind::array) fail(value, fmt::format("\"{}\" is not a list. Write [..., ...].", key));
    return value.items;
}

std::string JsonReader::text(const JsonValue& value, std::string_view key) const {
    if (value.kind != Kind::string) fail(value, fmt::format("\"{}\" is not a text. Put it in double quotes.", key));
    if (const auto problem = problem_with_title(value.text); !problem.empty())
        fail(value, fmt::format("\"{}\" {}", excerpt(value.text), problem));
    return value.text;
}

std::string JsonReader::optional_text(const JsonValue& object, std::string_view key) const {
    const JsonValue* found = object.find(key);
    return found == nullptr ? std::string{} : text(*found, key);
}

std::uint64_t JsonReader::count(const JsonValue& value, std::string_view key, double largest) const {
    if (value.kind != Kind::number || value.number < 1 || value.number > largest ||
        std::floor(value.number) != value.number) {
        fail(value, fmt::format("\"{}\" is not a whole number from 1 to {:.0f}. Write it like 169.", key, largest));
    }
    return static_cast<std::uint64_t>(value.number);
}

bool JsonReader::flag(const JsonValue& value, std::string_view key) const {
    if (value.kind != Kind::boolean)
        fail(value, fmt::format("\"{}\" is neither true nor false. Write one of them, without quotes.", key));
    return value.number != 0;
}

std::size_t JsonReader::choice(const JsonValue& value, std::string_view key,
                               std::initializer_list<std::string_view> words) const {
    const std::string word = text(value, key);
    const auto* const found = std::find(words.begin(), words.end(), word);
    if (found != words.end()) return static_cast<std::size_t>(found - words.begin());
    const std::vector<std::string_view> known(words);
    fail(value, fmt::format("\"{}\" is no {}. {}Known: {}.", excerpt(word), key, did_you_mean(word, known, '"'),
                            fmt::join(known, ", ")));
}

std::string JsonReader::number_as_printed(const JsonValue& value, std::string_view key) const {
    if (value.kind != Kind::string) {
        fail(value, fmt::format("\"{}\" must be given as a string (a JSON number loses trailing zeros). Put the digits "
                                "in double quotes, exactly as printed.",
                                key));
    }
    const std::string& digits = value.text;
    const bool plain = digits.find_first_not_of("0123456789.") == std::string::npos &&
                       std::count(digits.begin(), digits.end(), '.') <= 1 && digits.size() <= 16 &&
                       digits.find_first_of("0123456789") != std::string::npos;
    if (!plain) {
        fail(value, fmt::format("\"{}\" is not a printed number (digits and at most one decimal point, 16 characters "
                                "at most). Write null for a blank cell.",
                                excerpt(digits)));
    }
    return digits;
}

}  // namespace ff::studies
