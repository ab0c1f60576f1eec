#include "core/points/stream.hpp"

#include "core/support/contract.hpp"

#include <Random123/philox.h>

namespace ff {
namespace {

constexpr std::uint64_t fnv_offset = 0xcbf29ce484222325ULL;
constexpr std::uint64_t fnv_prime = 0x100000001b3ULL;

std::uint64_t fnv1a(std::string_view text) {
    std::uint64_t hash = fnv_offset;
    for (const char c : text) {
        hash ^= static_cast<unsigned char>(c);
        hash *= fnv_prime;
    }
    return hash;
}

constexpr std::uint32_t low(std::uint64_t x) {
    return static_cast<std::uint32_t>(x);
}
constexpr std::uint32_t high(std::uint64_t x) {
    return static_cast<std::uint32_t>(x >> 32);
}

}  // namespace

StreamKey derive_key(Seed seed, std::string_view canonical) {
    const std::uint64_t text = fnv1a(canonical);
    // FNV-1a alone changes too few bits for texts that differ in the last digit; Philox mixes them.
    const auto words =
        r123::Philox4x32()({{low(text), high(text), low(seed.value), high(seed.value)}}, {{0x66667374u, 0x75647921u}});
    return {words[0], words[1]};
}

Words philox(const Stream& stream, std::uint32_t index, Purpose purpose) {
    FF_EXPECT(stream.target < (1u << 24));
    const auto words = r123::Philox4x32()(
        {{index, stream.trial, stream.source, stream.target << 8 | static_cast<std::uint32_t>(purpose)}},
        {{stream.key.word0, stream.key.word1}});
    return {words[0], words[1], words[2], words[3]};
}

}  // namespace ff
