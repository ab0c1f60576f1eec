#include "core/patches/patch_order.hpp"

#include "core/support/contract.hpp"
#include "core/visibility/mirrors.hpp"

#include <algorithm>
#include <limits>

namespace ff {

PatchOrder::PatchOrder(const Scene& scene, Subdivision subdivision, Numbered numbered) : first_{0} {
    FF_EXPECT(subdivision.patches(scene) <= std::numeric_limits<std::uint32_t>::max());
    for (const Surface& surface : scene.surfaces) {
        const Grid grid = subdivision.of(surface);
        const bool counts = numbered == Numbered::all || is_of_face(surface);
        first_.push_back(first_.back() + (counts ? grid.parts() : 0));
        columns_.push_back(grid.columns);
    }
}

PatchPlace PatchOrder::place(std::uint32_t patch) const {
    FF_EXPECT(patch < size());
    const auto next = std::upper_bound(first_.begin(), first_.end(), patch);
    const auto surface = static_cast<std::uint32_t>(next - first_.begin() - 1);
    const std::uint32_t on_surface = patch - first_[surface];
    return {surface, on_surface / columns_[surface], on_surface % columns_[surface]};
}

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
