#pragma once

#include "core/geometry/scene.hpp"

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
    std::vector<std::uint32_t> first_;  ///< by surface, then the number of all
    std::vector<std::uint32_t> columns_;
};

}  // namespace ff
