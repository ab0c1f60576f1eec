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

std::size_t count_surfaces(const Scene& scene, int face) {
    return static_cast<std::size_t>(
        std::count_if(scene.surfaces.begin(), scene.surfaces.end(), [&](const Surface& s) { return s.face == face; }));
}

using Box = std::array<Extent, 3>;

struct Boxed {
    const Surface* surface;
    Box box;
};

std::vector<Boxed> boxed_surfaces(const Scene& scene, int face) {
    std::vector<Boxed> boxed;
    for (const Surface& surface : scene.surfaces) {
        if (surface.face != face) continue;
        Boxed& one = boxed.emplace_back(Boxed{&surface, {}});
        for (Eigen::Index axis = 0; axis < 3; ++axis)
            one.box.at(static_cast<std::size_t>(axis)) = extent(surface, Eigen::Vector3d::Unit(axis));
    }
    return boxed;
}

/// Whether surfaces in these boxes may touch: most pairs of many surfaces do not, and this is soon seen. There is room
/// for what counts as no gap.
bool are_close(const Box& a, const Box& b) {
    double size = 0;
    double gap = 0;
    for (std::size_t axis = 0; axis < a.size(); ++axis) {
        size = std::max({size, a[axis].high - a[axis].low, b[axis].high - b[axis].low});
        gap = std::max({gap, a[axis].low - b[axis].high, b[axis].low - a[axis].high});
    }
    return gap <= 1e-9 * size;
}

}  // namespace

std::string_view name(PairClass pair_class) {
    switch (pair_class) {
        case PairClass::self:
            return "self";
        case PairClass::parallel:
            return "parallel";
        case PairClass::adjacent:
            return "adjacent";
        case PairClass::other:
            break;
    }
    return "other";
}

PairClass pair_class(const Scene& scene, int from_face, int to_face) {
    FF_EXPECT(from_face >= 0 && static_cast<std::size_t>(from_face) < scene.faces.size());
    FF_EXPECT(to_face >= 0 && static_cast<std::size_t>(to_face) < scene.faces.size());
    if (from_face == to_face) return PairClass::self;
    if (count_surfaces(scene, from_face) * count_surfaces(scene, to_face) > most_surface_pairs) return PairClass::other;
    const std::vector<Boxed> of_from = boxed_surfaces(scene, from_face);
    const std::vector<Boxed> of_to = boxed_surfaces(scene, to_face);
    bool all_parallel = true;
    for (const Boxed& from : of_from) {
        for (const Boxed& to : of_to) {
            if (are_close(from.box, to.box) && meet_along_line(*from.surface, *to.surface)) return PairClass::adjacent;
            all_parallel = all_parallel && are_parallel(*from.surface, *to.surface);
        }
    }
    return all_parallel ? PairClass::parallel : PairClass::other;
}

}  // namespace ff
