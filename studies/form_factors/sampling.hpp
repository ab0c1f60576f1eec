#pragma once

#include "core/stream.hpp"
#include "core/tracer.hpp"
#include "studies/form_factors/face_pairs.hpp"

#include <atomic>
#include <cstdint>
#include <optional>
#include <vector>

namespace ff::studies {

/// Ends a randomisation that nobody waits for any more.
struct Stopped {};

/// Throws Stopped when the flag is set. Null: never.
void expect_more_time(const std::atomic<bool>* stop);

/// One randomisation of the integral over a surface of the factors to what is seen of another.
struct PointSums {
    double visible = 0;        ///< mean factor to what is seen
    double hidden = 0;         ///< mean factor to what is not
    std::uint64_t saw = 0;     ///< points that see something
    std::uint64_t missed = 0;  ///< points that something is hidden from
};

/// Places on one of two surfaces (of two polygons, the smaller), scrambled Sobol' points in two dimensions. The
/// exchange area is that of the source surface times the mean.
class PointSampling {
  public:
    PointSampling(const Scene& scene, const SampledPair& pair);

    [[nodiscard]] double source_area() const { return source_area_; }
    [[nodiscard]] PointSums run(StreamKey key, std::uint32_t randomisation, std::uint64_t points,
                                const std::atomic<bool>* stop) const;

  private:
    const Scene* scene_;
    const SampledPair* pair_;
    std::uint32_t source_;
    std::uint32_t target_;
    double source_area_;
};

/// Rays from one face, by one scrambled Sobol' sequence in four dimensions for all its surfaces: the first coordinate
/// chooses the surface by its share of the area, and what is left of it the place.
class RaySampling {
  public:
    /// @param targets  faces whose hits are wanted: rays leave the surfaces that exchange something unknown with them
    RaySampling(const Scene& scene, const FacePairs& pairs, std::size_t from, std::vector<std::size_t> targets);

    /// Area that rays leave from.
    [[nodiscard]] double source_area() const { return source_area_; }
    [[nodiscard]] const std::vector<std::size_t>& targets() const { return targets_; }

    struct Hits {
        std::vector<std::uint64_t> hits;  ///< by target
        std::uint64_t lost = 0;
    };
    [[nodiscard]] Hits run(const Tracer& tracer, StreamKey key, std::uint32_t randomisation, std::uint64_t rays,
                           const std::atomic<bool>* stop) const;

  private:
    struct Source {
        std::uint32_t surface = 0;
        std::uint64_t first = 0;  ///< coordinate where its share begins, in 2^-32
    };

    const Scene* scene_;
    const FacePairs* pairs_;
    std::size_t from_;
    std::vector<std::size_t> targets_;
    std::vector<std::uint32_t> target_of_face_;
    std::vector<Source> sources_;  ///< and an end
    double source_area_ = 0;

    [[nodiscard]] bool is_shot(std::uint32_t from, std::uint32_t to) const;
};

}  // namespace ff::studies
