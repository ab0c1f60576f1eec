#pragma once

#include "core/points/stream.hpp"
#include "core/tracing/tracer.hpp"
#include "studies/form_factors/face_pairs.hpp"

#include <atomic>
#include <cstdint>
#include <vector>

namespace ff::studies::form_factors {

/// Rays from one face, by one scrambled Sobol' sequence in four dimensions for all its surfaces: the first coordinate
/// chooses the surface by its share of the area, and its remainder the place.
class RaySampling {
  public:
    /// @param targets  faces whose hits are wanted: rays leave the surfaces with an unknown exchange with them
    RaySampling(const Scene& scene, const FacePairs& pairs, std::size_t from, std::vector<std::size_t> targets);

    /// Area that rays leave from.
    [[nodiscard]] double source_area() const { return source_area_; }

    struct Hits {
        std::vector<std::uint64_t> hits;  ///< by target
        std::uint64_t lost = 0;
    };
    /// @throws Stopped  when the flag is set
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
    std::vector<Source> sources_;  ///< and an end
    double source_area_ = 0;

    /// Each face's position among the targets, or a mark that it is not one.
    [[nodiscard]] std::vector<std::uint32_t> targets_of_faces() const;
    [[nodiscard]] bool is_shot(std::uint32_t from, std::uint32_t to) const;
};

}  // namespace ff::studies::form_factors
