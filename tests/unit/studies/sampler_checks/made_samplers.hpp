#pragma once

#include "samplers/outside/added.hpp"
#include "samplers/outside/outside_points.hpp"
#include "studies/sampler_checks/sampler_checks.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>
#include <random>
#include <string>
#include <vector>

namespace ff::studies::test {

/// Points of a set, [point][dimension], made from random numbers of its own.
using Rows = std::vector<std::vector<double>>;
using MakeRows = std::function<Rows(std::size_t n, std::size_t d, std::mt19937_64& random)>;

inline double uniform(std::mt19937_64& random) {
    return std::uniform_real_distribution<double>()(random);
}

inline samplers::PointSet set_of(const Rows& rows) {
    samplers::PointSet set{rows.size(), rows.front().size(), 1, {}};
    for (std::size_t d = 0; d < set.dimension; ++d)
        for (const auto& row : rows) set.coordinate.push_back(static_cast<std::uint32_t>(row[d] * 0x1p32));
    return set;
}

/// A sampler of any size that makes its sets in this way.
inline std::unique_ptr<samplers::AddedSampler> sampler_of(const std::string& name, const MakeRows& rows) {
    const samplers::MakeSet make = [rows](const samplers::SetRequest& request, samplers::PointSet& set) {
        std::mt19937_64 random(request.seed);
        set = set_of(rows(request.points, request.dimension, random));
    };
    return std::make_unique<samplers::AddedSampler>(
        samplers::AddedSampler::Texts{name, "made for a test", ""}, samplers::SamplerInfo{},
        std::vector<std::uint64_t>{}, [make](const samplers::PointSetSpec& spec) {
            return samplers::outside_points(spec.points, true, samplers::parts_of(make));
        });
}

inline Rows random_rows(std::size_t n, std::size_t d, std::mt19937_64& random) {
    Rows rows(n, std::vector<double>(d));
    for (auto& row : rows)
        for (double& x : row) x = uniform(random);
    return rows;
}

/// A Latin hypercube; where `random_share` is above 0, that share of the points is placed at random instead.
inline Rows latin_rows(std::size_t n, std::size_t d, std::mt19937_64& random, double random_share = 0) {
    Rows rows(n, std::vector<double>(d));
    for (std::size_t j = 0; j < d; ++j) {
        std::vector<std::size_t> slice(n);
        for (std::size_t i = 0; i < n; ++i) slice[i] = i;
        std::shuffle(slice.begin(), slice.end(), random);
        const auto kept = n - static_cast<std::size_t>(std::lround(random_share * static_cast<double>(n)));
        for (std::size_t i = kept; i < n; ++i) slice[i] = random() % n;
        for (std::size_t i = 0; i < n; ++i)
            rows[i][j] = (static_cast<double>(slice[i]) + uniform(random)) / static_cast<double>(n);
    }
    return rows;
}

/// Coordinate d of point i of Sobol' in two dimensions: van der Corput, and Pascal's matrix. @pre d < 2
inline std::uint32_t net_word(std::uint32_t i, std::size_t d) {
    std::uint32_t word = 0;
    std::uint32_t direction = 1u << 31;
    for (; i != 0; i >>= 1) {
        if (i & 1u) word ^= direction;
        direction = d == 0 ? direction >> 1 : direction ^ direction >> 1;
    }
    return word;
}

/// Points of a net from `first` on, with a digital shift or one modulo 1. @pre d <= 2
inline Rows net_rows(std::size_t n, std::size_t d, std::mt19937_64& random, std::size_t first, bool digital) {
    Rows rows(n, std::vector<double>(d));
    for (std::size_t j = 0; j < d; ++j) {
        const auto shift = static_cast<std::uint32_t>(random());
        for (std::size_t i = 0; i < n; ++i) {
            const std::uint32_t word = net_word(static_cast<std::uint32_t>(first + i), j);
            rows[i][j] = (digital ? word ^ shift : word + shift) * 0x1p-32;
        }
    }
    return rows;
}

/// The checks of this sampler that have this verdict and, if it is given, this name.
inline std::vector<std::string> found(const SamplerChecks& checks, SamplerVerdict verdict,
                                      const std::string& name = {}) {
    std::vector<std::string> result;
    for (const SamplerCheck& check : checks.checks) {
        if (check.verdict == verdict && (name.empty() || check.name == name))
            result.push_back(check.name + ": " + check.found);
    }
    return result;
}

}  // namespace ff::studies::test
