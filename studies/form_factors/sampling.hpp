#pragma once

#include "core/points/stream.hpp"
#include "core/tracing/tracer.hpp"
#include "studies/form_factors/division/source_cells.hpp"
#include "studies/form_factors/face_pairs.hpp"

#include <atomic>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace ff::studies::form_factors {

/// Thrown to end a randomisation that is no longer wanted.
struct Stopped {};

/// Throws Stopped when the flag is set. Null: never.
void expect_more_time(const std::atomic<bool>* stop);

/// One randomisation of the exchange area of those parts of a surface that see another one partly.
struct PointSums {
    double visible = 0;  ///< what passes
    double hidden = 0;   ///< what is blocked
};

/// Places on one of two surfaces (of two polygons, the smaller), by scrambled Sobol' points in two dimensions, with
/// extra points in rough cells: for those, the first coordinate chooses the cell and its remainder the place.
class PointSampling {
  public:
    /// @param wanted  relevant exchange area: parts where points could miss more are divided
    PointSampling(const Scene& scene, const SampledPair& pair, double wanted, PointEffort effort = PointEffort::full);

    /// @param sums  of randomisations from `first` on
    void run(StreamKey key, std::uint32_t first, std::uint64_t points, const std::atomic<bool>* stop,
             std::span<PointSums> sums) const;

    /// The exchange area is known + sign * (the mean of randomisations).
    struct Side {
        BoundedValue<double> known;
        double sign = 1;
        UnmetBound unmet;
    };
    [[nodiscard]] Side side(bool hidden) const;
    [[nodiscard]] bool has_sides() const { return pair_->exchange.area.has_value(); }

    /// Points that a randomisation takes per requested point.
    [[nodiscard]] double evaluations() const { return 1 + cells_.extra; }
    /// Time of a point, in rays of a scene of few surfaces.
    [[nodiscard]] double cost() const;

  private:
    const Scene* scene_;
    const SampledPair* pair_;
    std::uint32_t source_;
    std::uint32_t target_;
    SourceCells cells_;
};

/// Time of a ray, in rays of a scene of few surfaces.
double cost_of_ray(const Scene& scene);

/// Rays from one face, by one scrambled Sobol' sequence in four dimensions for all its surfaces: the first coordinate
/// chooses the surface by its share of the area, and its remainder the place.
class RaySampling {
  public:
    /// @param targets  faces whose hits are wanted: rays leave the surfaces with an unknown exchange with them
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
    std::vector<Source> sources_;  ///< and an end
    double source_area_ = 0;

    /// Each face's position among the targets, or a mark that it is not one.
    [[nodiscard]] std::vector<std::uint32_t> targets_of_faces() const;
    [[nodiscard]] bool is_shot(std::uint32_t from, std::uint32_t to) const;
};

}  // namespace ff::studies::form_factors
