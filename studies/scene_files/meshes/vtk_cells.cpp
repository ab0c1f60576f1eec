#include "studies/scene_files/meshes/vtk_cells.hpp"

#include "core/support/error.hpp"
#include "core/support/excerpt.hpp"
#include "studies/readers/printable.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <set>
#include <span>

// Types of cells: https://vtk.org/doc/nightly/html/vtkCellType_8h.html

namespace ff::studies::meshes {
namespace {

using CellCorners = std::span<const std::int64_t>;

constexpr std::int64_t pixel = 8;
constexpr std::int64_t quadratic_polygon = 36;
constexpr std::array points_and_lines{0, 1, 2, 3, 4, 21, 35, 60, 68, 75};
constexpr std::array triangles{5, 22, 34, 61, 69, 76};
constexpr std::array quadrilaterals{9, 23, 28, 30, 62, 70, 77};
constexpr std::array volumes{10, 11, 12, 13, 14, 15, 16, 24, 25, 26, 27, 29, 31, 32, 33,
                             37, 41, 42, 64, 65, 66, 67, 71, 72, 73, 74, 78, 79, 80, 81};

template <class Types>
bool is_among(const Types& types, std::int64_t type) {
    return std::find(types.begin(), types.end(), type) != types.end();
}

bool is_polygon_type(std::int64_t type) {
    return !is_among(points_and_lines, type) && !is_among(volumes, type);
}

/// Adds the polygons of the cells of a piece to a mesh; those of higher order by their corners alone.
class CellPolygons {
  public:
    CellPolygons(SurfaceMesh& mesh, std::string_view file, const VtkPiece& piece)
        : mesh_(mesh),
          file_(file),
          first_point_(static_cast<std::int64_t>(piece.first_point)),
          points_(static_cast<std::int64_t>(piece.points)) {}

    /// Adds nothing for points and lines, and counts volume cells. @throws UserError
    void add(std::size_t number, std::int64_t type, CellCorners points, const std::string& group) {
        cell_ = fmt::format("cell {}", number);
        group_ = group;
        if (is_among(points_and_lines, type)) return;
        if (is_among(volumes, type)) return mesh_.leave_out_volume_cell();
        if (type == vtk_polygon) return add(points);
        if (type == vtk_triangle_strip) return add_strip(points);
        if (is_among(triangles, type)) return add(first(3, points));
        if (is_among(quadrilaterals, type)) return add(first(4, points));
        if (type == quadratic_polygon) return add(first(points.size() / 2, points));
        if (type == pixel) {
            const CellCorners rows = first(4, points);
            return add(std::array{rows[0], rows[1], rows[3], rows[2]});
        }
        fail(fmt::format("is of type {}, which is not known. Write polygons.", type));
    }

  private:
    SurfaceMesh& mesh_;
    std::string_view file_;
    std::int64_t first_point_;
    std::int64_t points_;
    std::string cell_;
    std::string group_;

    [[noreturn]] void fail(std::string_view problem) const { throw UserError("{}: {} {}", file_, cell_, problem); }

    [[nodiscard]] CellCorners first(std::size_t count, CellCorners points) const {
        if (points.size() < count)
            fail(fmt::format("has {} points (its type has {} corners). Correct it.", points.size(), count));
        return points.first(count);
    }

    void add(CellCorners corners) {
        std::vector<std::int64_t> in_mesh;
        for (const std::int64_t corner : corners) {
            if (corner < 0 || corner >= points_)
                fail(fmt::format("has point {}, of {} that count from 0. Correct the index.", corner, points_));
            in_mesh.push_back(first_point_ + corner);
        }
        mesh_.add_polygon(group_, in_mesh, cell_);
    }

    /// Every second triangle of a strip has its corners the other way round.
    void add_strip(CellCorners points) {
        for (std::size_t i = 0; i + 2 < points.size(); ++i)
            add(std::array{points[i], points[i + 1 + i % 2], points[i + 2 - i % 2]});
    }
};

constexpr std::string_view ghost_array = "vtkGhostType";
// Bits of DUPLICATECELL, REFINEDCELL and HIDDENCELL, which VTK leaves out of surfaces too:
// https://vtk.org/doc/nightly/html/classvtkDataSetAttributes.html
constexpr std::int64_t left_out_bits = 1 | 8 | 32;

bool is_left_out(const VtkPiece& piece, std::size_t cell) {
    return cell < piece.arrays.hidden.size() && (piece.arrays.hidden[cell] & left_out_bits) != 0;
}

const VtkArray* usable_array(const VtkPiece& piece, const std::string& name) {
    const auto& arrays = piece.arrays.usable;
    const auto found =
        std::find_if(arrays.begin(), arrays.end(), [&](const VtkArray& array) { return array.name == name; });
    return found == arrays.end() ? nullptr : &*found;
}

/// Names of usable arrays that all pieces have, as the first of them orders them.
std::vector<std::string> common_arrays(const std::vector<VtkPiece>& pieces) {
    std::vector<std::string> names;
    if (pieces.empty()) return names;
    for (const VtkArray& array : pieces.front().arrays.usable) {
        if (std::all_of(pieces.begin(), pieces.end(),
                        [&](const VtkPiece& piece) { return usable_array(piece, array.name) != nullptr; }))
            names.push_back(array.name);
    }
    return names;
}

/// Whether an array differs between polygons that are kept: lines and volumes often have numbers of their own.
bool tells_faces_apart(const std::vector<VtkPiece>& pieces, const std::string& name) {
    std::optional<std::string> first;
    for (const VtkPiece& piece : pieces) {
        const VtkArray& array = *usable_array(piece, name);
        for (std::size_t cell = 0; cell < array.size(); ++cell) {
            if (is_left_out(piece, cell) || !is_polygon_type(piece.cells.types[cell])) continue;
            std::string face = array.face_of(cell);
            if (first && face != *first) return true;
            first = std::move(face);
        }
    }
    return false;
}

/// Names in quotes, and how many more there are.
std::string quoted(const std::vector<std::string>& names) {
    std::vector<std::string> shown;
    for (const std::string& name : names) shown.push_back(fmt::format("'{}'", excerpt(as_word(name))));
    return first_names(std::move(shown), 3);
}

/// The points of a cell, which begin at this place in the list of all. @throws UserError where they do not end after it
CellCorners points_of_cell(std::string_view file, const VtkCells& cells, std::size_t cell, std::size_t begin) {
    const auto end = static_cast<std::size_t>(cells.ends[cell]);
    if (end < begin || end > cells.points.size())
        throw UserError(
            "{}: cell {} ends at point {} of the list of points of cells (it begins at {}, and there are "
            "{}). Correct it.",
            file, cell, cells.ends[cell], begin, cells.points.size());
    return CellCorners(cells.points).subspan(begin, end - begin);
}

/// The array that distinguishes faces; empty where none does, and all polygons are one face.
std::optional<std::string> choose_array(SurfaceMesh& mesh, const std::vector<VtkPiece>& pieces) {
    std::vector<std::string> names = common_arrays(pieces);
    const auto chosen =
        std::find_if(names.begin(), names.end(), [&](const auto& name) { return tells_faces_apart(pieces, name); });
    if (chosen != names.end()) {
        const std::string name = *chosen;
        names.erase(chosen);
        const std::string others = names.empty() ? ""
                                                 : fmt::format(", as the first with several values; {} {} not used",
                                                               quoted(names), names.size() == 1 ? "is" : "are");
        mesh.remark(fmt::format("array '{}' tells its faces apart{}", excerpt(as_word(name)), others));
        return name;
    }
    std::set<std::string> unused;
    for (const VtkPiece& piece : pieces) {
        unused.insert(piece.arrays.others.begin(), piece.arrays.others.end());
        for (const VtkArray& array : piece.arrays.usable) unused.insert(array.name);
    }
    auto first = names.empty() ? std::nullopt : std::optional(names.front());
    if (first) unused.erase(*first);
    if (!unused.empty())
        mesh.remark(fmt::format("no array of whole numbers or texts tells its faces apart; {} {} not used",
                                quoted({unused.begin(), unused.end()}), unused.size() == 1 ? "is" : "are"));
    return first;
}

}  // namespace

void VtkCells::append(const VtkCells& more, std::int64_t type) {
    const std::uint64_t before = points.size();
    points.insert(points.end(), more.points.begin(), more.points.end());
    // Without a sign, since a broken file may hold any number.
    for (const std::int64_t end : more.ends)
        ends.push_back(static_cast<std::int64_t>(before + static_cast<std::uint64_t>(end)));
    types.insert(types.end(), more.ends.size(), type);
}

std::string VtkArray::face_of(std::size_t cell) const {
    return texts.empty() ? fmt::format("{}_{}", name, numbers[cell]) : texts[cell];
}

bool VtkArrays::add(const std::string& name, std::optional<NumberType> type, std::uint64_t components,
                    const std::function<std::vector<std::int64_t>()>& read) {
    const bool is_usable = type && type->is_whole() && components == 1;
    if (name == ghost_array && is_usable) {
        hidden = read();
        return true;
    }
    if (name.starts_with("vtk")) return false;
    if (is_usable)
        usable.push_back({name, read(), {}});
    else
        others.push_back(name);
    return is_usable;
}

void add_pieces(SurfaceMesh& mesh, std::string_view file, const std::vector<VtkPiece>& pieces) {
    const auto array = choose_array(mesh, pieces);
    std::size_t hidden = 0;
    for (const VtkPiece& piece : pieces) {
        const VtkArray* const faces = array ? usable_array(piece, *array) : nullptr;
        CellPolygons polygons(mesh, file, piece);
        std::size_t begin = 0;
        for (std::size_t cell = 0; cell < piece.cells.ends.size(); ++cell) {
            const CellCorners points = points_of_cell(file, piece.cells, cell, begin);
            begin += points.size();
            if (is_left_out(piece, cell)) {
                ++hidden;
            } else {
                polygons.add(cell, piece.cells.types[cell], points,
                             faces == nullptr ? std::string(unnamed_group) : faces->face_of(cell));
            }
        }
    }
    if (hidden > 0)
        mesh.remark(fmt::format("{} hidden or a duplicate by {}, and {} left out",
                                hidden == 1 ? "1 cell is" : fmt::format("{} cells are", hidden), ghost_array,
                                hidden == 1 ? "is" : "are"));
}

}  // namespace ff::studies::meshes
