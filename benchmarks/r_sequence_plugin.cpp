#include <ffstudy/plugin.h>

#include <cstdint>

// The steps of r_sequence in four dimensions, as a plug-in: whole sets of doubles, and parts in fixed point. The shift
// is drawn in another way, which costs nothing in a set of thousands of points.

namespace {

constexpr std::uint64_t steps[4] = {0xdb4f0b9175ae2165, 0xbbe0563303a4615f, 0xa0f2ec75a1fe1575, 0x89e182857d9ed688};

std::uint64_t shift(std::uint64_t seed, std::uint32_t d) {
    std::uint64_t x = seed + 0x9e3779b97f4a7c15u * (d + 1);
    x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9u;
    x = (x ^ (x >> 27)) * 0x94d049bb133111ebu;
    return x ^ (x >> 31);
}

int parts(std::uint32_t* const* coordinate, std::uint64_t first, std::uint32_t count, std::uint64_t /*n*/,
          std::uint32_t d, std::uint64_t seed, std::uint32_t /*trial*/) {
    for (std::uint32_t j = 0; j < d; ++j) {
        std::uint64_t x = shift(seed, j) + first * steps[j];
        for (std::uint32_t i = 0; i < count; ++i, x += steps[j]) coordinate[j][i] = static_cast<std::uint32_t>(x >> 32);
    }
    return 0;
}

int whole(double* points, std::uint64_t n, std::uint32_t d, std::uint64_t seed, std::uint32_t /*trial*/) {
    for (std::uint32_t j = 0; j < d; ++j) {
        std::uint64_t x = shift(seed, j);
        for (std::uint64_t i = 0; i < n; ++i, x += steps[j]) points[i * d + j] = static_cast<double>(x >> 11) * 0x1p-53;
    }
    return 0;
}

constexpr ffstudy_sampler samplers[] = {
    {"r_parts", nullptr, nullptr, 4, 0, 0, nullptr, parts, nullptr},
    {"r_whole", nullptr, nullptr, 4, 0, 0, whole, nullptr, nullptr},
};
constexpr ffstudy_plugin plugin{FFSTUDY_PLUGIN_VERSION, 2, samplers};

}  // namespace

const ffstudy_plugin* ffstudy_samplers() {
    return &plugin;
}
