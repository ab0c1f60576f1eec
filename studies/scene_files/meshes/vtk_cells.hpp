#pragma once

#include "studies/scene_files/meshes/mesh_input.hpp"
#include "studies/scene_files/meshes/surface_mesh.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace ff::studies::meshes {

/// Types of cells that files with sections for each kind of cell do not number.
inline constexpr std::int64_t vtk_poly_vertex = 2;
inline constexpr std::int64_t vtk_poly_line = 4;
inline constexpr std::int64_t vtk_triangle_strip = 6;
inline constexpr std::int64_t vtk_polygon = 7;

/// Cells as files of VTK have them.
struct VtkCells {
    std::vector<std::int64_t> points;  ///< of all cells, one after the other, numbered within their piece
    std::vector<std::int64_t> ends;    ///< of each cell, in `points`
    std::vector<std::int64_t> types;   ///< one for each cell

    /// Adds cells of one type, whose ends count from the first of them.
    void append(const std::vector<std::int64_t>& more_points, const std::vector<std::int64_t>& more_ends,
                std::int64_t type);
};

/// An array that tells groups of cells apart.
struct VtkGroups {
    std::string name;                 ///< of the array
    std::vector<std::string> labels;  ///< of the group of each cell
};

/// Groups by the values of an array, called name_value.
VtkGroups groups_by_number(std::string name, const std::vector<std::int64_t>& values);

/// Whether an array of cells may tell groups apart: whole numbers, one for each cell, and not for use by VTK itself
/// (vtkGhostType).
bool may_be_groups(std::string_view name, std::optional<NumberType> type, std::uint64_t components);

/// Adds the polygons of a piece, whose points are the last that were added to the mesh.
/// @param first_point  of the piece, in the mesh  @throws UserError
void add_cells(SurfaceMesh& mesh, std::string_view file, std::size_t first_point, const VtkCells& cells,
               const std::optional<VtkGroups>& groups);

}  // namespace ff::studies::meshes
