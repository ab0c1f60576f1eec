#pragma once

#include "studies/scene_files/meshes/mesh_input.hpp"
#include "studies/scene_files/meshes/surface_mesh.hpp"
#include "studies/scene_files/meshes/vtk_cells.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace ff::studies::meshes {

/// An array with a whole number or a text for each cell.
struct VtkArray {
    std::string name;
    std::vector<std::int64_t> numbers;
    std::vector<std::string> texts;  ///< empty where it has numbers

    [[nodiscard]] std::size_t size() const { return texts.empty() ? numbers.size() : texts.size(); }
    /// What it calls the face of a cell: name_number, or the text.
    [[nodiscard]] std::string face_of(std::size_t cell) const;
};

/// Arrays of cells, sorted by what they are good for.
struct VtkArrays {
    std::vector<VtkArray> usable;      ///< may tell faces apart
    std::vector<std::string> others;   ///< names of those that cannot: of fractions, or several numbers for each cell
    std::vector<std::int64_t> hidden;  ///< vtkGhostType of each cell; empty: none is hidden
};

/// A part of a file with points and cells of its own.
struct VtkPiece {
    std::size_t first_point = 0;  ///< in the mesh
    std::size_t points = 0;
    VtkCells cells;
    VtkArrays arrays;
};

/// What an array of cells is good for; VTK keeps some for itself, whose names begin with vtk.
enum class VtkUse { faces, hidden, none, of_vtk };
VtkUse use_of_array(std::string_view name, std::optional<NumberType> type, std::uint64_t components);

/// Adds the polygons of pieces to a mesh that has their points. Faces are told apart by the first array that every
/// piece has and that differs between polygons. Hidden and duplicate cells are left out. Notes say so.
/// @throws UserError
void add_pieces(SurfaceMesh& mesh, std::string_view file, const std::vector<VtkPiece>& pieces);

}  // namespace ff::studies::meshes
