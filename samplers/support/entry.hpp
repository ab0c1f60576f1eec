#pragma once

#include "core/support/contract.hpp"
#include "samplers/sampler.hpp"

#include <memory>

namespace ff::samplers {

/// The one way to make a sampler: a class with
///
///     static constexpr SamplerInfo info{...};
///     explicit T(const PointSetSpec& spec);                                      // the size has been checked
///     void fill(const Stream&, PointIndex first, PointBlock& block) const;       // if info.equal_weights
///     void fill(const Stream&, PointIndex first, WeightedBlock& block) const;    // otherwise
///
/// and, where the number of points does not come from spec.points, `std::uint64_t points() const`; where the rule may
/// be symmetric, `bool exchangeable() const`. `entry<T>()` turns it into a line of the catalogue.
///
/// Point i is a pure function of (spec, stream, i): `fill` gives the same bits for any `first` and any block size.
template <class T>
class ErasedSampler final : public PointSource {
  public:
    explicit ErasedSampler(const PointSetSpec& spec) : sampler_(spec), points_(spec.points) {
        if constexpr (requires { sampler_.points(); }) points_ = sampler_.points();
    }

    [[nodiscard]] std::uint64_t points() const override { return points_; }
    [[nodiscard]] bool randomised() const override { return T::info.randomised; }
    [[nodiscard]] bool equal_weights() const override { return T::info.equal_weights; }
    [[nodiscard]] bool exchangeable() const override {
        if constexpr (requires { sampler_.exchangeable(); }) {
            return sampler_.exchangeable();
        } else {
            return false;
        }
    }

    void fill(const Stream& stream, PointIndex first, PointBlock& block) const override {
        FF_EXPECT(T::info.equal_weights);
        FF_EXPECT(block.size <= block_capacity && first + block.size <= points_);
        if constexpr (T::info.equal_weights) sampler_.fill(stream, first, block);
    }

    void fill(const Stream& stream, PointIndex first, WeightedBlock& block) const override {
        FF_EXPECT(block.size <= block_capacity && first + block.size <= points_);
        if constexpr (T::info.equal_weights) {
            PointSource::fill(stream, first, block);
        } else {
            sampler_.fill(stream, first, block);
        }
    }

  private:
    T sampler_;
    std::uint64_t points_;
};

/// @throws UserError where the sampler cannot have this size or dimension
void require_size(const SamplerInfo& info, const PointSetSpec& spec);

/// The catalogue's line for sampler T.
template <class T>
constexpr CatalogueEntry entry() {
    return {T::info, [](const CatalogueEntry& /*self*/, const PointSetSpec& spec) -> std::unique_ptr<PointSource> {
                require_size(T::info, spec);
                return std::make_unique<ErasedSampler<T>>(spec);
            }};
}

}  // namespace ff::samplers
