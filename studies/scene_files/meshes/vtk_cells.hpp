#pragma once

#include "studies/scene_files/meshes/surface_mesh.hpp"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
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

using CellCorners = std::span<const std::int64_t>;

/// Whether cells of that type are polygons, or strips of them.
bool is_polygon_type(std::int64_t type);

/// Calls visit(number, points) for each cell. @throws UserError where ends are not in order
void for_each_cell(std::string_view file, const VtkCells& cells,
                   const std::function<void(std::size_t, CellCorners)>& visit);

/// Adds the polygons of cells to a mesh; those of higher order by their corners alone.
class CellPolygons {
  public:
    /// @param first_point  of the piece that cells are of, in the mesh
    CellPolygons(SurfaceMesh& mesh, std::string_view file, std::size_t first_point, std::size_t points)
        : mesh_(mesh),
          file_(file),
          first_point_(static_cast<std::int64_t>(first_point)),
          points_(static_cast<std::int64_t>(points)) {}

    /// Adds nothing of points and lines, and counts volume cells. @throws UserError
    void add(std::size_t number, std::int64_t type, CellCorners points, const std::string& group);

  private:
    SurfaceMesh& mesh_;
    std::string_view file_;
    std::int64_t first_point_;
    std::int64_t points_;
    std::string cell_;
    std::string group_;

    [[noreturn]] void fail(std::string_view problem) const;
    [[nodiscard]] CellCorners first(std::size_t count, CellCorners points) const;
    void add(CellCorners corners);
    void add_strip(CellCorners points);
};

}  // namespace ff::studies::meshes
