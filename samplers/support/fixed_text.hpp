#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <string_view>

namespace ff::samplers {

/// A text built at compile time, for descriptions of samplers derived from others.
template <std::size_t size>
struct FixedText {
    std::array<char, size> characters{};
    [[nodiscard]] constexpr std::string_view view() const { return {characters.data(), size}; }
};

template <std::size_t size>
// NOLINTNEXTLINE(modernize-avoid-c-arrays): the type of a literal
constexpr FixedText<size - 1> fixed(const char (&literal)[size]) {
    FixedText<size - 1> text;
    std::copy_n(literal, size - 1, text.characters.begin());
    return text;
}

template <std::size_t... sizes>
constexpr FixedText<(sizes + ...)> join(const FixedText<sizes>&... texts) {
    FixedText<(sizes + ...)> result;
    auto end = result.characters.begin();
    ((end = std::copy(texts.characters.begin(), texts.characters.end(), end)), ...);
    return result;
}

/// The name of a sampler.
template <class Sampler>
constexpr auto fixed_name() {
    FixedText<Sampler::info.name.size()> text;
    std::copy(Sampler::info.name.begin(), Sampler::info.name.end(), text.characters.begin());
    return text;
}

}  // namespace ff::samplers
