#include "core/pair_class.hpp"

#include "core/contract.hpp"
#include "core/touching.hpp"

#include <algorithm>
#include <cstddef>

namespace ff {
namespace {

/// Beyond so many pairs of surfaces a relation is not looked for: it takes the product of two faces' surfaces.
constexpr std::size_t most_pairs = 1u << 22;

std::size_t surfaces_of(const Scene& scene, int face) {
    return static_cast<std::size_t>(
        std::count_if(scene.surfaces.begin(), scene.surfaces.end(), [&](const Surface& s) { return s.face == face; }));
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
    if (surfaces_of(scene, from_face) * surfaces_of(scene, to_face) > most_pairs) return PairClass::other;
    bool all_parallel = true;
    for (const Surface& from : scene.surfaces) {
        if (from.face != from_face) continue;
        for (const Surface& to : scene.surfaces) {
            if (to.face != to_face) continue;
            if (meet_along_line(from, to)) return PairClass::adjacent;
            all_parallel = all_parallel && are_parallel(from, to);
        }
    }
    return all_parallel ? PairClass::parallel : PairClass::other;
}

}  // namespace ff
