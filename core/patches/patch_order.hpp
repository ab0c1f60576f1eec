#pragma once

#include "core/geometry/subdivision.hpp"
#include "core/points/points.hpp"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace ff {

/// Where a patch lies.
struct PatchPlace {
    std::uint32_t surface = 0;  ///< index into Scene::surfaces
    std::uint32_t row = 0;
    std::uint32_t column = 0;
};

/// The surfaces whose patches are numbered.
enum class Numbered {
    all,
    of_faces,  ///< no mirrors, nothing that only stands in the way
};

/// The numbers of the patches of a scene, from 0: surface by surface, on each row by row of its grid.
class PatchOrder {
  public:
    /// @pre at most 2^32 - 1 patches
    PatchOrder(const Scene& scene, Subdivision subdivision, Numbered numbered = Numbered::all);

    [[nodiscard]] std::uint32_t size() const { return first_.back(); }
    /// The first patch of a surface, and how many it has.
    [[nodiscard]] std::uint32_t first(std::size_t surface) const { return first_[surface]; }
    [[nodiscard]] std::uint32_t count(std::size_t surface) const { return first_[surface + 1] - first_[surface]; }
    [[nodiscard]] PatchPlace place(std::uint32_t patch) const;

  private:
    std::vector<std::uint32_t> first_;  ///< first patch of each surface, then the number of all patches
    std::vector<std::uint32_t> columns_;
};

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
