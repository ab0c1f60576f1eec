#pragma once

#include "core/points/stream.hpp"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace ff::stats {

/// The purpose of random numbers; two purposes never share a number of one key. The values are part of what is drawn.
enum class Resampling : std::uint32_t { bootstrap = 1, jitter = 3, simulation = 4 };

/// A sequence of random numbers for resampling: Philox words in counter order, so that replicate r is the same whatever
/// was drawn for others.
class Draws {
  public:
    Draws(StreamKey key, Resampling use, std::uint32_t replicate);

    /// Uniform in [0, 1), 53 bits.
    double uniform();
    /// Uniform in 0 .. n - 1, without modulo bias. @pre 1 <= n < 2^32
    std::size_t below(std::size_t n);

  private:
    std::uint32_t word();

    Stream stream_;
    Words words_{};
    std::uint32_t block_ = 0;
    std::uint32_t used_ = 4;
};

/// Fills `sample` with values drawn from `data` with replacement. @pre data not empty
void resample(std::span<const double> data, Draws& draws, std::span<double> sample);

/// Student's t of samples of n that are drawn from values less their mean: how it is distributed where nothing is
/// biased and trials are like these values. Samples that are all equal are left out.
std::vector<double> resampled_t(std::span<const double> values, std::size_t n, std::size_t samples, StreamKey key);

/// The number of resamples and the key of their random numbers.
struct ResamplingPlan {
    StreamKey key;                    ///< e.g. derive_key(seed, "bootstrap SR 1-2")
    std::uint32_t replicates = 1999;  ///< (replicates + 1) * alpha / 2 should be whole
};

}  // namespace ff::stats
