#include "core/support/error.hpp"
#include "samplers/support/sizes.hpp"
#include "tests/contract/checks.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>
#include <vector>

// Checks that need no statistics.

namespace ff::test {
namespace {

using samplers::CatalogueEntry;
using samplers::PointSetSpec;
using samplers::Sizes;
using testing::AssertionFailure;
using testing::AssertionResult;
using testing::AssertionSuccess;

constexpr Stream usual_stream{.key = {0x12345678, 0x9abcdef0}, .trial = 5, .source = 7, .target = 3};

/// All coordinates of a set as doubles, point by point, made in blocks of the given sizes in turn.
std::vector<double> points_in_blocks(const PointSource& source, const Stream& stream, std::size_t dimension,
                                     const std::vector<std::size_t>& sizes) {
    std::vector<double> result;
    WeightedBlock block;
    block.dimension = dimension;
    PointIndex first = 0;
    for (std::size_t turn = 0; first < source.points(); ++turn, first += block.size) {
        block.size = std::min<std::size_t>(sizes[turn % sizes.size()], source.points() - first);
        source.fill(stream, first, block);
        for (std::size_t i = 0; i < block.size; ++i) {
            for (std::size_t d = 0; d < dimension; ++d) result.push_back(block.coordinate[d][i]);
            result.push_back(block.weight[i]);
        }
    }
    return result;
}

std::vector<double> all_points(const CatalogueEntry& sampler, const Stream& stream) {
    return points_in_blocks(*sampler.make(usual_spec()), stream, max_dimension, {block_capacity});
}

/// Sets large enough for several full blocks.
PointSetSpec large_spec(std::size_t dimension) {
    const std::uint64_t side = dimension == 1 ? 4096 : dimension == 2 ? 64 : dimension == 3 ? 16 : 8;
    return {.points = samplers::integer_power(side, dimension),
            .dimension = dimension,
            .source_nodes = 6,
            .target_nodes = 9};
}

AssertionResult throws_user_error(const CatalogueEntry& sampler, const PointSetSpec& spec) {
    try {
        static_cast<void>(sampler.make(spec));
    } catch (const UserError&) {
        return AssertionSuccess();
    }
    return AssertionFailure() << "made a set of " << spec.points << " points and dimension " << spec.dimension;
}

std::vector<std::uint32_t> coordinates(const PointSource& source, PointIndex first, std::size_t count, std::size_t d) {
    std::vector<std::uint32_t> result;
    PointBlock block;
    for (; result.size() < count; first += block.size) {
        block.size = std::min(block_capacity, count - result.size());
        source.fill(usual_stream, first, block);
        result.insert(result.end(), block.coordinate[d].begin(),
                      block.coordinate[d].begin() + static_cast<std::ptrdiff_t>(block.size));
    }
    return result;
}

AssertionResult each_once(std::vector<std::uint64_t> cells) {
    std::sort(cells.begin(), cells.end());
    for (std::size_t i = 0; i < cells.size(); ++i) {
        if (cells[i] != i) return AssertionFailure() << "cell " << i << " of " << cells.size() << " is not hit once";
    }
    return AssertionSuccess();
}

/// Any multiple * b^m points from a multiple of their number on: `multiple` in each interval of length b^-m, in every
/// coordinate.
AssertionResult fills_intervals(const CatalogueEntry& sampler) {
    const std::uint64_t base = sampler.info.base;
    const std::uint64_t multiple = sampler.info.multiple;
    const auto digits = samplers::count_digits(4097, sampler.info.base) - 1;  // b^digits <= 4096
    const auto source = sampler.make({.points = multiple * samplers::integer_power(base, digits + 1)});
    for (std::size_t m = 1; m <= digits; ++m) {
        const std::uint64_t intervals = samplers::integer_power(base, m);
        for (std::size_t d = 0; d < max_dimension; ++d) {
            for (const PointIndex first : {PointIndex{0}, PointIndex{multiple * intervals}}) {
                std::vector<std::uint64_t> cells;
                for (const std::uint32_t x : coordinates(*source, first, multiple * intervals, d)) {
                    cells.push_back(x * intervals >> 32);
                }
                std::sort(cells.begin(), cells.end());
                for (std::size_t i = 0; i < cells.size(); ++i) cells[i] = cells[i] * multiple + i % multiple;
                if (const auto result = each_once(cells); !result)
                    return AssertionFailure() << "coordinate " << d << ": " << result.message();
            }
        }
    }
    return AssertionSuccess();
}

/// One point in each of k^4 cells.
AssertionResult fills_cells(const CatalogueEntry& sampler) {
    for (const std::uint64_t k : {1u, 2u, 3u, 5u, 7u}) {
        const std::uint64_t points = samplers::integer_power(k, max_dimension);
        const auto source = sampler.make({.points = points});
        std::vector<std::uint64_t> cells(points, 0);
        for (std::size_t d = 0; d < max_dimension; ++d) {
            const auto x = coordinates(*source, 0, points, d);
            for (std::size_t i = 0; i < points; ++i) cells[i] = cells[i] * k + (x[i] * k >> 32);
        }
        if (const auto result = each_once(cells); !result) return result;
    }
    return AssertionSuccess();
}

/// x_d^p integrates to 1 / (p + 1) up to degree 2n - 1, and not at degree 2n, where a rule of n nodes must fail.
AssertionResult integrates_polynomials(const CatalogueEntry& sampler) {
    constexpr std::uint32_t source_nodes = 3;
    constexpr std::uint32_t target_nodes = 4;
    const auto source = sampler.make({.source_nodes = source_nodes, .target_nodes = target_nodes});
    const auto points = points_in_blocks(*source, usual_stream, max_dimension, {block_capacity});
    for (std::size_t d = 0; d < max_dimension; ++d) {
        const std::uint32_t nodes = d < 2 ? source_nodes : target_nodes;
        for (std::uint32_t degree = 0; degree <= 2 * nodes; ++degree) {
            double sum = 0;
            for (std::size_t i = 0; i < points.size(); i += max_dimension + 1) {
                sum += points[i + max_dimension] * std::pow(points[i + d], degree);
            }
            const bool exact = std::abs(sum - 1.0 / (degree + 1)) < 1e-14;
            if (exact != (degree < 2 * nodes))
                return AssertionFailure() << "coordinate " << d << ", degree " << degree << ": " << sum;
        }
    }
    return AssertionSuccess();
}

}  // namespace

PointSetSpec usual_spec() {
    return {.points = 256, .source_nodes = 4, .target_nodes = 4};
}

AssertionResult describes_itself(const CatalogueEntry& sampler) {
    const auto& info = sampler.info;
    if (info.name.empty() || info.summary.empty() || info.reference.empty())
        return AssertionFailure() << "name, summary and reference must not be empty";
    if (info.summary.find('\n') != std::string_view::npos) return AssertionFailure() << "the summary is one line";
    if (info.details.size() < 200) return AssertionFailure() << "details that say next to nothing";
    return AssertionSuccess();
}

AssertionResult refuses_impossible_sets(const CatalogueEntry& sampler) {
    std::vector<PointSetSpec> impossible{{.points = 256, .dimension = 0, .source_nodes = 4, .target_nodes = 4},
                                         {.points = 256, .dimension = 5, .source_nodes = 4, .target_nodes = 4},
                                         {.points = 0}};
    if (sampler.info.sizes != Sizes::nodes) impossible.push_back({.points = samplers::max_points + 1});
    for (const PointSetSpec& spec : impossible) {
        if (const auto result = throws_user_error(sampler, spec); !result) return result;
    }
    return AssertionSuccess();
}

AssertionResult is_pure(const CatalogueEntry& sampler) {
    for (std::size_t dimension = 1; dimension <= max_dimension; ++dimension) {
        const auto source = sampler.make(large_spec(dimension));
        const auto whole = points_in_blocks(*source, usual_stream, dimension, {block_capacity});
        for (const std::vector<std::size_t>& sizes :
             std::vector<std::vector<std::size_t>>{{1}, {16}, {625}, {1000, 3, 1, 17, 1024, 64}}) {
            // Another object of the same spec, so that nothing can be remembered.
            const auto again = points_in_blocks(*sampler.make(large_spec(dimension)), usual_stream, dimension, sizes);
            if (whole != again)
                return AssertionFailure() << "points depend on the blocks they are made in, dimension " << dimension;
        }
    }
    return AssertionSuccess();
}

AssertionResult streams_differ(const CatalogueEntry& sampler) {
    const auto points = all_points(sampler, usual_stream);
    std::vector<Stream> others(5, usual_stream);
    ++others[0].key.word0;
    ++others[1].key.word1;
    ++others[2].trial;
    ++others[3].source;
    ++others[4].target;
    for (std::size_t i = 0; i < others.size(); ++i) {
        const bool differ = all_points(sampler, others[i]) != points;
        if (differ != sampler.info.randomised)
            return AssertionFailure() << (differ ? "two" : "one") << " randomisation(s) in stream variant " << i;
    }
    if (sampler.make(usual_spec())->randomised() != sampler.info.randomised)
        return AssertionFailure() << "the point set contradicts SamplerInfo::randomised";
    return AssertionSuccess();
}

AssertionResult weights_add_up(const CatalogueEntry& sampler) {
    const auto points = all_points(sampler, usual_stream);
    double sum = 0;
    for (std::size_t i = max_dimension; i < points.size(); i += max_dimension + 1) {
        if (!(points[i] > 0)) return AssertionFailure() << "weight " << points[i];
        sum += points[i];
    }
    // 256 roundings of numbers below 1.
    if (std::abs(sum - 1) < 1e-14) return AssertionSuccess();
    return AssertionFailure() << "the weights add up to " << sum;
}

AssertionResult blocks_agree(const CatalogueEntry& sampler) {
    const auto source = sampler.make(usual_spec());
    if (source->equal_weights() != sampler.info.equal_weights)
        return AssertionFailure() << "the point set contradicts SamplerInfo::equal_weights";
    if (!sampler.info.equal_weights) return AssertionSuccess();
    const auto points = all_points(sampler, usual_stream);
    for (std::size_t d = 0; d < max_dimension; ++d) {
        const auto fixed = coordinates(*source, 0, source->points(), d);
        for (std::size_t i = 0; i < fixed.size(); ++i) {
            if (points[i * (max_dimension + 1) + d] != (fixed[i] + 0.5) / 4294967296.0)
                return AssertionFailure() << "point " << i << ", coordinate " << d;
        }
    }
    return AssertionSuccess();
}

AssertionResult fills_its_strata(const CatalogueEntry& sampler) {
    switch (sampler.info.sizes) {
        case Sizes::any:
            return AssertionSuccess();
        case Sizes::powers:
            return fills_intervals(sampler);
        case Sizes::fourth_power:
            return fills_cells(sampler);
        case Sizes::nodes:
            return integrates_polynomials(sampler);
    }
    return AssertionFailure() << "sizes that nobody checks";
}

}  // namespace ff::test
