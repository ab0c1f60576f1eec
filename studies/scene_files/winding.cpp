#include "studies/scene_files/orientation.hpp"

#include "core/geometry/scene.hpp"
#include "core/geometry/surface_map.hpp"
#include "studies/scene_files/meetings.hpp"

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

/// Which side of a part is to be turned round: the one with about half of the area of the other or less, or the one
/// without which four times as much is seen of other faces. None where neither is so, or both and they disagree.
std::optional<bool> side_to_turn(const Scene& scene, const Part& part) {
    constexpr double clearly_larger = 1.9;
    constexpr double clearly_more = 4;
    if (part.is_one_sided) return std::nullopt;
    const auto the_lesser = [](double first, double second, double clearly) -> std::optional<bool> {
        if (first > clearly * second) return true;
        if (second > clearly * first) return false;
        return std::nullopt;
    };
    std::array<double, 2> areas{};
    for (const auto& [surface, side] : part.surfaces) areas[side ? 1 : 0] += area(scene.surfaces[surface].shape);
    const auto by_area = the_lesser(areas[0], areas[1], clearly_larger);
    const AreasSeen seen(scene);
    const auto by_sight = the_lesser(seen.with(part, true), seen.with(part, false), clearly_more);
    if (by_area && by_sight && *by_area != *by_sight) return std::nullopt;
    return by_area ? by_area : by_sight;
}

}  // namespace

Winding find_winding(const Scene& scene) {
    std::vector<std::vector<std::pair<std::uint32_t, bool>>> joined(scene.surfaces.size());
    bool any = false;
    for (const auto& [first, second, same_way] : find_meetings(scene)) {
        if (scene.surfaces[first].face != scene.surfaces[second].face) continue;
        any = any || same_way;
        joined[first].emplace_back(second, same_way);
        joined[second].emplace_back(first, same_way);
    }
    Winding winding;
    if (!any) return winding;
    for (const Part& part : parts_of(scene.surfaces.size(), joined)) {
        const bool agree =
            std::none_of(part.surfaces.begin(), part.surfaces.end(), [](const auto& s) { return s.second; });
        if (agree && !part.is_one_sided) continue;
        const std::optional<bool> turned = side_to_turn(scene, part);
        if (!turned) {
            winding.undecided.push_back(scene.surfaces[part.surfaces.front().first].face);
            continue;
        }
        for (const auto& [surface, side] : part.surfaces) {
            if (side == *turned) winding.turned.push_back(surface);
        }
    }
    std::sort(winding.turned.begin(), winding.turned.end());
    return winding;
}

std::vector<std::pair<int, int>> faces_wound_differently(const Scene& scene) {
    std::vector<std::pair<int, int>> pairs;
    for (const auto& [a, b, same_way] : find_meetings(scene)) {
        const int first = scene.surfaces[a].face;
        const int second = scene.surfaces[b].face;
        if (same_way && first != second) pairs.push_back(std::minmax(first, second));
    }
    std::sort(pairs.begin(), pairs.end());
    pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
    return pairs;
}

}  // namespace ff::studies
