#include "studies/scene_files/orientation.hpp"

#include "core/geometry/convex_polygon.hpp"
#include "core/geometry/scene.hpp"
#include "core/geometry/standing_bodies.hpp"
#include "core/geometry/surface_map.hpp"
#include "core/visibility/level_overlaps.hpp"
#include "studies/scene_files/junctions.hpp"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

namespace ff::studies {
namespace {

using Eigen::Vector3d;

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

/// How much area of other faces surfaces would face that faces them, if some of them were turned round.
class AreasSeen {
  public:
    explicit AreasSeen(const Scene& scene) : scene_(scene) {
        for (const Surface& surface : scene.surfaces) middles_.push_back(box_around(surface).center());
    }

    /// @param turned  those are turned round whose side is this
    [[nodiscard]] double with(const Part& part, bool turned) const {
        constexpr std::size_t most_asked = 1000;
        const std::size_t step = part.surfaces.size() / most_asked + 1;
        double sum = 0;
        for (std::size_t i = 0; i < part.surfaces.size(); i += step) {
            const auto [index, side] = part.surfaces[i];
            sum += seen(index, side == turned ? -1 : 1);
        }
        return sum;
    }

  private:
    const Scene& scene_;
    std::vector<Vector3d> middles_;

    [[nodiscard]] double seen(std::uint32_t index, double sign) const {
        const Surface& surface = scene_.surfaces[index];
        double sum = 0;
        for (std::size_t i = 0; i < middles_.size(); ++i) {
            const Surface& other = scene_.surfaces[i];
            if (other.face < 0 || other.face == surface.face || !is_flat(other.shape)) continue;
            const Vector3d between = middles_[i] - middles_[index];
            if (sign * surface.normal.dot(between) > 0 && other.normal.dot(between) < 0) sum += area(other.shape);
        }
        return sum;
    }
};

/// The sign of the volume that a closed part should have for what is around it: a room faces inwards (-1), a body among
/// other things outwards (1). 0 where nothing tells.
int meant_volume(const Scene& scene, const Part& part) {
    std::vector<bool> is_own(scene.surfaces.size());
    Eigen::AlignedBox3d own;
    for (const auto& [surface, side] : part.surfaces) {
        is_own[surface] = true;
        own.extend(box_around(scene.surfaces[surface]));
    }
    Eigen::AlignedBox3d others;
    for (std::size_t i = 0; i < is_own.size(); ++i) {
        if (is_own[i]) continue;
        const Eigen::AlignedBox3d box = box_around(scene.surfaces[i]);
        if (own.contains(box.center())) return -1;
        others.extend(box);
    }
    return others.contains(own) ? 1 : 0;
}

/// The volume that a closed part would bound, positive where it then faces outwards.
double volume(const Scene& scene, const Part& part, bool turned) {
    double sum = 0;
    const Vector3d origin = box_around(scene.surfaces[part.surfaces.front().first]).center();
    for (const auto& [index, side] : part.surfaces) {
        const Surface& surface = scene.surfaces[index];
        const Vector3d place = corners(surface.shape).front();
        sum += (side == turned ? -1 : 1) * surface.normal.dot(place - origin) * area(surface.shape) / 3;
    }
    return sum;
}

/// Which of two sides is to be turned round; none where it is not known.
using Turned = std::optional<bool>;

/// Whether the first is clearly larger than the second; none where neither is.
Turned larger_of(double first, double second, double clearly) {
    if (first > clearly * second) return true;
    if (second > clearly * first) return false;
    return std::nullopt;
}

/// A closed part faces outwards or inwards; of others, the side is turned without which clearly more of other faces is
/// seen.
Turned by_surroundings(const Scene& scene, const Part& part, bool is_closed) {
    constexpr double clearly_more = 4;
    if (!is_closed) {
        const AreasSeen seen(scene);
        return larger_of(seen.with(part, true), seen.with(part, false), clearly_more);
    }
    const int meant = meant_volume(scene, part);
    if (meant == 0) return std::nullopt;
    return meant * volume(scene, part, true) > 0;
}

/// The side that clearly has the smaller area, unless what is around the part says otherwise; or what that says.
Turned side_to_turn(const Scene& scene, const Part& part, bool is_closed) {
    constexpr double clearly_larger = 1.9;
    if (part.is_one_sided) return std::nullopt;
    std::array<double, 2> areas{};
    for (const auto& [surface, side] : part.surfaces) areas[side ? 1 : 0] += area(scene.surfaces[surface].shape);
    const Turned by_area = larger_of(areas[0], areas[1], clearly_larger);
    const Turned by_others = by_surroundings(scene, part, is_closed);
    if (by_area && by_others && *by_area != *by_others) return std::nullopt;
    return by_area ? by_area : by_others;
}

/// Junctions of what bodies leave of the surfaces that they stand on: at their rims nothing meets what they cover.
std::vector<Junction> junctions_beside_bodies(const Scene& scene) {
    const StandingBodies standing = standing_bodies(scene, level_gap(scene));
    if (!standing.any()) return find_junctions(scene);
    Scene rest = scene;
    rest.surfaces.clear();
    std::vector<std::uint32_t> of;
    for (std::uint32_t i = 0; i < scene.surfaces.size(); ++i) {
        const Surface& whole = scene.surfaces[i];
        if (!standing.left[i]) {
            rest.surfaces.push_back(whole);
        } else {
            for (const ConvexPolygon& polygon : *standing.left[i]) {
                for (std::size_t k = 1; k + 1 < polygon.size(); ++k)
                    rest.surfaces.push_back(
                        {Triangle{polygon[0], polygon[k], polygon[k + 1]}, whole.normal, whole.face});
            }
        }
        of.resize(rest.surfaces.size(), i);
    }
    std::vector<Junction> junctions = find_junctions(rest);
    for (Junction& junction : junctions)
        junction = {of[junction.first], of[junction.second], junction.same_way, junction.certain};
    std::erase_if(junctions, [](const Junction& junction) { return junction.first == junction.second; });
    return junctions;
}

}  // namespace

Winding find_winding(const Scene& scene) {
    const auto is_of_one_face = [&](const Junction& junction) {
        return scene.surfaces[junction.first].face == scene.surfaces[junction.second].face;
    };
    const auto is_fault = [&](const Junction& junction) { return junction.same_way && is_of_one_face(junction); };
    std::vector<Junction> junctions = find_junctions(scene);
    if (std::any_of(junctions.begin(), junctions.end(), is_fault)) junctions = junctions_beside_bodies(scene);
    Winding winding;
    if (std::none_of(junctions.begin(), junctions.end(), is_fault)) return winding;
    std::vector<std::vector<std::pair<std::uint32_t, bool>>> joined(scene.surfaces.size());
    for (const Junction& junction : junctions) {
        if (!junction.certain || !is_of_one_face(junction)) continue;
        joined[junction.first].emplace_back(junction.second, junction.same_way);
        joined[junction.second].emplace_back(junction.first, junction.same_way);
    }
    for (const Part& part : parts_of(scene.surfaces.size(), joined)) {
        const auto is_other_side = [](const auto& surface) { return surface.second; };
        const auto meets_all_around = [&](const auto& surface) {
            const Shape& shape = scene.surfaces[surface.first].shape;
            return is_polygon(shape) && joined[surface.first].size() >= corners(shape).size();
        };
        if (std::ranges::none_of(part.surfaces, is_other_side) && !part.is_one_sided) continue;
        const Turned turned = side_to_turn(scene, part, std::ranges::all_of(part.surfaces, meets_all_around));
        if (!turned) {
            winding.undecided.push_back(scene.surfaces[part.surfaces.front().first].face);
            continue;
        }
        for (const auto& [surface, side] : part.surfaces) {
            if (side == *turned) winding.turned.push_back(surface);
        }
    }
    std::sort(winding.turned.begin(), winding.turned.end());
    const auto is_turned = [&](std::uint32_t surface) {
        return std::binary_search(winding.turned.begin(), winding.turned.end(), surface);
    };
    for (const Junction& junction : junctions) {
        if (!junction.certain && is_of_one_face(junction) &&
            (junction.same_way != is_turned(junction.first)) != is_turned(junction.second))
            winding.undecided.push_back(scene.surfaces[junction.first].face);
    }
    return winding;
}

std::vector<std::pair<int, int>> faces_wound_differently(const Scene& scene) {
    std::vector<std::pair<int, int>> pairs;
    for (const auto& [a, b, same_way, certain] : find_junctions(scene)) {
        const int first = scene.surfaces[a].face;
        const int second = scene.surfaces[b].face;
        if (same_way && certain && first != second) pairs.push_back(std::minmax(first, second));
    }
    std::sort(pairs.begin(), pairs.end());
    pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
    return pairs;
}

}  // namespace ff::studies
