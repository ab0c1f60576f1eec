#pragma once

#include "core/geometry/scene.hpp"
#include "core/patches/patch_order.hpp"
#include "core/points/points.hpp"

#include <cstdint>

namespace ff {

/// Who owns a sequence of points.
enum class Allocation {
    patch,  ///< every patch has its own stream
    face,   ///< one stream for all patches of one part of a surface's grid: patch p takes points p*n .. (p+1)*n -
            ///< 1
};

/// The points of a patch: n of them, from `first` on, of a stream with this source.
struct PatchPoints {
    std::uint32_t source = 0;
    PointIndex first = 0;
};

/// Which points every patch of a scene takes; the scene has to outlive it. All sequences are of equal length, whatever
/// the grids.
class PatchSequences {
  public:
    PatchSequences(const Scene& scene, Subdivision subdivision, Allocation allocation, std::uint64_t samples_per_patch);

    /// @param patch  from 0 on the surface
    [[nodiscard]] PatchPoints of(std::uint32_t surface, std::uint32_t patch) const;

    /// How many sequences a surface has.
    [[nodiscard]] std::uint32_t count(std::uint32_t surface) const { return sequences_.count(surface); }

  private:
    const Scene* scene_;
    Subdivision subdivision_;
    Allocation allocation_;
    std::uint64_t samples_;
    PatchOrder sequences_;  ///< numbers the sequences: one for each patch, or for each part of a grid
};

}  // namespace ff
