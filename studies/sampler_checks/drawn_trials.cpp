#include "studies/sampler_checks/drawn_trials.hpp"

#include "samplers/point_sets/parts.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace ff::studies {
namespace {

constexpr double plane_at = 0.475;  // sum of coordinates on the plane, over the dimension

/// Volume of the part of the unit cube where the coordinates sum to less than s (Irwin and Hall).
double volume_below(double s, std::size_t dimension) {
    double sum = 0;
    double choose = 1;
    for (std::size_t k = 0; static_cast<double>(k) < s; ++k) {
        sum += (k % 2 == 0 ? choose : -choose) * std::pow(s - static_cast<double>(k), dimension);
        choose *= static_cast<double>(dimension - k) / static_cast<double>(k + 1);
    }
    return sum / std::tgamma(static_cast<double>(dimension) + 1);
}

struct Integrands {
    std::size_t dimension;
    double volume = volume_below(plane_at * static_cast<double>(dimension), dimension);
    double step = dimension == 1 ? 3.0 : 12.0 / 7;

    /// Values at the middle of a cell of width 2^-32; where a step crosses the cell, at its upper end.
    [[nodiscard]] std::array<double, 3> at(const std::array<std::uint32_t, max_dimension>& cell) const {
        double product = 1;
        double sum = 0;
        for (std::size_t d = 0; d < dimension; ++d) {
            product *= 1 + ((cell[d] + 0.5) * 0x1p-32 - 0.5) / static_cast<double>(d + 1);
            sum += (cell[d] + 1.0) * 0x1p-32;
        }
        const bool low = samplers::part_of(cell[0], 3) == 0;
        const bool high = dimension > 1 && samplers::part_of(cell[dimension - 1], 4) == 3;
        return {product, sum <= plane_at * static_cast<double>(dimension) ? 1 / volume : 0.0,
                low == (dimension == 1 || high) ? step : 0.0};
    }

    [[nodiscard]] std::array<double, 3> largest() const {
        double product = 1;
        for (std::size_t d = 0; d < dimension; ++d) product *= 1 + 0.5 / static_cast<double>(d + 1);
        return {product, 1 / volume, step};
    }
};

/// Mixes the bits of a point's coordinates: the finaliser of SplitMix64 after each. @see [steele2014]
std::uint64_t fingerprint_of(const std::array<std::uint32_t, max_dimension>& cell, std::size_t dimension) {
    std::uint64_t bits = 0;
    for (std::size_t d = 0; d < dimension; ++d) {
        bits += cell[d] + 0x9e3779b97f4a7c15ULL;
        bits = (bits ^ bits >> 30U) * 0xbf58476d1ce4e5b9ULL;
        bits = (bits ^ bits >> 27U) * 0x94d049bb133111ebULL;
        bits ^= bits >> 31U;
    }
    return bits;
}

/// Counts points in slices, trial by trial.
class SliceCounter {
  public:
    SliceCounter(std::uint64_t points, std::size_t dimension)
        : points_(points), sums_(dimension), in_slice_(points * dimension, 0), in_wide_(dimension) {}

    void add(const PointBlock& block) {
        for (std::size_t d = 0; d < block.dimension; ++d) {
            std::uint32_t* const counts = &in_slice_[d * points_];
            std::uint64_t shared = 0;
            for (std::size_t i = 0; i < block.size; ++i) {
                const std::uint32_t x = block.coordinate[d][i];
                shared += counts[samplers::part_of(x, points_)]++;
                for (std::size_t k = 0; k < wide_slices.size(); ++k)
                    ++in_wide_[d][k][samplers::part_of(x, wide_slices[k])];
            }
            sums_[d].shared += static_cast<double>(shared);
        }
    }

    void end_trial() {
        const auto points = static_cast<double>(points_);
        for (std::size_t d = 0; d < sums_.size(); ++d) {
            for (std::size_t k = 0; k < wide_slices.size(); ++k) {
                const auto slices = static_cast<double>(wide_slices[k]);
                double squares = 0;
                for (std::size_t slice = 0; slice < wide_slices[k]; ++slice) {
                    const double deviation = static_cast<double>(in_wide_[d][k][slice]) - points / slices;
                    squares += deviation * deviation;
                }
                sums_[d].variance[k] += squares / (points * (1 - 1 / slices));
            }
        }
        std::ranges::fill(in_slice_, 0u);
        std::ranges::fill(in_wide_, WideCounts{});
    }

    [[nodiscard]] std::vector<SliceCounts> averages(std::uint64_t trials) const {
        std::vector<SliceCounts> result = sums_;
        for (SliceCounts& one : result) {
            one.shared /= static_cast<double>(trials);
            for (double& variance : one.variance) variance /= static_cast<double>(trials);
        }
        return result;
    }

  private:
    using WideCounts = std::array<std::array<std::uint64_t, wide_slices.back()>, wide_slices.size()>;

    std::uint64_t points_;
    std::vector<SliceCounts> sums_;
    std::vector<std::uint32_t> in_slice_;  ///< [dimension][slice]
    std::vector<WideCounts> in_wide_;
};

}  // namespace

DrawnTrials draw_trials(const PointSource& source, std::size_t dimension, StreamKey key, std::uint64_t trials) {
    const Integrands integrands{dimension};
    const std::uint64_t points = source.points();
    DrawnTrials drawn;
    drawn.largest = integrands.largest();
    std::optional<SliceCounter> slices;
    if (points <= most_for_slices) slices.emplace(points, dimension);
    PointBlock block;
    block.dimension = dimension;
    for (std::uint64_t trial = 0; trial < trials; ++trial) {
        const Stream stream{.key = key, .trial = static_cast<std::uint32_t>(trial)};
        // Picks have another key, so that they are independent of what the sampler does with its own key.
        const Stream picks{.key = {key.word1, ~key.word0}, .trial = stream.trial};
        const std::uint64_t pick = philox(picks, 0, Purpose::coordinates)[0] * points >> 32;
        std::array<double, 3> sums{};
        std::uint64_t fingerprint = 0;
        for (PointIndex first = 0; first < points; first += block.size) {
            block.size = std::min<std::uint64_t>(block_capacity, points - first);
            source.fill(stream, first, block);
            if (slices) slices->add(block);
            for (std::size_t i = 0; i < block.size; ++i) {
                std::array<std::uint32_t, max_dimension> cell{};
                for (std::size_t d = 0; d < dimension; ++d) cell[d] = block.coordinate[d][i];
                fingerprint += fingerprint_of(cell, dimension);
                const auto values = integrands.at(cell);
                for (std::size_t f = 0; f < sums.size(); ++f) sums[f] += values[f];
            }
            if (first <= pick && pick < first + block.size) {
                auto& picked = drawn.picked.emplace_back();
                for (std::size_t d = 0; d < dimension; ++d) picked[d] = block.coordinate[d][pick - first];
            }
        }
        for (std::size_t f = 0; f < sums.size(); ++f) drawn.means[f].push_back(sums[f] / static_cast<double>(points));
        drawn.fingerprints.push_back(fingerprint);
        if (slices) slices->end_trial();
    }
    if (slices) drawn.slices = slices->averages(trials);
    return drawn;
}

}  // namespace ff::studies
