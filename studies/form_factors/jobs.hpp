#pragma once

#include "studies/form_factors/division/sampled_share.hpp"
#include "studies/form_factors/sampling.hpp"

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

namespace ff::studies::form_factors {

/// Fewest rays of a randomisation.
inline constexpr std::uint64_t least_rays = 4096;

/// A unit of sampling: a pair of faces by points, or a row by rays. Its rounds are independent.
class Job {
  public:
    /// A pair of faces by points on each pair of its surfaces.
    /// @param wanted  half width to reach
    Job(const Scene& scene, const FacePairs& pairs, std::size_t pair, double wanted);
    /// Pairs of a face with others, all by rays that leave it.
    Job(const Scene& scene, const FacePairs& pairs, std::size_t from, std::vector<std::size_t> row);

    [[nodiscard]] bool by_points() const { return !rays_; }
    /// Pairs of faces that it estimates.
    [[nodiscard]] const std::vector<std::size_t>& pairs() const { return pairs_; }
    /// Samples of one randomisation: points per pair of surfaces, or rays.
    [[nodiscard]] const std::vector<std::uint64_t>& sizes() const { return sizes_; }
    [[nodiscard]] std::uint64_t samples() const;  ///< per round
    [[nodiscard]] double cost() const { return cost(sizes_); }
    void halve();  ///< halves the sizes, down to the minimum
    [[nodiscard]] bool is_least() const;

    void set_sizes(std::vector<std::uint64_t> sizes) { sizes_ = std::move(sizes); }

    /// Runs some randomisations of a round; others may run on other threads. @param key of its random numbers
    void run(const Tracer* tracer, StreamKey key, std::uint32_t first, std::uint32_t count,
             const std::atomic<bool>* stop);

    /// Chooses what was less uncertain in the last round: the visible part, or the whole minus the hidden part.
    void choose_sides();

    /// The exchange area of one of its pairs, by the last round.
    [[nodiscard]] SampledSum sum(std::size_t pair) const;

    /// Sizes for a half width of at most `wanted[k]` of the k-th pair, by the last round.
    [[nodiscard]] std::vector<std::uint64_t> sizes_for(const std::vector<double>& wanted, double level) const;

    /// The same for one pair of a row by rays.
    [[nodiscard]] std::uint64_t rays_for(std::size_t k, double wanted, double level) const;

    /// Expected time, in rays of a scene of few surfaces.
    [[nodiscard]] double cost(const std::vector<std::uint64_t>& sizes) const;

    [[nodiscard]] std::uint64_t lost() const;  ///< rays of the last round

  private:
    const FacePairs* geometry_;
    std::vector<std::size_t> pairs_;
    double cost_of_ray_ = 1;
    std::optional<RaySampling> rays_;
    std::vector<PointSampling> points_;
    std::vector<bool> hidden_;  ///< for each pair of surfaces: estimate the hidden part
    std::vector<std::uint64_t> sizes_;
    std::vector<std::uint64_t> least_sizes_;
    std::vector<PointSums> point_sums_;        ///< [pair of surfaces * randomisations + randomisation]
    std::vector<RaySampling::Hits> ray_hits_;  ///< [randomisation]

    /// The contribution of the k-th pair of surfaces.
    [[nodiscard]] SampledSum point_sum(std::size_t k, bool hidden) const;
};

/// Points of a randomisation for which the half width falls from `now` to `wanted`.
std::uint64_t size_for(std::uint64_t points, double now, double wanted, double rate);

}  // namespace ff::studies::form_factors
