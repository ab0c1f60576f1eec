#pragma once

#include "studies/scene_files/meshes/surface_mesh.hpp"

#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <unordered_map>
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
             const Nodes& corners);

    /// Adds all polygons, and a note where elements are in several physical surfaces. @throws UserError
    void write_to(SurfaceMesh& mesh) const;

  private:
    struct Element {
        std::int64_t number = 0;
        std::int64_t surface = 0;
        Nodes corners;                       ///< counter-clockwise from the side that radiates
        std::vector<std::int64_t> physical;  ///< above 0; empty: none
    };

    std::unordered_map<std::int64_t, std::string> names_;  ///< names of physical surfaces, by tag
    std::unordered_map<std::int64_t, std::size_t> sizes_;  ///< numbers of elements of physical surfaces, by tag
    std::vector<Element> elements_;
    std::map<Nodes, std::size_t> by_corners_;  ///< the first element that has them

    void add_side(std::int64_t number, std::int64_t physical, std::int64_t surface, Nodes corners);
    [[nodiscard]] std::string group_of(std::int64_t physical, std::int64_t surface) const;
};

}  // namespace ff::studies::meshes
