#pragma once

#include "studies/scene_files/meshes/formats.hpp"
#include "studies/scene_files/meshes/mesh_input.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace ff::studies::meshes {

inline constexpr std::int64_t vtk_triangle_strip = 6;
inline constexpr std::int64_t vtk_polygon = 7;

/// A section of cells of one kind, whose type files with such sections do not number.
struct VtkSection {
    std::string_view legacy;
    std::string_view xml;
    std::int64_t type;
};
/// Cells count in this order, whatever the order of sections in a file.
inline constexpr std::array vtk_sections{VtkSection{"VERTICES", "Verts", 2}, VtkSection{"LINES", "Lines", 4},
                                         VtkSection{"POLYGONS", "Polys", vtk_polygon},
                                         VtkSection{"TRIANGLE_STRIPS", "Strips", vtk_triangle_strip}};

/// Cells as files of VTK have them.
struct VtkCells {
    std::vector<std::int64_t> points;  ///< points of all cells, one cell after the other, numbered within their piece
    std::vector<std::int64_t> ends;    ///< end of each cell in `points`
    std::vector<std::int64_t> types;   ///< type of each cell

    /// Adds cells of one type, whose ends count from the first of them.
    void append(const VtkCells& more, std::int64_t type);
};

/// An array with a whole number or a text for each cell.
struct VtkArray {
    std::string name;
    std::vector<std::int64_t> numbers;
    std::vector<std::string> texts;  ///< empty where it has numbers

    [[nodiscard]] std::size_t size() const { return texts.empty() ? numbers.size() : texts.size(); }
    /// The name that it gives the face of a cell: name_number, or the text.
    [[nodiscard]] std::string face_of(std::size_t cell) const;
};

/// Arrays of cells, sorted by their use.
struct VtkArrays {
    std::vector<VtkArray> usable;      ///< arrays that may distinguish faces
    std::vector<std::string> others;   ///< names of those that cannot: of fractions, or several numbers for each cell
    std::vector<std::int64_t> hidden;  ///< vtkGhostType of each cell; empty: none is hidden

    /// Adds an array, except those that VTK keeps for itself, whose names begin with vtk.
    /// @param read  reads its numbers, where they are needed @return whether they were read
    bool add(const std::string& name, std::optional<NumberType> type, std::uint64_t components,
             const std::function<std::vector<std::int64_t>()>& read);
};

/// A part of a file with points and cells of its own.
struct VtkPiece {
    std::size_t first_point = 0;  ///< number of its first point in the mesh
    std::size_t points = 0;
    VtkCells cells;
    VtkArrays arrays;
};

/// Adds the polygons of pieces to a mesh that has their points. Faces are distinguished by the first array that every
/// piece has and that differs between polygons. Hidden and duplicate cells are left out. Notes say so.
/// @throws UserError
void add_pieces(SurfaceMesh& mesh, std::string_view file, const std::vector<VtkPiece>& pieces);

}  // namespace ff::studies::meshes
