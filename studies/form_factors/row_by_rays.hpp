#pragma once

#include "studies/form_factors/ray_sampling.hpp"
#include "studies/form_factors/sampled_share.hpp"

#include <atomic>
#include <cstdint>
#include <vector>

namespace ff::studies::form_factors {

/// Fewest rays of a randomisation.
inline constexpr std::uint64_t least_rays = 4096;

/// Pairs of a face with others, all by rays that leave it. Rounds are independent.
class RowByRays {
  public:
    /// @param pairs  by their place in FacePairs::pairs
    RowByRays(const Scene& scene, const FacePairs& geometry, std::size_t from, std::vector<std::size_t> pairs);

    [[nodiscard]] const std::vector<std::size_t>& pairs() const { return pairs_; }
    /// Rays of one randomisation of the next round.
    [[nodiscard]] std::uint64_t rays() const { return rays_; }
    void set_rays(std::uint64_t rays) { rays_ = rays; }
    /// Rays of the next round.
    [[nodiscard]] std::uint64_t samples() const { return randomisations * rays_; }

    /// Runs a randomisation of a round; others may run on other threads. @param key of its random numbers
    void run(const Tracer& tracer, StreamKey key, std::uint32_t randomisation, const std::atomic<bool>* stop);

    /// The exchange area of one of its pairs, by the last round.
    [[nodiscard]] SampledSum sum(std::size_t pair) const;

    /// Rays for a half width of at most `wanted[k]` of the k-th pair, by the last round.
    [[nodiscard]] std::uint64_t rays_for(const std::vector<double>& wanted, double level) const;

    [[nodiscard]] std::uint64_t lost() const;  ///< rays of the last round

  private:
    const FacePairs* geometry_;
    std::vector<std::size_t> pairs_;
    RaySampling sampling_;
    std::uint64_t rays_ = least_rays;
    std::vector<RaySampling::Hits> hits_;  ///< by randomisation
};

}  // namespace ff::studies::form_factors
