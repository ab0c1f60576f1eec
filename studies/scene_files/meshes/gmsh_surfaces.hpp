#pragma once

#include "core/support/excerpt.hpp"
#include "studies/readers/printable.hpp"
#include "studies/scene_files/meshes/formats.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

namespace ff::studies::meshes {

/// Collects the elements of surfaces until it is known how many each physical surface has: if an element is in several,
/// the one with the fewest elements is its face, so that "all walls" beside "floor" leaves the floor a face. Version 4
/// of the format lists the physical surfaces of a surface, version 2 repeats the element for each; both end up here. An
/// element that is in physical surfaces of either direction is both sides of a thin plate.
class GmshSurfaces {
  public:
    using Nodes = std::vector<std::int64_t>;

    void set_name(std::int64_t physical, std::string name) { names_.emplace(physical, std::move(name)); }

    /// @param number    of the element, for messages
    /// @param physical  tags of its physical surfaces, negative where it is reversed; 0: none
    /// @param surface   its tag; 0: unknown
    /// @param corners   points of the mesh
    void add(std::int64_t number, const std::vector<std::int64_t>& physical, std::int64_t surface,
             const Nodes& corners) {
        if (physical.empty()) return add_side(number, 0, surface, corners);
        for (const std::int64_t tag : physical) {
            Nodes side = corners;
            if (tag < 0) std::reverse(side.begin(), side.end());
            // Tags of 64 bits do not occur, but a broken file may hold the one without a counterpart.
            add_side(number, tag < 0 ? -std::max(tag, -INT64_MAX) : tag, surface, std::move(side));
        }
    }

    /// Adds all polygons, and a note where elements are in several physical surfaces. @throws UserError
    void write_to(SurfaceMesh& mesh) const {
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
        for (const std::string& other : others) names.push_back(fmt::format("'{}'", excerpt(other)));
        mesh.remark(
            fmt::format("{} in several physical surfaces, and belong{} to the one with the fewest elements, not to {}",
                        several == 1 ? "1 element is" : fmt::format("{} elements are", several),
                        several == 1 ? "s" : "", first_names(std::move(names), most_named)));
    }

  private:
    struct Element {
        std::int64_t number = 0;
        std::int64_t surface = 0;
        Nodes corners;                       ///< counter-clockwise from the side that radiates
        std::vector<std::int64_t> physical;  ///< tags of physical surfaces, above 0; empty: none
    };

    std::unordered_map<std::int64_t, std::string> names_;  ///< names of physical surfaces, by tag
    std::unordered_map<std::int64_t, std::size_t> sizes_;  ///< numbers of elements of physical surfaces, by tag
    std::vector<Element> elements_;
    std::map<Nodes, std::size_t> by_corners_;  ///< the first element that has them

    void add_side(std::int64_t number, std::int64_t physical, std::int64_t surface, Nodes corners) {
        if (physical != 0) ++sizes_[physical];
        Nodes key = corners;
        std::rotate(key.begin(), std::min_element(key.begin(), key.end()), key.end());
        const auto [known, is_new] = by_corners_.try_emplace(std::move(key), elements_.size());
        if (!is_new) {
            Element& element = elements_[known->second];
            const auto& tags = element.physical;
            // The same element of the same physical surface occurs twice by mistake; a note on that is made for every
            // mesh.
            const bool is_copy =
                physical == 0 ? tags.empty() : std::find(tags.begin(), tags.end(), physical) != tags.end();
            if (!is_copy && element.surface == surface) {
                if (physical != 0) element.physical.push_back(physical);
                return;
            }
        }
        elements_.push_back({number, surface, std::move(corners), {}});
        if (physical != 0) elements_.back().physical.push_back(physical);
    }

    [[nodiscard]] std::string group_of(std::int64_t physical, std::int64_t surface) const {
        if (physical == 0) return surface == 0 ? std::string(unnamed_group) : fmt::format("surface_{}", surface);
        const auto name = names_.find(physical);
        return name == names_.end() ? fmt::format("physical_{}", physical) : name->second;
    }
};

}  // namespace ff::studies::meshes
