#include "core/visibility/pair_class.hpp"

#include "core/geometry/surface_map.hpp"
#include "core/support/contract.hpp"
#include "core/visibility/touching.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

namespace ff {
namespace {

using Eigen::AlignedBox3d;

std::vector<AlignedBox3d> boxes_around(const std::vector<const Surface*>& surfaces) {
    std::vector<AlignedBox3d> boxes;
    for (const Surface* surface : surfaces) boxes.push_back(box_around(*surface));
    return boxes;
}

/// Whether surfaces in these boxes may touch: most pairs of many surfaces do not, and this is soon seen. There is room
/// for what counts as no gap.
bool are_close(const AlignedBox3d& a, const AlignedBox3d& b) {
    const double size = std::max(a.sizes().maxCoeff(), b.sizes().maxCoeff());
    const double gap = std::max((a.min() - b.max()).maxCoeff(), (b.min() - a.max()).maxCoeff());
    return gap <= 1e-9 * size;
}

}  // namespace

std::string_view name(PairClass pair_class) {
    constexpr std::array<std::string_view, 4> names{"self", "parallel", "adjacent", "other"};
    return names.at(static_cast<std::size_t>(pair_class));
}

PairClass pair_class(const Scene& scene, int from_face, int to_face) {
    FF_EXPECT(from_face >= 0 && static_cast<std::size_t>(from_face) < scene.faces.size());
    FF_EXPECT(to_face >= 0 && static_cast<std::size_t>(to_face) < scene.faces.size());
    if (from_face == to_face) return PairClass::self;
    const std::vector<const Surface*> from = surfaces_of(scene, from_face);
    const std::vector<const Surface*> to = surfaces_of(scene, to_face);
    if (from.size() * to.size() > most_surface_pairs) return PairClass::other;
    const std::vector<AlignedBox3d> from_boxes = boxes_around(from);
    const std::vector<AlignedBox3d> to_boxes = boxes_around(to);
    bool all_parallel = true;
    for (std::size_t i = 0; i < from.size(); ++i) {
        for (std::size_t j = 0; j < to.size(); ++j) {
            if (are_close(from_boxes[i], to_boxes[j]) && meet_along_line(*from[i], *to[j])) return PairClass::adjacent;
            all_parallel = all_parallel && are_parallel(*from[i], *to[j]);
        }
    }
    return all_parallel ? PairClass::parallel : PairClass::other;
}

}  // namespace ff
