#include "studies/scene_files/builder.hpp"

#include "core/geometry/convex_polygon.hpp"
#include "core/geometry/ear_clipping.hpp"
#include "core/geometry/standing_bodies.hpp"
#include "core/geometry/surface_map.hpp"
#include "core/support/error.hpp"
#include "core/support/excerpt.hpp"
#include "core/visibility/level_overlaps.hpp"
#include "studies/readers/printable.hpp"
#include "studies/scene_files/coordinate_rounding.hpp"
#include "studies/scene_files/identity.hpp"
#include "studies/scene_files/orientation.hpp"
#include "studies/scene_files/scene_with_materials.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

namespace ff::studies {
namespace {

using Eigen::Vector3d;

constexpr double most_bend = 1e-6;  // how far corners may be off the plane of a polygon, relative to its size
constexpr double parallelogram_gap = 1e-12;
/// Smallest area of a surface, relative to the square of its size: rounding alone leaves less.
constexpr double least_share_of_area = 1e-12;
constexpr std::array<std::string_view, 3> labels_of_sums{"all", "sum", "sum_re"};
constexpr double largest_length = 1e30;  // squares of areas are numbers, in single precision lengths too

/// The largest distance of a corner from the first.
double size_from_first(const std::vector<Vector3d>& corners) {
    double size = 0;
    for (const Vector3d& corner : corners) size = std::max(size, (corner - corners[0]).norm());
    return size;
}

/// The messages for one polygon, and for several.
constexpr std::array<std::pair<std::string_view, std::string_view>, 6> words_of_changes{{
    {"has no area and is left out", "have no area and are left out"},
    {"is a copy of another, not the other side of a sheet, and is left out",
     "are copies of others, not the other sides of sheets, and are left out"},
    {"is not plane and is divided into triangles", "are not plane and are divided into triangles"},
    {"is not convex and is divided into triangles", "are not convex and are divided into triangles"},
    {"is wound in the opposite direction to the rest of its face and is turned round",
     "are wound in the opposite direction to the rest of their faces and are turned round"},
    {"has an outline that runs back along itself, and is read without that spike",
     "have outlines that run back along themselves, and are read without these spikes"},
}};

}  // namespace

int SceneBuilder::face(const std::string& label, std::uint64_t line) {
    if (const auto known = faces_.find(label); known != faces_.end()) return known->second;
    std::string allowed = label;
    std::replace(allowed.begin(), allowed.end(), '|', '_');
    if (allowed != label) names_with_bars_.push_back(fmt::format("'{}'", excerpt(label)));
    if (const auto problem = problem_with_name(allowed); !problem.empty()) {
        constexpr std::string_view before_formulas = "=@+-";
        if (before_formulas.find(allowed.front()) == std::string_view::npos ||
            !problem_with_name("_" + allowed).empty())
            fail(line, "face '{}' {}", excerpt(label), problem);
        formulas_.push_back(fmt::format("'{}'", label));
        allowed = "_" + allowed;
    }
    if (allowed != label) {
        scene_.faces.push_back(reserve_name(allowed, false));
        return faces_[label] = static_cast<int>(scene_.faces.size()) - 1;
    }
    const bool is_of_sums = std::find(labels_of_sums.begin(), labels_of_sums.end(), label) != labels_of_sums.end();
    const std::string name = reserve_name(label, is_of_sums);
    if (is_of_sums) {
        remark("face '{}' is called '{}', since results have sums under that name", label, name);
    }
    scene_.faces.push_back(name);
    return faces_[label] = static_cast<int>(scene_.faces.size()) - 1;
}

std::string SceneBuilder::free_name(const std::string& label, bool numbered) const {
    std::string name = label;
    for (std::size_t k = 2; numbered || faces_.contains(name) || names_.contains(name); ++k, numbered = false)
        name = fmt::format("{}.{}", label, k);
    return name;
}

std::string SceneBuilder::reserve_name(const std::string& label, bool numbered) {
    return *names_.insert(free_name(label, numbered)).first;
}

int SceneBuilder::new_face(const std::string& label, std::uint64_t line) {
    return face(free_name(label), line);
}

std::string SceneBuilder::owner(int face) const {
    return face == no_face
               ? std::string("an occluder")
               : fmt::format("a surface of face '{}'", excerpt(scene_.faces[static_cast<std::size_t>(face)]));
}

void SceneBuilder::fail(std::uint64_t line, std::string_view problem) const {
    if (!has_lines_) throw UserError("{}: {}", name_, problem);
    throw UserError("{}:{}: {}", name_, line, problem);
}

void SceneBuilder::note(const Vector3d& place) {
    constexpr std::size_t enough = 10'000;
    for (const double coordinate : place) {
        if (coordinate != 0 && coordinates_.size() < enough) coordinates_.insert(std::abs(coordinate));
    }
}

void SceneBuilder::add(Surface surface, std::uint64_t line) {
    has_windings_ = false;
    if (const auto* p = std::get_if<Parallelogram>(&surface.shape)) {
        for (const Vector3d& given : {p->corner, p->edge_u, p->edge_v}) note(given);
    } else if (const auto* disc = std::get_if<Disc>(&surface.shape)) {
        note(disc->centre);
    } else {
        for (const Vector3d& corner : corners(surface.shape)) note(corner);
    }
    append(std::move(surface), line);
}

void SceneBuilder::append(Surface surface, std::uint64_t line) {
    double size = 0;
    for (Eigen::Index axis = 0; axis < 3; ++axis) {
        const Extent along = extent(surface, Vector3d::Unit(axis));
        // Written so that NaN fails as well.
        if (!(std::max(std::abs(along.low), std::abs(along.high)) <= largest_length)) {
            fail(line, "{} reaches beyond {:g}. Use another unit of length.", owner(surface.face), largest_length);
        }
        size = std::max(size, along.high - along.low);
    }
    if (!(area(surface.shape) > least_share_of_area * size * size)) {
        fail(line, "{} has no area (nothing leaves it or arrives). Remove it.", owner(surface.face));
    }
    scene_.surfaces.push_back(std::move(surface));
    lines_.push_back(line);
}

bool SceneBuilder::has_area(const std::vector<Vector3d>& corners, std::uint64_t line) {
    const double size = size_from_first(corners);
    // Surfaces that are too large to decide are refused later.
    if (size > largest_length || twice_area(corners).norm() > least_share_of_area * size * size) return true;
    const Vector3d farthest = *std::ranges::max_element(
        corners, {}, [&](const Vector3d& corner) { return (corner - corners[0]).squaredNorm(); });
    const auto is_off = [&](const Vector3d& corner) {
        return distance(corner, corners[0], farthest) > most_bend * size;
    };
    if (without_spikes(corners).size() > 3 && std::ranges::any_of(corners, is_off))
        fail(line, "edges of a polygon cross each other (its parts cancel out). Divide it into triangles.");
    note(PolygonChange::no_area, line);
    return false;
}

void SceneBuilder::add_polygon(const std::vector<Vector3d>& outline, int face, std::uint64_t line) {
    if (size_from_first(outline) > largest_length)
        fail(line, "{} reaches beyond {:g}. Use another unit of length.", owner(face), largest_length);
    const std::vector<Vector3d> corners = without_spikes(outline);
    if (corners.size() < outline.size()) note(PolygonChange::spiked, line);
    const std::size_t n = corners.size();
    const double size = size_from_first(corners);
    for (const Vector3d& corner : outline) note(corner);
    const Vector3d normal = twice_area(corners).normalized();
    bool is_convex = true;  // but for corners that are meant to lie in a line with their neighbours
    bool is_strictly_convex = true;
    double turned = 0;  // once around where it is convex, more in a star
    for (std::size_t i = 0; i < n; ++i) {
        const Vector3d& next = next_corner(corners, i);
        const Vector3d along = next - corners[i];
        const Vector3d onwards = corners[(i + 2) % n] - next;
        const double turn = along.cross(onwards).dot(normal);
        const double turn_of_right_angle = along.norm() * onwards.norm();
        is_convex = is_convex && turn >= -most_bend * turn_of_right_angle;
        is_strictly_convex = is_strictly_convex && turn >= -least_share_of_area * turn_of_right_angle;
        turned += std::atan2(turn, along.dot(onwards));
    }
    is_convex = is_convex && turned < 3 * std::numbers::pi;
    const bool is_plane = std::all_of(corners.begin(), corners.end(), [&](const Vector3d& corner) {
        return std::abs(normal.dot(corner - corners[0])) <= most_bend * size;
    });
    if (n == 4 && (corners[0] + corners[2] - corners[1] - corners[3]).norm() <= parallelogram_gap * size) {
        append({Parallelogram{corners[0], corners[1] - corners[0], corners[3] - corners[0]}, normal, face}, line);
        return;
    }
    std::vector<std::array<std::size_t, 3>> triangles;
    if (!is_plane || !is_strictly_convex) triangles = clip_ears(corners);
    if (triangles.empty() && is_plane && is_convex) {
        for (std::size_t i = 1; i + 1 < n; ++i) triangles.push_back({0, i, i + 1});
    } else if (triangles.empty()) {
        fail(line, "edges of {} cross or touch each other. Divide it into triangles.", owner(face));
    } else if (!is_convex || !is_plane) {
        note(is_convex ? PolygonChange::bent : PolygonChange::concave, line);
    }
    for (const auto& [a, b, c] : triangles) {
        const Vector3d own = (corners[b] - corners[a]).cross(corners[c] - corners[a]);
        if (!(own.norm() > least_share_of_area * size * size)) continue;  // three corners in a line
        append({Triangle{corners[a], corners[b], corners[c]}, own.normalized(), face}, line);
    }
}

void SceneBuilder::cut_out_covered_parts() {
    const StandingBodies standing = standing_bodies(scene_, level_gap(scene_));
    if (!standing.any()) return;
    const auto faces = scene_.faces.size();
    std::vector<double> before(faces);
    for (std::size_t face = 0; face < faces; ++face) before[face] = face_area(scene_, static_cast<int>(face));
    const std::vector<Surface> surfaces = std::exchange(scene_.surfaces, {});
    for (std::size_t i = 0; i < surfaces.size(); ++i) {
        if (!standing.left[i]) {
            scene_.surfaces.push_back(surfaces[i]);
        } else {
            for (const ConvexPolygon& polygon : *standing.left[i]) add_polygon(polygon, surfaces[i].face, lines_[i]);
        }
    }
    for (std::size_t face = 0; face < faces; ++face) {
        const double after = face_area(scene_, static_cast<int>(face));
        constexpr double rounding = 1e-12;
        if (before[face] - after > rounding * before[face])
            scene_.covered.push_back({scene_.faces[face], before[face] - after, before[face]});
    }
}

void SceneBuilder::leave_out_empty_faces(std::vector<FaceMaterial>* materials) {
    std::vector<bool> has_surfaces(scene_.faces.size());
    for (const Surface& surface : scene_.surfaces) {
        if (surface.face >= 0) has_surfaces[static_cast<std::size_t>(surface.face)] = true;
    }
    std::vector<int> number(scene_.faces.size(), no_face);
    std::vector<std::string> kept;
    std::vector<FaceMaterial> kept_materials;
    for (std::size_t face = 0; face < scene_.faces.size(); ++face) {
        if (!has_surfaces[face]) continue;
        number[face] = static_cast<int>(kept.size());
        kept.push_back(scene_.faces[face]);
        if (materials != nullptr && face < materials->size()) kept_materials.push_back((*materials)[face]);
    }
    for (Surface& surface : scene_.surfaces) {
        if (surface.face >= 0) surface.face = number[static_cast<std::size_t>(surface.face)];
    }
    scene_.faces = std::move(kept);
    if (materials != nullptr) *materials = std::move(kept_materials);
}

/// Remarks on the number of polygons for each kind of change, with their first lines.
void SceneBuilder::remark_on_changes() {
    constexpr std::size_t most_named = 3;
    for (std::size_t kind = 0; kind < changes_.size(); ++kind) {
        std::vector<std::uint64_t>& lines = changes_[kind];
        if (lines.empty()) continue;
        const auto& [one, many] = words_of_changes[kind];
        std::sort(lines.begin(), lines.end());
        // A polygon may have become several triangles.
        lines.erase(std::unique(lines.begin(), lines.end()), lines.end());
        const std::string what =
            lines.size() == 1 ? fmt::format("a polygon {}", one) : fmt::format("{} polygons {}", lines.size(), many);
        const std::size_t left = lines.size() - std::min(lines.size(), most_named);
        lines.resize(lines.size() - left);
        const std::string places =
            fmt::format(" ({} {}{})", lines.size() == 1 ? "line" : "lines", fmt::join(lines, ", "),
                        left > 0 ? fmt::format(" and {} more", left) : "");
        remark("{}{}", what, has_lines_ ? places : "");
    }
}

/// Remarks on names that were changed, with the first of each kind.
void SceneBuilder::remark_on_names() {
    constexpr std::size_t most_named = 3;
    if (!names_with_bars_.empty())
        remark("{} written with _ for | here, which would break tables",
               first_names(names_with_bars_, most_named) + (names_with_bars_.size() == 1 ? " is" : " are"));
    if (!formulas_.empty())
        remark("{} with _ here, since spreadsheets would take {} for {}",
               first_names(formulas_, most_named) + (formulas_.size() == 1 ? " begins" : " begin"),
               formulas_.size() == 1 ? "the name" : "the names", formulas_.size() == 1 ? "a formula" : "formulas");
}

Scene SceneBuilder::finish(bool closed, std::vector<FaceMaterial>* materials) {
    if (scene_.faces.empty()) throw UserError("{}: no face (nothing would be computed). Add one.", name_);
    std::vector<std::size_t> surfaces_of(scene_.faces.size());
    for (const Surface& surface : scene_.surfaces) {
        if (surface.face != no_face) ++surfaces_of[static_cast<std::size_t>(surface.face)];
    }
    for (std::size_t face = 0; face < surfaces_of.size(); ++face) {
        if (surfaces_of[face] == 0)
            throw UserError("{}: face '{}' has no surface. Remove it, or give it one.", name_, scene_.faces[face]);
    }
    Eigen::AlignedBox3d box;
    for (const Surface& surface : scene_.surfaces) box.extend(box_around(surface));
    const std::vector<double> coordinates(coordinates_.begin(), coordinates_.end());
    scene_.coordinate_rounding = coordinate_rounding(coordinates, box.sizes().maxCoeff());
    scene_.coordinate_step = coordinate_step(coordinates, box.sizes().maxCoeff());
    leave_out_doubles();
    leave_out_slivers();
    for (const std::size_t surface : has_windings_ ? find_winding(scene_).turned : std::vector<std::size_t>()) {
        scene_.surfaces[surface].normal *= -1;
        note(PolygonChange::turned, lines_[surface]);
    }
    remark_on_changes();
    remark_on_names();
    scene_.name = name_;
    scene_.closed = closed;
    cut_out_covered_parts();
    leave_out_empty_faces(materials);
    if (scene_.faces.empty())
        throw UserError(
            "{}: faces cover each other wholly (nothing would be computed). Remove those that are not meant.", name_);
    scene_.canonical = canonical_of(scene_);
    return std::move(scene_);
}

}  // namespace ff::studies
