#include "studies/scene_files/level_doubts.hpp"

#include "core/geometry/outlines.hpp"
#include "core/geometry/placement.hpp"
#include "core/visibility/level_overlaps.hpp"
#include "core/visibility/standing.hpp"
#include "studies/scene_files/doubt_words.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace ff::studies {
namespace {

/// Overlaps of less of either face are no fault in a closed scene.
constexpr double slight_share = 1e-6;

/// "faces 'a' and 'b'", or "surfaces of face 'a'" where both are the same.
std::string in_words(const Scene& scene, std::pair<int, int> faces) {
    const auto [low, high] = faces;
    if (low == high) return "surfaces of " + face_in_words(scene, low);
    if (low < 0) return fmt::format("an occluder and {}", face_in_words(scene, high));
    return fmt::format("faces '{}' and '{}'", name_of_face(scene, low), name_of_face(scene, high));
}

/// The two sides of a thin wall may be as close to each other as they like.
void add_near(const Scene& scene, const LevelOverlap& overlap, SceneDoubts& doubts) {
    const auto [low, high] = std::minmax(scene.surfaces[overlap.first].face, scene.surfaces[overlap.second].face);
    if (!overlap.same_side || high < 0) return;
    std::string note = fmt::format(
        "scene '{}': {} lie over each other, less than a millionth of their size apart (the one in front is taken to "
        "hide the other)",
        scene.name, in_words(scene, {low, high}));
    if (std::find(doubts.notes.begin(), doubts.notes.end(), note) == doubts.notes.end())
        doubts.notes.push_back(std::move(note));
}

/// Faces of which a body may cover a part.
void add_grounds_in_doubt(const Scene& scene, SceneDoubts& doubts) {
    std::set<std::size_t> grounds;
    for (const std::uint32_t surface : grounds_in_doubt(scene)) {
        if (scene.surfaces[surface].face >= 0) grounds.insert(static_cast<std::size_t>(scene.surfaces[surface].face));
    }
    if (grounds.empty()) return;
    add(doubts.faults, scene,
        "a body may stand on {}: coordinates that may be rounded to {:.1g} do not tell (what it covers is not left "
        "out). Write coordinates with more digits, or cut the face out beneath it.",
        names(scene, {grounds.begin(), grounds.end()}), scene.coordinate_step);
}

/// Pairs of faces, or of a face and an occluder, that may have been drawn in one plane.
void add_in_doubt(const Scene& scene, std::set<std::pair<int, int>> pairs, SceneDoubts& doubts) {
    pairs.erase({-1, -1});
    if (pairs.empty()) return add_grounds_in_doubt(scene, doubts);
    const auto [low, high] = *pairs.begin();
    add(doubts.faults, scene,
        "{} and {}{} lie over each other, nearer than coordinates tell that may be rounded to {:.1g} (which of them "
        "hides the other is not known). Write coordinates with more digits, or move them farther apart.",
        face_in_words(scene, high), low == high ? "itself" : face_in_words(scene, low),
        and_other_pairs(pairs.size() - 1), scene.coordinate_step);
}

/// What two faces, or the surfaces of one, have in common in one plane.
struct Common {
    double area = 0;
    bool by_rounding = true;
};

/// Keys: whether they face the same way, and the two faces.
using CommonParts = std::map<std::tuple<bool, int, int>, Common>;

void add_common_parts(const Scene& scene, const CommonParts& parts, SceneDoubts& doubts) {
    std::vector<std::pair<int, int>> slight;
    std::vector<std::pair<int, int>> back_to_back;
    double largest = 0;
    for (const auto& [key, common] : parts) {
        const auto& [same_side, low, high] = key;
        const std::string& face = name_of_face(scene, high);
        const double area = face_area(scene, high);
        const double smaller = low < 0 ? area : std::min(area, face_area(scene, low));
        const double share = 100 * common.area / area;
        if (same_side && (common.by_rounding || (scene.closed && low >= 0 && common.area <= slight_share * smaller))) {
            slight.emplace_back(low, high);
            largest = std::max(largest, 100 * common.area / smaller);
        } else if (low < 0) {
            add(same_side ? doubts.faults : doubts.notes, scene,
                "an occluder lies on face '{}' in one plane and covers {:.3g} % of it (it is taken to lie behind the "
                "face and hides nothing of it). Move it a little in front of the face, or cut the face out beneath it.",
                face, share);
        } else if (same_side && low == high) {
            add(doubts.faults, scene,
                "surfaces of face '{}' lie over each other in one plane, {:.3g} % of it (what lies twice is counted "
                "twice). Remove one of them.",
                face, share);
        } else if (same_side) {
            add(doubts.faults, scene,
                "faces '{}' and '{}' lie over each other in one plane and radiate to the same side, {:.3g} % of '{}' "
                "(neither is taken to hide the other: what arrives there is counted for one or for both). Move the one "
                "that is seen a little to the front, or cut the other out beneath it.",
                name_of_face(scene, low), face, share, face);
        } else {
            back_to_back.emplace_back(low, high);
        }
    }
    // In a closed scene it is measured with the form factors, like gaps.
    if (!slight.empty())
        add(doubts.notes, scene,
            "{}{} overlap in one plane by at most {:.3g} % of a face, no more than rounded corners explain (what lies "
            "twice is counted twice)",
            in_words(scene, slight.front()), and_other_pairs(slight.size() - 1), largest);
    if (!back_to_back.empty())
        add(doubts.notes, scene,
            "{}{} lie in one plane back to back (they are taken for the two sides of a thin wall: nothing passes "
            "between them)",
            in_words(scene, back_to_back.front()), and_other_pairs(back_to_back.size() - 1));
}

}  // namespace

void add_overlaps(const Scene& scene, SceneDoubts& doubts) {
    const Placement placement = placement_of(scene);
    const Scene where = placed(scene, placement);
    CommonParts parts;
    std::set<std::pair<int, int>> in_doubt;
    std::vector<std::uint32_t> bodies;
    const auto are_sides_of_a_sheet = [&](const LevelOverlap& overlap) {
        if (bodies.empty()) bodies = Outlines(where, level_gap(where)).bodies();
        return !overlap.same_side && bodies[overlap.first] == bodies[overlap.second];
    };
    for (const LevelOverlap& overlap : level_overlaps(where)) {
        if (overlap.in_doubt) {
            if (are_sides_of_a_sheet(overlap)) continue;
            in_doubt.insert(std::minmax(scene.surfaces[overlap.first].face, scene.surfaces[overlap.second].face));
            continue;
        }
        if (!overlap.level) {
            add_near(scene, overlap, doubts);
            continue;
        }
        const auto [low, high] = std::minmax(scene.surfaces[overlap.first].face, scene.surfaces[overlap.second].face);
        if (high < 0) continue;  // overlapping occluders are harmless
        Common& common = parts[{overlap.same_side, low, high}];
        common.area += overlap.area * placement.unit * placement.unit;
        common.by_rounding = common.by_rounding && overlap.by_rounding;
    }
    add_in_doubt(scene, in_doubt, doubts);
    add_common_parts(scene, parts, doubts);
}

}  // namespace ff::studies
