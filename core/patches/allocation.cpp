#include "core/patches/allocation.hpp"

namespace ff {

PatchSequences::PatchSequences(const Scene& scene, Subdivision subdivision, Allocation allocation,
                               std::uint64_t samples_per_patch)
    : scene_(&scene),
      subdivision_(subdivision),
      allocation_(allocation),
      samples_(samples_per_patch),
      sequences_(scene, allocation == Allocation::patch ? subdivision : Subdivision{1}) {}

PatchPoints PatchSequences::of(std::uint32_t surface, std::uint32_t patch) const {
    const std::uint32_t first = sequences_.first(surface);
    if (allocation_ == Allocation::patch) return {first + patch, 0};
    const std::uint32_t m = subdivision_.m;
    const std::uint32_t parts = scene_->surfaces[surface].grid.columns;
    const std::uint32_t row = patch / (parts * m);
    const std::uint32_t column = patch % (parts * m);
    const std::uint32_t on_part = row % m * m + column % m;
    return {first + row / m * parts + column / m, on_part * samples_};
}

}  // namespace ff
