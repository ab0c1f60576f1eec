#include "tests/unit/studies/audit/sound_hits.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace ff::test {
namespace {

using Count = std::int64_t;

/// numerator / denominator in decimals, from whole numbers alone.
std::string print_fraction(Count numerator, Count denominator, const SoundHits& hits) {
    Count scale = 1;
    for (int k = 0; k < hits.decimals; ++k) scale *= 10;
    const Count rest = numerator * scale % denominator;
    const Count digits = numerator * scale / denominator + (!hits.truncated && 2 * rest >= denominator ? 1 : 0);
    return fmt::format("{}.{:0{}}", digits / scale, digits % scale, hits.decimals);
}

std::vector<std::vector<Count>> shoot(const studies::audit::SceneFacts& facts, Count rays, std::mt19937_64& random) {
    std::vector<std::vector<Count>> hits(facts.faces(), std::vector<Count>(facts.faces(), 0));
    for (std::size_t i = 0; i < facts.faces(); ++i) {
        std::vector<double> shares;
        for (std::size_t j = 0; j < facts.faces(); ++j) shares.push_back(facts.factor(i, j).middle());
        double rest = 0;
        for (const double share : shares) rest += share;
        Count left = rays;
        for (std::size_t j = 0; j < facts.faces() && left > 0; ++j) {
            if (shares[j] <= 0) continue;
            const double p = shares[j] / rest;
            hits[i][j] = p > 1 - 1e-9 ? left : std::binomial_distribution<Count>(left, p)(random);
            left -= hits[i][j];
            rest -= shares[j];
        }
    }
    return hits;
}

template <std::size_t n>
auto pick(const std::array<Count, n>& values, std::mt19937_64& random) {
    return values[random() % n];
}

}  // namespace

SoundHits any_hits(const std::vector<std::string>& scenes, std::mt19937_64& random) {
    return {.scene = scenes[random() % scenes.size()],
            .reciprocal = random() % 2 == 0,
            .truncated = random() % 2 == 0,
            .stated = random() % 2 == 0,
            .decimals = static_cast<int>(pick<5>({2, 3, 4, 5, 6}, random)),
            .rays = pick<5>({100, 625, 1000, 10000, 250000}, random),
            .sums = random() % 5 < 3};
}

studies::PublishedTables shoot_tables(const SoundHits& hits, const studies::audit::SceneFacts& facts,
                                      std::mt19937_64& random) {
    const auto counts = shoot(facts, hits.rays, random);
    std::vector<Count> areas;
    for (const double area : facts.areas) areas.push_back(std::llround(area * 1e4));
    std::vector<std::string> rows;
    const auto add = [&](const std::string& quantity, const std::string& printed) {
        rows.push_back(fmt::format(R"({{"quantity": "{}", "printed": ["{}"]}})", quantity, printed));
    };
    for (std::size_t i = 0; i < facts.faces(); ++i) {
        Count sum = 0;
        for (std::size_t j = 0; j < facts.faces(); ++j) {
            const Count scaled = hits.reciprocal && j < i ? counts[j][i] * areas[j] : counts[i][j] * areas[i];
            sum += scaled;
            if (i == j) continue;
            add(fmt::format("F {}-{}", facts.labels[i], facts.labels[j]),
                print_fraction(scaled, hits.rays * areas[i], hits));
        }
        if (hits.sums) add("sum " + facts.labels[i], print_fraction(sum, hits.rays * areas[i], hits));
    }
    const std::string text = fmt::format(
        R"({{"source": "s", "scene": "{}", "printing": {{"rule": "{}", "decimals": {}}},)"
        R"("methods": [{{"name": "m", "samples": true, "completion": "{}"}}], "tables": [{{"id": "t",)"
        R"("columns": [{{"method": "m", "patches_per_face": 1, "samples_per_patch": {}}}], "rows": [{}]}}]}})",
        hits.scene,
        !hits.stated     ? "unstated"
        : hits.truncated ? "truncated"
                         : "rounded",
        hits.decimals, hits.reciprocal ? "reciprocal" : "direct", hits.rays, fmt::join(rows, ","));
    return studies::parse_published_tables(text, "t.json");
}

}  // namespace ff::test
