#include "studies/scene_files/builder.hpp"

#include "core/geometry/surface_map.hpp"
#include "studies/scene_files/identity.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <unordered_set>
#include <utility>
#include <variant>
#include <vector>

namespace ff::studies {

/// Keeps the first of several identical surfaces, unless nothing else is left of the face of another. Two that face
/// opposite ways are the sides of a thin plate.
void SceneBuilder::leave_out_doubles() {
    std::vector<std::pair<std::uint64_t, std::size_t>> prints;
    for (const Surface& surface : scene_.surfaces) prints.emplace_back(fingerprint(surface), prints.size());
    std::sort(prints.begin(), prints.end());
    std::vector<bool> is_double(scene_.surfaces.size());
    std::vector<std::pair<std::size_t, std::size_t>> of_two_faces;  // the one that is kept, and the other
    for (std::size_t i = 0; i < prints.size(); ++i) {
        const auto [print, second] = prints[i];
        const Surface& surface = scene_.surfaces[second];
        for (std::size_t k = i; k > 0 && prints[k - 1].first == print; --k) {
            const std::size_t first = prints[k - 1].second;
            if (is_double[first]) continue;
            const Surface& other = scene_.surfaces[first];
            if (numbers_of(other) != numbers_of(surface) || other.normal.dot(surface.normal) < 0) continue;
            if (other.face != surface.face) of_two_faces.emplace_back(first, second);
            is_double[second] = true;
            note(PolygonChange::twice, lines_[second]);
            break;
        }
    }
    std::unordered_set<int> kept;  // faces
    for (std::size_t i = 0; i < is_double.size(); ++i) {
        if (!is_double[i]) kept.insert(scene_.surfaces[i].face);
    }
    for (const auto& [first, second] : of_two_faces) {
        const int face = scene_.surfaces[second].face;
        const int other = scene_.surfaces[first].face;
        if (other == no_face || face == no_face || (has_named_faces_ && !kept.contains(face)))
            fail(lines_[second], "{} is the same as {} of line {} (rays could end on either). Keep one.", owner(face),
                 owner(other), lines_[first]);
    }
    if (!of_two_faces.empty() && has_named_faces_) {
        const auto& [first, second] =
            *std::ranges::min_element(of_two_faces, {}, [](const auto& pair) { return pair.second; });
        std::unordered_set<std::uint64_t> lines;  // a polygon may have become several triangles
        for (const auto& pair : of_two_faces) lines.insert(lines_[pair.second]);
        const std::size_t count = lines.size();
        remark("{} of two faces and {} counted for the first alone ({}'{}' rather than '{}')",
               count == 1 ? "a polygon is" : fmt::format("{} polygons are", count), count == 1 ? "is" : "are",
               count == 1 ? "" : "such as ", name_of(scene_.surfaces[first].face),
               name_of(scene_.surfaces[second].face));
    }
    leave_out(is_double);
}

void SceneBuilder::leave_out(const std::vector<bool>& is_left_out) {
    std::size_t kept = 0;
    for (std::size_t i = 0; i < scene_.surfaces.size(); ++i) {
        if (is_left_out[i]) continue;
        scene_.surfaces[kept] = scene_.surfaces[i];
        lines_[kept++] = lines_[i];
    }
    scene_.surfaces.resize(kept);
    lines_.resize(kept);
}

/// Rounding makes triangles of three corners that were meant to lie in a line: on which side of it they lie is chance,
/// and rays that begin on them may begin behind the neighbouring surface. Where triangles that are no higher than
/// coordinates may be off make up more than a millionth of a face, or of all occluders, they are kept.
void SceneBuilder::leave_out_slivers() {
    constexpr double most_heights = 4;  // three corners may be off by sqrt(3) roundings each, in opposite directions
    constexpr double most_of_face = 1e-6;
    const double height = most_heights * scene_.coordinate_rounding;
    if (height == 0) return;
    struct Areas {
        double all = 0;
        double slivers = 0;
    };
    std::vector<bool> is_sliver(scene_.surfaces.size());
    std::vector<Areas> areas(scene_.faces.size() + 1);  // the last: of occluders
    const auto areas_of = [&](const Surface& surface) -> Areas& {
        return surface.face == no_face ? areas.back() : areas[static_cast<std::size_t>(surface.face)];
    };
    for (std::size_t i = 0; i < is_sliver.size(); ++i) {
        const Surface& surface = scene_.surfaces[i];
        const double own = area(surface.shape);
        areas_of(surface).all += own;
        const auto* triangle = std::get_if<Triangle>(&surface.shape);
        if (triangle == nullptr) continue;
        const double longest = std::max({(triangle->b - triangle->a).norm(), (triangle->c - triangle->b).norm(),
                                         (triangle->a - triangle->c).norm()});
        is_sliver[i] = 2 * own <= height * longest;
        if (is_sliver[i]) areas_of(surface).slivers += own;
    }
    std::unordered_set<std::uint64_t> lines;  // of what is kept
    for (std::size_t i = 0; i < is_sliver.size(); ++i) {
        const Areas& face = areas_of(scene_.surfaces[i]);
        is_sliver[i] = is_sliver[i] && face.slivers <= most_of_face * face.all;
        if (!is_sliver[i]) lines.insert(lines_[i]);
    }
    for (std::size_t i = 0; i < is_sliver.size(); ++i) {
        if (is_sliver[i] && !lines.contains(lines_[i])) note(PolygonChange::no_area, lines_[i]);
    }
    leave_out(is_sliver);
}

}  // namespace ff::studies
