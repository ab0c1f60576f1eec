#include "studies/scene_files/winding.hpp"

#include "core/geometry/convex_polygon.hpp"
#include "core/geometry/place_numbers.hpp"
#include "core/geometry/placement.hpp"
#include "core/geometry/surface_map.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace ff::studies {
namespace {

using Eigen::Vector3d;

/// A surface that an edge belongs to.
struct Side {
    std::uint32_t low = 0, high = 0;  ///< numbers of the edge's ends
    int face = 0;
    std::uint32_t surface = 0;
    bool forwards = false;  ///< it runs through the edge from `low` to `high`, counter-clockwise around its normal
};

std::vector<Side> sides_of(const Scene& scene) {
    PlaceNumbers number(resolution_of_places *
                        std::max(farthest_coordinate(scene), std::numeric_limits<double>::min()));
    std::vector<Side> sides;
    std::vector<std::uint32_t> numbers;
    for (std::uint32_t s = 0; s < scene.surfaces.size(); ++s) {
        const Surface& surface = scene.surfaces[s];
        if (surface.face < 0) continue;
        numbers.clear();
        for (const Vector3d& corner : outline(surface)) numbers.push_back(number(corner));
        for (std::size_t k = 0; k < numbers.size(); ++k) {
            const auto [low, high] = std::minmax(numbers[k], next_corner(numbers, k));
            sides.push_back({low, high, surface.face, s, numbers[k] == low});
        }
    }
    return sides;
}

/// Calls use(first, second) for edges that exactly two surfaces have. An edge where bodies or fins meet says nothing.
template <class Use>
void for_each_common_edge(std::vector<Side>& sides, const Use& use) {
    const auto key = [](const Side& side) { return std::pair(side.low, side.high); };
    std::sort(sides.begin(), sides.end(), [&](const Side& a, const Side& b) {
        return std::pair(key(a), a.surface) < std::pair(key(b), b.surface);
    });
    for (std::size_t begin = 0, end = 0; begin < sides.size(); begin = end) {
        while (end < sides.size() && key(sides[end]) == key(sides[begin])) ++end;
        if (end - begin == 2) use(sides[begin], sides[begin + 1]);
    }
}

/// Surfaces that are joined, each with whether it faces the other way than the first.
struct Part {
    std::vector<std::pair<std::uint32_t, bool>> surfaces;
    bool is_one_sided = false;  ///< like Möbius's strip
};

std::vector<Part> parts_of(std::size_t surfaces,
                           const std::vector<std::vector<std::pair<std::uint32_t, bool>>>& joined) {
    constexpr char unseen = 2;
    std::vector<char> side(surfaces, unseen);
    std::vector<Part> parts;
    for (std::uint32_t first = 0; first < surfaces; ++first) {
        if (side[first] != unseen || joined[first].empty()) continue;
        Part part;
        side[first] = 0;
        part.surfaces.emplace_back(first, false);
        for (std::size_t next = 0; next < part.surfaces.size(); ++next) {
            const auto [surface, turned] = part.surfaces[next];
            for (const auto& [other, same_way] : joined[surface]) {
                const char wanted = turned != same_way ? 1 : 0;
                if (side[other] == unseen) {
                    side[other] = wanted;
                    part.surfaces.emplace_back(other, wanted == 1);
                } else {
                    part.is_one_sided = part.is_one_sided || side[other] != wanted;
                }
            }
        }
        parts.push_back(std::move(part));
    }
    return parts;
}

/// The area of other faces that a surface faces and that face it. @param sign  -1 where it is turned round
double area_seen(const Scene& scene, std::uint32_t index, double sign) {
    const Surface& surface = scene.surfaces[index];
    const auto middle_of = [](const Surface& any) {
        const Extent x = extent(any, Vector3d::UnitX()), y = extent(any, Vector3d::UnitY()),
                     z = extent(any, Vector3d::UnitZ());
        return Vector3d((x.low + x.high) / 2, (y.low + y.high) / 2, (z.low + z.high) / 2);
    };
    double sum = 0;
    for (const Surface& other : scene.surfaces) {
        if (other.face < 0 || other.face == surface.face || !is_flat(other.shape)) continue;
        const Vector3d between = middle_of(other) - middle_of(surface);
        if (sign * surface.normal.dot(between) > 0 && other.normal.dot(between) < 0) sum += area(other.shape);
    }
    return sum;
}

}  // namespace

Winding find_winding(const Scene& scene) {
    std::vector<Side> sides = sides_of(scene);
    std::vector<std::vector<std::pair<std::uint32_t, bool>>> joined(scene.surfaces.size());
    bool any = false;
    for_each_common_edge(sides, [&](const Side& a, const Side& b) {
        if (a.face != b.face) return;
        const bool same_way = a.forwards == b.forwards;
        any = any || same_way;
        joined[a.surface].emplace_back(b.surface, same_way);
        joined[b.surface].emplace_back(a.surface, same_way);
    });
    Winding winding;
    if (!any) return winding;
    for (const Part& part : parts_of(scene.surfaces.size(), joined)) {
        std::array<double, 2> areas{};
        for (const auto& [surface, turned] : part.surfaces)
            areas[turned ? 1 : 0] += area(scene.surfaces[surface].shape);
        if (areas[1] == 0) continue;
        constexpr double rounding = 1e-9;
        bool turn_others = areas[1] < areas[0];
        bool is_decided = std::abs(areas[0] - areas[1]) > rounding * areas[0];
        if (!is_decided) {
            std::array<double, 2> seen{};  // as they are but for the others, which are turned; the other way round
            for (const auto& [surface, turned] : part.surfaces) {
                seen[0] += area_seen(scene, surface, turned ? -1 : 1);
                seen[1] += area_seen(scene, surface, turned ? 1 : -1);
            }
            turn_others = seen[0] > seen[1];
            is_decided = seen[0] != seen[1];
        }
        if (part.is_one_sided || !is_decided) {
            winding.undecided.push_back(scene.surfaces[part.surfaces.front().first].face);
            continue;
        }
        for (const auto& [surface, turned] : part.surfaces) {
            if (turned == turn_others) winding.turned.push_back(surface);
        }
    }
    std::sort(winding.turned.begin(), winding.turned.end());
    return winding;
}

std::vector<std::pair<int, int>> faces_wound_differently(const Scene& scene) {
    std::vector<Side> sides = sides_of(scene);
    std::vector<std::pair<int, int>> pairs;
    for_each_common_edge(sides, [&](const Side& a, const Side& b) {
        if (a.face != b.face && a.forwards == b.forwards) pairs.push_back(std::minmax(a.face, b.face));
    });
    std::sort(pairs.begin(), pairs.end());
    pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
    return pairs;
}

}  // namespace ff::studies
