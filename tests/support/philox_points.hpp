#pragma once

#include "core/points/points.hpp"

namespace ff::test {

/// Independent points straight from `ff::philox`, so that tests of `core` need no sampler.
class PhiloxPoints : public PointSource {
  public:
    explicit PhiloxPoints(std::uint64_t points) : points_(points) {}

    [[nodiscard]] std::uint64_t points() const override { return points_; }
    [[nodiscard]] bool randomised() const override { return true; }
    [[nodiscard]] bool equal_weights() const override { return true; }

    using PointSource::fill;
    void fill(const Stream& stream, PointIndex first, PointBlock& block) const override {
        for (std::size_t i = 0; i < block.size; ++i) {
            const Words words = philox(stream, static_cast<std::uint32_t>(first + i), Purpose::coordinates);
            for (std::size_t d = 0; d < max_dimension; ++d) block.coordinate[d][i] = words[d];
        }
    }

  private:
    std::uint64_t points_;
};

}  // namespace ff::test
