#include "tests/contract/assertions.hpp"
#include "tests/contract/checks.hpp"

#include <array>
#include <functional>
#include <memory>
#include <vector>

namespace ff::test {
namespace {

using samplers::CatalogueEntry;
using testing::AssertionFailure;
using testing::AssertionResult;
using testing::AssertionSuccess;

using Point = std::array<std::uint32_t, max_dimension>;

// Probability of a false alarm by each single test. A sampler has some 25 of them, so 40 samplers raise a false alarm
// once in a million runs.
constexpr double alpha = 1e-9;
constexpr std::uint32_t draws = 60'000;
constexpr std::uint32_t trials = 640;

Stream stream_of(std::uint32_t trial) {
    return {.key = {20261120, 42}, .trial = trial, .source = trial % 7, .target = trial % 3};
}

/// For each trial, a point picked at random (independently of the sampler) from the set, and the one after it.
struct PickedPoints {
    std::vector<Point> picked;
    std::vector<Point> next;
};

PickedPoints pick_points(const CatalogueEntry& sampler) {
    const auto source = sampler.make(usual_spec());
    PickedPoints result;
    PointBlock block;
    block.size = 2;
    for (std::uint32_t trial = 0; trial < draws; ++trial) {
        const std::uint64_t word = philox({.key = {1, 1}}, trial, Purpose::coordinates)[0];
        const PointIndex last = source->points() - 1;
        const PointIndex index = word * source->points() >> 32;
        source->fill(stream_of(trial), index == last ? index - 1 : index, block);
        const std::size_t at = index == last ? 1 : 0;  // the last point has none after it: its pair is the one before
        Point picked{};
        Point next{};
        for (std::size_t d = 0; d < max_dimension; ++d) {
            picked[d] = block.coordinate[d][at];
            next[d] = block.coordinate[d][1 - at];
        }
        result.picked.push_back(picked);
        result.next.push_back(next);
    }
    return result;
}

/// Grid of 8 x 8 cells.
class Grid {
  public:
    void count(std::uint32_t x, std::uint32_t y) { ++counts_[(x >> 29) * 8 + (y >> 29)]; }
    [[nodiscard]] AssertionResult is_uniform(double detects) const {
        return equally_likely(counts_, {.alpha = alpha, .detects = detects, .power = 0.99});
    }

  private:
    std::array<std::uint64_t, 64> counts_{};
};

AssertionResult name_coordinates(const AssertionResult& result, std::size_t a, std::size_t b) {
    return AssertionFailure() << "coordinates " << a << " and " << b << ": " << result.message();
}

/// The mean over the set of a function whose integral is 1.
using Integrand = double (*)(const WeightedBlock&, std::size_t);

constexpr std::array<Integrand, 3> integrands{
    // Smooth, and the first coordinate weighs most.
    [](const WeightedBlock& p, std::size_t i) {
        double product = 1;
        for (std::size_t d = 0; d < max_dimension; ++d) {
            product *= 1 + (p.coordinate[d][i] - 0.5) / static_cast<double>(d + 1);
        }
        return product;
    },
    // Discontinuous along a slanting hyperplane, beside the centre: about it, mirrored points would be exact. The
    // volume
    // below is (1.9^4 - 4 * 0.9^4) / 24.
    [](const WeightedBlock& p, std::size_t i) {
        double sum = 0;
        for (std::size_t d = 0; d < max_dimension; ++d) sum += p.coordinate[d][i];
        return sum < 1.9 ? 24 / 10.4077 : 0.0;
    },
    // Discontinuous across the axes, off the binary grid.
    [](const WeightedBlock& p, std::size_t i) {
        return (p.coordinate[0][i] < 1.0 / 3) != (p.coordinate[3][i] < 0.75) ? 12.0 / 7 : 0.0;
    },
};

double mean_over_set(const PointSource& source, const Stream& stream, Integrand integrand) {
    WeightedBlock block;
    block.size = source.points();
    source.fill(stream, 0, block);
    double sum = 0;
    for (std::size_t i = 0; i < block.size; ++i) sum += block.weight[i] * integrand(block, i);
    return sum;
}

}  // namespace

AssertionResult coordinates_are_uniform(const CatalogueEntry& sampler) {
    const PickedPoints points = pick_points(sampler);
    for (std::size_t d = 0; d < max_dimension; ++d) {
        std::array<std::uint64_t, 16> counts{};
        for (const Point& point : points.picked) ++counts[point[d] >> 28];
        if (const auto result = equally_likely(counts, {.alpha = alpha, .detects = 0.05, .power = 0.99}); !result)
            return AssertionFailure() << "coordinate " << d << ": " << result.message();
    }
    return AssertionSuccess();
}

AssertionResult pairs_are_uniform(const CatalogueEntry& sampler) {
    const PickedPoints points = pick_points(sampler);
    for (std::size_t a = 0; a < max_dimension; ++a) {
        for (std::size_t b = a + 1; b < max_dimension; ++b) {
            Grid grid;
            for (const Point& point : points.picked) grid.count(point[a], point[b]);
            if (const auto result = grid.is_uniform(0.06); !result) return name_coordinates(result, a, b);
        }
    }
    return AssertionSuccess();
}

AssertionResult trials_are_independent(const CatalogueEntry& sampler) {
    const auto source = sampler.make(usual_spec());
    for (std::size_t f = 0; f < integrands.size(); ++f) {
        std::vector<double> even;
        std::vector<double> odd;
        for (std::uint32_t trial = 0; trial < trials; trial += 2) {
            even.push_back(mean_over_set(*source, stream_of(trial), integrands[f]));
            odd.push_back(mean_over_set(*source, stream_of(trial + 1), integrands[f]));
        }
        if (const auto result = uncorrelated(even, odd, {.alpha = alpha, .detects = 0.5, .power = 0.99}); !result)
            return AssertionFailure() << "integrand " << f << ": " << result.message();
    }
    return AssertionSuccess();
}

AssertionResult successive_points_are_free(const CatalogueEntry& sampler) {
    const PickedPoints points = pick_points(sampler);
    for (std::size_t a = 0; a < max_dimension; ++a) {
        Grid grid;
        for (std::size_t i = 0; i < draws; ++i) grid.count(points.picked[i][a], points.next[i][a]);
        if (const auto result = grid.is_uniform(0.06); !result) return name_coordinates(result, a, a);
    }
    return AssertionSuccess();
}

AssertionResult integrates_without_bias(const CatalogueEntry& sampler) {
    const auto source = sampler.make(usual_spec());
    for (std::size_t f = 0; f < integrands.size(); ++f) {
        std::vector<double> means;
        for (std::uint32_t trial = 0; trial < trials; ++trial) {
            means.push_back(mean_over_set(*source, stream_of(trial), integrands[f]));
        }
        // 0.03 of the integral is what 640 trials of 256 independent points show; better sets show less.
        if (const auto result = unbiased(means, 1, {.alpha = alpha, .detects = 0.03, .power = 0.99}); !result)
            return AssertionFailure() << "integrand " << f << ": " << result.message();
    }
    return AssertionSuccess();
}

}  // namespace ff::test
