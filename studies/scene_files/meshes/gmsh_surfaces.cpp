#include "studies/scene_files/meshes/gmsh_surfaces.hpp"

#include "core/support/excerpt.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <utility>

namespace ff::studies::meshes {

void GmshSurfaces::add(std::int64_t number, const std::vector<std::int64_t>& physical, std::int64_t surface,
                       const Nodes& corners) {
    if (physical.empty()) return add_side(number, 0, surface, corners);
    for (const std::int64_t tag : physical) {
        Nodes side = corners;
        if (tag < 0) std::reverse(side.begin(), side.end());
        // Tags of 64 bits do not occur, but a broken file may hold the one without a counterpart.
        add_side(number, tag < 0 ? -std::max(tag, -INT64_MAX) : tag, surface, std::move(side));
    }
}

void GmshSurfaces::add_side(std::int64_t number, std::int64_t physical, std::int64_t surface, Nodes corners) {
    if (physical != 0) ++sizes_[physical];
    Nodes key = corners;
    std::rotate(key.begin(), std::min_element(key.begin(), key.end()), key.end());
    const auto [known, is_new] = by_corners_.try_emplace(std::move(key), elements_.size());
    if (!is_new) {
        Element& element = elements_[known->second];
        const auto& tags = element.physical;
        // The same element of the same physical surface occurs twice by mistake; a note on that is made for every mesh.
        const bool is_copy = physical == 0 ? tags.empty() : std::find(tags.begin(), tags.end(), physical) != tags.end();
        if (!is_copy && element.surface == surface) {
            if (physical != 0) element.physical.push_back(physical);
            return;
        }
    }
    elements_.push_back({number, surface, std::move(corners), {}});
    if (physical != 0) elements_.back().physical.push_back(physical);
}

std::string GmshSurfaces::group_of(std::int64_t physical, std::int64_t surface) const {
    if (physical == 0) return surface == 0 ? std::string(unnamed_group) : fmt::format("surface_{}", surface);
    const auto name = names_.find(physical);
    return name == names_.end() ? fmt::format("physical_{}", physical) : name->second;
}

void GmshSurfaces::write_to(SurfaceMesh& mesh) const {
    std::size_t several = 0;
    std::set<std::string> others;
    for (const Element& element : elements_) {
        const auto smaller = [&](std::int64_t a, std::int64_t b) {
            return std::pair(sizes_.at(a), a) < std::pair(sizes_.at(b), b);
        };
        const auto chosen = std::min_element(element.physical.begin(), element.physical.end(), smaller);
        const std::string group = group_of(chosen == element.physical.end() ? 0 : *chosen, element.surface);
        mesh.add_polygon(group, element.corners, fmt::format("element {}", element.number));
        if (element.physical.size() < 2) continue;
        ++several;
        for (const std::int64_t tag : element.physical) {
            if (const std::string other = group_of(tag, element.surface); other != group) others.insert(other);
        }
    }
    if (others.empty()) return;
    constexpr std::size_t most_named = 3;
    std::vector<std::string> names;
    for (const std::string& other : others) {
        if (names.size() < most_named) names.push_back(fmt::format("'{}'", excerpt(other)));
    }
    std::string list = fmt::format("{}", fmt::join(names, ", "));
    if (others.size() > most_named) list += fmt::format(" and {} more", others.size() - most_named);
    mesh.remark(fmt::format(
        "{} in several physical surfaces, and belong{} to the one with the fewest elements, not "
        "to {}",
        several == 1 ? "1 element is" : fmt::format("{} elements are", several), several == 1 ? "s" : "", list));
}

}  // namespace ff::studies::meshes
