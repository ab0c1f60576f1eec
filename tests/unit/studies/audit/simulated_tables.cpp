#include "tests/unit/studies/audit/simulated_tables.hpp"

#include "core/configurations/built_in_scene.hpp"
#include "core/exact/exact.hpp"
#include "core/geometry/scene.hpp"

#include <fmt/format.h>
#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace ff::test {
namespace {

constexpr int cube_faces = 6;
constexpr std::uint32_t divisions = 6;
constexpr int rays_per_patch = 700;
constexpr int rays_per_face = divisions * divisions * rays_per_patch;

using Hits = std::array<std::array<int, cube_faces>, cube_faces>;

Hits simulate_hits(std::mt19937_64& random) {
    static const Eigen::MatrixXd factors = exact_patch_to_face(built_in_scene("cube"), Subdivision{divisions}).value();
    Hits hits{};
    for (int face = 0; face < cube_faces; ++face) {
        for (int p = 0; p < static_cast<int>(divisions * divisions); ++p) {
            int rays = rays_per_patch;
            double rest = 1;
            for (int to = 0; to < cube_faces && rays > 0; ++to) {
                const double factor = factors(face * static_cast<int>(divisions * divisions) + p, to);
                if (factor <= 0) continue;
                const double share = std::min(1.0, factor / rest);
                const int drawn = share >= 1 - 1e-12 ? rays : std::binomial_distribution<int>(rays, share)(random);
                hits[static_cast<std::size_t>(face)][static_cast<std::size_t>(to)] += drawn;
                rays -= drawn;
                rest -= factor;
            }
        }
    }
    for (std::size_t i = 0; i < cube_faces; ++i) {
        for (std::size_t j = 0; j < i; ++j) hits[i][j] = hits[j][i];
    }
    return hits;
}

std::string text_of(std::uint64_t seed) {
    std::mt19937_64 random(seed);
    const Hits hits = simulate_hits(random);
    const Eigen::MatrixXd exact = exact_form_factors(built_in_scene("cube")).value();
    const double parallel = 0.1999 + 1e-5 * std::uniform_real_distribution<double>(-1, 1)(random);
    const double adjacent = 0.2004 + 1e-5 * std::uniform_real_distribution<double>(-1, 1)(random);
    const double sum = parallel + 4 * adjacent;

    std::string sums;
    double total = 0;
    for (std::size_t i = 0; i < cube_faces; ++i) {
        int row = 0;
        for (const int h : hits[i]) row += h;
        const double value = static_cast<double>(row) / rays_per_face;
        total += 100 * std::abs(value - 1);
        sums += fmt::format(R"({{"quantity": "sum {}", "printed": ["{:.6f}", "{:.6g}"]}},)", i + 1, sum, value) + "\n";
    }
    sums += fmt::format(R"({{"quantity": "sum of relative errors", "printed": ["{:.2f}", "{:.2f}"]}})",
                        600 * std::abs(sum - 1), total);

    std::string pairs;
    for (int i = 0; i < cube_faces; ++i) {
        for (int j = i + 1; j < cube_faces; ++j) {
            const double reference = exact(i, j);
            const double det = reference < 0.2 ? parallel : adjacent;
            const double mc =
                static_cast<double>(hits[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)]) / rays_per_face;
            if (!pairs.empty()) pairs += ",\n";
            pairs += fmt::format(R"({{"quantity": "F {}-{}", "printed": ["{:.6f}", "{:.2f}", "{:.6g}", "{:.2f}"]}})",
                                 i + 1, j + 1, det, 100 * std::abs(det - reference) / reference, mc,
                                 100 * std::abs(mc - reference) / reference);
        }
    }
    return fmt::format(R"({{
"source": "simulated", "scene": "cube",
"references": {{"parallel": "0.199825", "adjacent": "0.200044"}},
"methods": [{{"name": "DET", "samples": false, "completion": "direct"}},
            {{"name": "MC", "samples": true, "completion": "reciprocal"}}],
"tables": [
{{"id": "sums", "columns": [{{"method": "DET", "patches_per_face": {0}}},
                            {{"method": "MC", "patches_per_face": {0}, "samples_per_patch": {1}}}],
  "rows": [{2}]}},
{{"id": "pairs", "columns": [{{"method": "DET", "patches_per_face": {0}}},
                             {{"method": "DET", "patches_per_face": {0}, "kind": "relative_error"}},
                             {{"method": "MC", "patches_per_face": {0}, "samples_per_patch": {1}}},
                             {{"method": "MC", "patches_per_face": {0}, "samples_per_patch": {1},
                               "kind": "relative_error"}}],
  "rows": [{3}]}}]
}})",
                       divisions * divisions, rays_per_patch, sums, pairs);
}

}  // namespace

std::filesystem::path paper_tables_file() {
    return std::filesystem::path(FF_TEST_DATA) / ".." / ".." / "studies" / "built_in" / "paper_tables.json";
}

studies::PublishedTables simulate_tables(std::uint64_t seed) {
    return studies::parse_published_tables(text_of(seed), "simulated.json");
}

studies::PublishedTables with_print(studies::PublishedTables tables, std::size_t index, std::string printed) {
    tables.figures[index].printed = std::move(printed);
    return tables;
}

std::string with_other_digit(std::string printed, std::size_t position, std::mt19937_64& random) {
    const int shift = std::uniform_int_distribution<int>(1, 9)(random);
    printed[position] = static_cast<char>('0' + (printed[position] - '0' + shift) % 10);
    return printed;
}

}  // namespace ff::test
