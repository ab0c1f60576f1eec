#pragma once

#include <array>
#include <cstdint>
#include <string_view>

namespace ff {

/// The seed of a study, as given by the user.
struct Seed {
    std::uint64_t value = 0;
    auto operator<=>(const Seed&) const = default;
};

/// The 64-bit Philox key of one (scene, method, size): two cells share no random number.
struct StreamKey {
    std::uint32_t word0 = 0;
    std::uint32_t word1 = 0;
    auto operator<=>(const StreamKey&) const = default;
};

/// Hashes `canonical` (the text that names scene, method and size, never their position in a list) with the seed.
StreamKey derive_key(Seed seed, std::string_view canonical);

/// An independent sequence of random numbers: what one patch (or one ordered pair of patches) uses in one trial.
///
/// Words of Philox4x32-10 are addressed, never drawn: the counter is (point, trial, source, target * 256 + purpose), so
/// the same (stream, point) gives the same words on any thread and in any order, and no two streams overlap.
struct Stream {
    StreamKey key;
    std::uint32_t trial = 0;
    std::uint32_t source = 0;  ///< from-patch, or from-face where one sequence serves a whole face
    std::uint32_t target = 0;  ///< to-patch plus 1 where a point belongs to a pair, below 2^24; 0 otherwise
};

/// The use of a Philox block; keeps coordinates and scramble seeds apart.
enum class Purpose : std::uint8_t {
    coordinates = 0,  ///< the four coordinates of point `index`
    scramble = 1,     ///< seeds of a randomisation, `index` counts blocks of four words
    engine = 2,       ///< seeds of sequential engines
    permutation = 3,  ///< draws of permutations
};

/// Four independent uniform 32-bit words.
using Words = std::array<std::uint32_t, 4>;

/// Philox4x32-10 [salmon2011] at (index, stream, purpose).
Words philox(const Stream& stream, std::uint32_t index, Purpose purpose);

}  // namespace ff
