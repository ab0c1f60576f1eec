#include "studies/scene_files/vs3_line.hpp"

#include "core/support/excerpt.hpp"
#include "core/support/words.hpp"

#include <fmt/format.h>

namespace ff::studies {

Vs3Line::Vs3Line(const SceneBuilder& builder, std::uint64_t place, std::string_view text)
    : builder_(builder), place_(place), words_(split_words(text.substr(0, text.find('!')), " \t\r,")) {}

std::string Vs3Line::word(std::size_t at) const {
    return at < words_.size() ? fmt::format("'{}'", excerpt(words_[at])) : std::string("missing");
}

std::string Vs3Line::rest(std::size_t at) const {
    return fmt::format("{}", fmt::join(words_.begin() + static_cast<std::ptrdiff_t>(at), words_.end(), " "));
}

long Vs3Line::whole(std::size_t at) const {
    const auto value = at < words_.size() ? parse_number<long>(words_[at]) : std::nullopt;
    if (!value)
        builder_.fail(place_, "field {} is {}{}. Write a whole number there.", at + 1, word(at),
                      at < words_.size() ? ", not a whole number" : "");
    return *value;
}

double Vs3Line::emissivity(std::size_t at) const {
    const auto value = finite_number(words_[at]);
    if (!value || *value < 0 || *value > 1)
        builder_.fail(place_, "field {} is {} (expected an emissivity, from 0 to 1). Write it there.", at + 1,
                      word(at));
    if (is_decimal_comma(at))
        builder_.fail(place_, "field {} is '{},{}' (commas separate fields). Write {}.{}.", at + 1, words_[at],
                      words_[at + 1], words_[at], words_[at + 1]);
    return *value;
}

void Vs3Line::expect_no_number(std::size_t at, std::string_view wanted) const {
    if (at < words_.size() && finite_number(words_[at]))
        builder_.fail(place_, "{}, and {} follows. Remove it; write 0.5 where 0,5 is meant.", wanted, word(at));
}

/// Whether this word and the next are digits with nothing but a comma between them.
bool Vs3Line::is_decimal_comma(std::size_t at) const {
    if (at + 1 >= words_.size()) return false;
    const std::string_view whole = words_[at];
    const std::string_view decimals = words_[at + 1];
    constexpr std::string_view digits = "0123456789";
    return whole.data() + whole.size() + 1 == decimals.data() && *(decimals.data() - 1) == ',' &&
           whole.find_first_not_of(digits) == std::string_view::npos &&
           decimals.find_first_not_of(digits) == std::string_view::npos;
}

}  // namespace ff::studies
