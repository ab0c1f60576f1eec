#pragma once

#include <cstdint>

namespace ff::samplers {

/// Two independent words per coordinate. Adding `addend` alone makes the hash of any point exactly uniform.
struct OwenSeed {
    std::uint32_t addend = 0;
    std::uint32_t multiplier = 0;  ///< the lowest bit is taken as 1
};

/// The fixed multipliers of the hash. They are even, so in x ^= x * m a bit depends on lower bits only.
struct OwenHash {
    static constexpr std::uint32_t first = 0x3d20adea;
    static constexpr std::uint32_t second = 0x05526c56;
    static constexpr std::uint32_t third = 0x53a22864;
};

constexpr std::uint32_t reverse_bits(std::uint32_t x) {
    x = (x & 0x55555555u) << 1 | (x >> 1 & 0x55555555u);
    x = (x & 0x33333333u) << 2 | (x >> 2 & 0x33333333u);
    x = (x & 0x0f0f0f0fu) << 4 | (x >> 4 & 0x0f0f0f0fu);
    x = (x & 0x00ff00ffu) << 8 | (x >> 8 & 0x00ff00ffu);
    return x << 16 | x >> 16;
}

/// A permutation of 32-bit words in which bit b of the result depends on bits 0 .. b of `x` only: with the bits
/// reversed, a nested permutation of the unit interval. After Laine and Karras [laine2011], used for Owen scrambling by
/// Burley [burley2020], with Vegdahl's steps [vegdahl2021]; his one seed word is replaced by two independent ones.
constexpr std::uint32_t owen_hash(std::uint32_t x, OwenSeed seed) {
    x ^= x * OwenHash::first;
    x += seed.addend;
    x *= seed.multiplier | 1u;
    x ^= x * OwenHash::second;
    x ^= x * OwenHash::third;
    return x;
}

/// The hash of a coordinate times 2^32.
constexpr std::uint32_t owen_scramble(std::uint32_t coordinate, OwenSeed seed) {
    return reverse_bits(owen_hash(reverse_bits(coordinate), seed));
}

}  // namespace ff::samplers
