#pragma once

#include "core/points/stream.hpp"
#include "core/tracing/tracer.hpp"
#include "studies/form_factors/face_pairs.hpp"
#include "studies/form_factors/sampled_row.hpp"

#include <atomic>
#include <cstdint>
#include <vector>

namespace ff::studies::form_factors {

/// Fewest rays of a randomisation.
inline constexpr std::uint64_t least_rays = 4096;

/// Pairs of a face with others, all sampled by rays that leave it: one scrambled Sobol' sequence in four dimensions
/// serves all its surfaces whose exchange with the others is unknown. The first coordinate chooses the surface by its
/// share of the area, and its remainder the place. Rounds are independent.
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
    /// @throws Stopped  when the flag is set
    void run(const Tracer& tracer, StreamKey key, std::uint32_t randomisation, const std::atomic<bool>* stop);

    /// The exchange area of one of its pairs, by the last round.
    [[nodiscard]] SampledSum sum(std::size_t pair) const;

    /// Rays for a half width of at most `wanted[k]` of the k-th pair, by the last round.
    [[nodiscard]] std::uint64_t rays_for(const std::vector<double>& wanted, double level) const;

    [[nodiscard]] std::uint64_t lost() const;  ///< rays of the last round that met nothing

  private:
    struct Source {
        std::uint32_t surface = 0;
        std::uint64_t first = 0;  ///< coordinate where its share begins, in 2^-32
    };
    struct Hits {
        std::vector<std::uint64_t> hits;  ///< hits of each pair
        std::uint64_t lost = 0;
    };

    const Scene* scene_;
    const FacePairs* geometry_;
    std::size_t from_;
    std::vector<std::size_t> pairs_;
    std::vector<Source> sources_;  ///< followed by an end marker
    double source_area_ = 0;
    std::uint64_t rays_ = least_rays;
    std::vector<Hits> hits_;  ///< one for each randomisation

    /// The place of each face's pair, or a mark that there is none.
    [[nodiscard]] std::vector<std::uint32_t> pairs_of_faces() const;
    [[nodiscard]] bool is_shot(std::uint32_t from, std::uint32_t to) const;
};

}  // namespace ff::studies::form_factors
