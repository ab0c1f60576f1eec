#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>

namespace ff::studies::meshes {

/// A type of elements of gmsh.
struct GmshElement {
    std::uint8_t dimension = 0;
    std::uint8_t corners = 0;  ///< which are its first nodes
    std::uint16_t nodes = 0;
};

/// Of the types that gmsh commonly writes; empty for others.
std::optional<GmshElement> gmsh_element(std::int64_t type);

}  // namespace ff::studies::meshes
