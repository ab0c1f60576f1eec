#include "studies/readers/digest.hpp"

#include <fmt/format.h>

#include <bit>
#include <cstring>

namespace ff::studies {

/// Each step can be undone, so that two states never become one. Constants of SplitMix64.
Digest& Digest::add(std::uint64_t word) {
    state_ ^= word;
    state_ = (state_ ^ (state_ >> 30u)) * 0xbf58476d1ce4e5b9;
    state_ = (state_ ^ (state_ >> 27u)) * 0x94d049bb133111eb;
    state_ ^= state_ >> 31u;
    return *this;
}

Digest& Digest::add(std::string_view text) {
    add(text.size());
    while (!text.empty()) {
        std::uint64_t word = 0;
        const std::string_view part = text.substr(0, sizeof word);
        std::memcpy(&word, part.data(), part.size());
        add(word);
        text.remove_prefix(part.size());
    }
    return *this;
}

Digest& Digest::add(std::span<const std::uint64_t> words) {
    add(words.size());
    for (const std::uint64_t word : words) add(word);
    return *this;
}

Digest& Digest::add_number(double value) {
    return add(std::bit_cast<std::uint64_t>(value + 0.0));  // -0 becomes 0
}

std::string in_hexadecimal(const Digest& digest) {
    return fmt::format("{:016x}", digest.value());
}

}  // namespace ff::studies
