#include "core/geometry/placement.hpp"
#include "core/visibility/mirrors.hpp"
#include "core/visibility/standing.hpp"
#include "studies/readers/printable.hpp"
#include "studies/scene_files/doubt_words.hpp"
#include "studies/scene_files/formats.hpp"
#include "studies/scene_files/level_doubts.hpp"
#include "studies/scene_files/orientation.hpp"
#include "studies/scene_files/scene_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace ff::studies {
namespace {

constexpr std::size_t most_surfaces_examined = 65536;
constexpr std::size_t most_faces_examined = 4096;
/// The rounding of coordinates is noticeable above this share of a face's size, which is the root of its area.
constexpr double noticeable = 1e-9;

void add_round_bodies(const Scene& scene, SceneDoubts& doubts) {
    std::set<std::pair<int, int>> faces;
    for (const auto& [body, ground] : round_bodies_on_surfaces(scene))
        faces.emplace(scene.surfaces[body].face, scene.surfaces[ground].face);
    for (const auto& [body, ground] : faces) {
        if (ground < 0) continue;
        add(doubts.notes, scene,
            "{} stands on {} (what round surfaces cover is not left out: it counts as a part of the face that nothing "
            "else reaches). To leave it out, cut it out in the file, or make polygons by 'ffstudy convert --facets'.",
            face_in_words(scene, body), face_in_words(scene, ground));
    }
}

void add_covered(const Scene& scene, SceneDoubts& doubts) {
    constexpr std::size_t most_named = 3;
    const auto share = [](const CoveredPart& part) {
        return part.area == part.whole ? "all" : fmt::format("{:.3g} %", 100 * part.area / part.whole);
    };
    if (scene.covered.size() > most_named) {
        std::vector<CoveredPart> parts = scene.covered;
        std::ranges::stable_sort(parts, std::greater(), [](const auto& part) { return part.area / part.whole; });
        std::vector<std::string> all;
        for (const CoveredPart& part : parts) all.push_back(fmt::format("{} of '{}'", share(part), part.face));
        add(doubts.notes, scene,
            "{} faces are covered, by bodies that stand on them or by what they stand on: {} (these parts are left "
            "out, and areas are those of the rest)",
            parts.size(), first_names(std::move(all), most_named));
        return;
    }
    for (const CoveredPart& part : scene.covered) {
        add(doubts.notes, scene, "{} of face '{}' is covered, by a body that stands on it or by what it stands on ({})",
            share(part), part.face,
            part.area == part.whole ? "the face is left out"
                                    : "that part is left out, and its area is that of the rest");
    }
}

void add_remarks(const Scene& scene, SceneDoubts& doubts) {
    for (const std::string& remark : scene.remarks) add(doubts.notes, scene, "{}", remark);
}

/// Edges that two polygons run through in the same direction, so that they do not bound a body.
void add_winding(const Scene& scene, SceneDoubts& doubts) {
    const Winding winding = find_winding(scene);
    std::set<int> faces(winding.undecided.begin(), winding.undecided.end());
    for (const std::size_t surface : winding.turned) faces.insert(scene.surfaces[surface].face);
    for (const int face : faces)
        add(doubts.faults, scene,
            "surfaces of face '{}' meet in an edge and face opposite ways (what the turned ones send is lost). {}",
            name_of_face(scene, face),
            has_extension(scene.name, ".toml")
                ? "Turn some of them round (flip, or facing of a curved surface), or make them two faces."
                : "Write the corners of each counter-clockwise as seen from the side that radiates.");
    if (scene.closed) return;  // rays tell more
    const auto pairs = faces_wound_differently(scene);
    if (pairs.empty()) return;
    const auto& [first, second] = pairs.front();
    add(doubts.notes, scene,
        "faces '{}' and '{}'{} run through a common edge in the same direction (one of them may face the wrong way)",
        name_of_face(scene, first), name_of_face(scene, second), and_other_pairs(pairs.size() - 1));
}

void add_resolution(const Scene& scene, SceneDoubts& doubts) {
    const Placement placement = placement_of(scene);
    const double rounding = 16 * rounding_of_far_coordinates(scene, placement);
    const double farthest =
        rounding > 0 ? farthest_coordinate(scene) : farthest_coordinate(placed(scene, placement)) * placement.unit;
    const double step = std::max(rounding, 4 * std::numeric_limits<double>::epsilon() * farthest);
    std::vector<std::size_t> small;
    double least = std::numeric_limits<double>::max();
    for (std::size_t face = 0; face < scene.faces.size(); ++face) {
        const double size = std::sqrt(face_area(scene, static_cast<int>(face)));
        if (step > noticeable * size) small.push_back(face);
        least = std::min(least, size);
    }
    if (small.empty()) return;
    add(doubts.notes, scene,
        "{} {} small beside coordinates of {:.2g} (which are rounded: {}factors of a face of size {:.2g} are known to "
        "{:.1g} at best)",
        names(scene, small), small.size() == 1 ? "is" : "are", farthest, rounding > 0 ? "" : "sampled ", least,
        step / least);
}

/// Coordinates with so few digits that faces are not where they were meant.
void add_rounding(const Scene& scene, SceneDoubts& doubts) {
    constexpr double too_much = 0.01;  // share of a face's size
    std::vector<std::size_t> small;
    for (std::size_t face = 0; face < scene.faces.size(); ++face) {
        if (scene.coordinate_rounding > too_much * std::sqrt(face_area(scene, static_cast<int>(face))))
            small.push_back(face);
    }
    if (small.empty()) return;
    add(doubts.faults, scene,
        "coordinates seem to be rounded to {:.1g}, which is more than a hundredth of the size of {}. Write them with "
        "more digits, or move the scene to the origin first.",
        2 * scene.coordinate_rounding, names(scene, small));
}

/// A room whose walls face outwards, whether or not it is said to be closed: no front sees a front, but backs see
/// backs.
bool is_inside_out(const SideProbes& probes) {
    std::size_t rays = 0;
    std::size_t between_fronts = 0;
    std::size_t between_backs = 0;
    for (std::size_t from = 0; from < probes.faces; ++from) {
        rays += probes.rays[2 * from + 1];
        for (std::size_t to = 0; to < probes.faces; ++to) {
            between_fronts += probes.met(from, 0, to, 0);
            between_backs += probes.met(from, 1, to, 1);
        }
    }
    return between_fronts == 0 && 2 * between_backs > rays;
}

std::string how_to_turn(const Scene& scene, std::size_t faces) {
    return fmt::format("Turn {} round: {}.", faces == 1 ? "it" : "them",
                       has_extension(scene.name, ".toml") ? "set flip, or facing of a curved surface"
                                                          : "reverse the order of the corners of each polygon");
}

/// A mesh that is one face sees mostly itself where it is a room.
void add_single_face(const Scene& scene, const SideProbes& probes, SceneDoubts& doubts) {
    if (scene.faces.size() == 1 && is_read_as_obj(scene.name) && 2 * probes.met(0, 0, 0, 0) > probes.rays[0])
        add(doubts.notes, scene, "all polygons are one face, which sees mostly itself (see --faces polygon)");
}

void add_orientation(const Scene& scene, SceneDoubts& doubts) {
    const SideProbes probes = probe_sides(scene);
    add_single_face(scene, probes, doubts);
    const bool known = mirrors(scene).empty();
    if (known && is_inside_out(probes)) {
        // The outside of a convex body, alone in open space, looks like a room that is inside out.
        const bool may_be_meant = !scene.closed && !probes.any_met(0);
        add(may_be_meant ? doubts.notes : doubts.faults, scene,
            "faces seem to face outwards (no ray from a radiating side meets another, while most from the backs meet "
            "backs). {}{}",
            may_be_meant ? "If a room is meant, it is inside out. " : "", how_to_turn(scene, scene.faces.size()));
        return;
    }
    std::vector<std::size_t> leaking;
    std::vector<std::size_t> on_backs;  // mostly
    std::size_t lost = 0;
    std::size_t rays = 0;
    std::size_t from_backs = 0;
    for (std::size_t face = 0; face < probes.faces; ++face) {
        std::size_t backs = 0;
        for (std::size_t to = 0; to < probes.faces; ++to) backs += probes.met(face, 0, to, 1);
        rays += probes.rays[2 * face];
        if (probes.lost[2 * face] > 0) leaking.push_back(face);
        lost += probes.lost[2 * face];
        if (2 * backs > probes.rays[2 * face]) on_backs.push_back(face);
        from_backs += backs;
    }
    const bool leaks = scene.closed && lost > 0;
    const std::vector<std::size_t> turned = known ? turned_faces(probes, scene.closed) : std::vector<std::size_t>();
    if (!turned.empty()) {
        std::vector<std::string> ends;
        if (from_backs > 0) ends.push_back(fmt::format("{} end on backs", from_backs));
        if (leaks) ends.push_back(fmt::format("{} meet nothing", lost));
        add(scene.closed ? doubts.faults : doubts.notes, scene,
            "{} {} to face the wrong way (of {} rays, {}; with {} turned round, hardly any would). {}",
            names(scene, turned), turned.size() == 1 ? "seems" : "seem", rays, fmt::join(ends, " and "),
            turned.size() == 1 ? "it" : "them", how_to_turn(scene, turned.size()));
        return;
    }
    if (leaks) {
        // What passes through a small gap is measured with the form factors, and is not a fault below their tolerance.
        constexpr double small = 0.01;
        const bool is_small = probes.area_lost <= small * probes.area;
        add(is_small ? doubts.notes : doubts.faults, scene,
            "{} of {} rays meet nothing, though the scene is said to be closed (a {}, as seen from {}). Close it, or "
            "do not say that it is closed.",
            lost, rays, is_small ? "gap" : "hole", names(scene, leaking));
    }
    if (!on_backs.empty()) {
        add(doubts.notes, scene, "most rays from {} end on backs (normals may face the wrong way)",
            names(scene, on_backs));
    }
}

}  // namespace

SceneDoubts examine_scene(const Scene& scene) {
    SceneDoubts doubts;
    if (scene.empty_box) return doubts;
    add_remarks(scene, doubts);
    add_covered(scene, doubts);
    if (scene.surfaces.size() <= most_surfaces_examined) {
        add_winding(scene, doubts);
        add_round_bodies(scene, doubts);
    }
    add_overlaps(scene, doubts);
    if (scene.faces.size() <= most_faces_examined) {
        add_resolution(scene, doubts);
        add_rounding(scene, doubts);
    }
    if (scene.surfaces.size() <= most_surfaces_examined && scene.faces.size() <= most_faces_examined)
        add_orientation(scene, doubts);
    return doubts;
}

std::vector<std::string> doubts_about(const Scene& scene) {
    SceneDoubts doubts = examine_scene(scene);
    doubts.faults.insert(doubts.faults.end(), doubts.notes.begin(), doubts.notes.end());
    return doubts.faults;
}

}  // namespace ff::studies
