#pragma once

#include "studies/form_factors/sampled_share.hpp"
#include "studies/form_factors/sampling.hpp"

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

namespace ff::studies {

/// One thing that is sampled at a time: a pair of faces by points, or a row by rays. Its rounds are independent.
class Job {
  public:
    /// A pair of faces by points on each pair of its surfaces.
    /// @param wanted  half width that it is to have in the end
    Job(const Scene& scene, const FacePairs& pairs, std::size_t pair, double wanted);
    /// Pairs of a face with others, all by the rays that leave it.
    Job(const Scene& scene, const FacePairs& pairs, std::size_t from, std::vector<std::size_t> row);

    [[nodiscard]] bool by_points() const { return !rays_; }
    /// Pairs of faces that it estimates.
    [[nodiscard]] const std::vector<std::size_t>& pairs() const { return pairs_; }
    /// Samples of one randomisation: of each pair of surfaces, or the rays.
    [[nodiscard]] const std::vector<std::uint64_t>& sizes() const { return sizes_; }
    [[nodiscard]] std::uint64_t samples() const;  ///< of a round
    [[nodiscard]] double cost() const { return cost(sizes_); }
    void halve();  ///< the sizes, down to the least
    [[nodiscard]] bool is_least() const;

    void set_sizes(std::vector<std::uint64_t> sizes) { sizes_ = std::move(sizes); }

    /// One randomisation of a round; others may run on other threads. @param key  of its random numbers
    void run(const Tracer* tracer, StreamKey key, std::uint32_t randomisation, const std::atomic<bool>* stop);

    /// Chooses what is less uncertain by the last round: what is seen, or what is hidden of a known whole.
    void choose_sides();

    /// The exchange area of one of its pairs, by the last round.
    [[nodiscard]] SampledSum sum(std::size_t pair) const;

    /// Sizes for a half width of at most `wanted[k]` of the k-th pair, by the last round.
    [[nodiscard]] std::vector<std::uint64_t> sizes_for(const std::vector<double>& wanted, double level) const;

    /// The same for one pair of a row by rays.
    [[nodiscard]] std::uint64_t rays_for(std::size_t k, double wanted, double level) const;

    /// Expected seconds, in rays.
    [[nodiscard]] double cost(const std::vector<std::uint64_t>& sizes) const;

    [[nodiscard]] std::uint64_t lost() const;  ///< rays of the last round

  private:
    const FacePairs* geometry_;
    std::vector<std::size_t> pairs_;
    std::optional<RaySampling> rays_;
    std::vector<PointSampling> points_;
    std::vector<bool> hidden_;  ///< of each pair of surfaces: the hidden part is taken
    std::vector<std::uint64_t> sizes_;
    std::vector<std::uint64_t> least_sizes_;
    std::vector<std::vector<PointSums>> point_sums_;  ///< [randomisation][pair of surfaces]
    std::vector<RaySampling::Hits> ray_hits_;         ///< [randomisation]

    /// What the k-th pair of surfaces adds.
    [[nodiscard]] SampledSum point_sum(std::size_t k, bool hidden) const;
};

/// Points of a randomisation for which the half width falls from `now` to `wanted`.
std::uint64_t size_for(std::uint64_t points, double now, double wanted, double rate);

}  // namespace ff::studies
