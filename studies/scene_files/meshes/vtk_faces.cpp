#include "studies/scene_files/meshes/vtk_faces.hpp"

#include "core/support/excerpt.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>

namespace ff::studies::meshes {
namespace {

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
    constexpr std::size_t most_named = 3;
    std::vector<std::string> shown;
    for (std::size_t k = 0; k < std::min(names.size(), most_named); ++k)
        shown.push_back(fmt::format("'{}'", excerpt(as_word(names[k]))));
    const std::string text = fmt::format("{}", fmt::join(shown, ", "));
    return names.size() > most_named ? fmt::format("{} and {} more", text, names.size() - most_named) : text;
}

/// The array that tells faces apart; empty where none does, and all polygons are one face.
std::optional<std::string> choose_array(SurfaceMesh& mesh, const std::vector<VtkPiece>& pieces) {
    std::vector<std::string> names = common_arrays(pieces);
    const auto chosen =
        std::find_if(names.begin(), names.end(), [&](const auto& name) { return tells_faces_apart(pieces, name); });
    if (chosen != names.end()) {
        const std::string name = *chosen;
        names.erase(chosen);
        if (!names.empty())
            mesh.remark(
                fmt::format("array '{}' tells its faces apart, as the first with several values; {} {} not used",
                            excerpt(as_word(name)), quoted(names), names.size() == 1 ? "is" : "are"));
        return name;
    }
    std::set<std::string> unused;
    for (const VtkPiece& piece : pieces) {
        unused.insert(piece.arrays.others.begin(), piece.arrays.others.end());
        for (const VtkArray& array : piece.arrays.usable) unused.insert(array.name);
    }
    const auto first = names.empty() ? std::nullopt : std::optional(names.front());
    if (first) unused.erase(*first);
    if (!unused.empty())
        mesh.remark(fmt::format("no array of whole numbers or texts tells its faces apart; {} {} not used",
                                quoted({unused.begin(), unused.end()}), unused.size() == 1 ? "is" : "are"));
    return first;
}

}  // namespace

std::string VtkArray::face_of(std::size_t cell) const {
    return texts.empty() ? fmt::format("{}_{}", as_word(name), numbers[cell]) : texts[cell];
}

VtkUse use_of_array(std::string_view name, std::optional<NumberType> type, std::uint64_t components) {
    const bool is_usable = type && type->is_whole() && components == 1;
    if (name == ghost_array && is_usable) return VtkUse::hidden;
    if (name.starts_with("vtk")) return VtkUse::of_vtk;
    return is_usable ? VtkUse::faces : VtkUse::none;
}

void add_pieces(SurfaceMesh& mesh, std::string_view file, const std::vector<VtkPiece>& pieces) {
    const auto array = choose_array(mesh, pieces);
    std::size_t hidden = 0;
    for (const VtkPiece& piece : pieces) {
        const VtkArray* const faces = array ? usable_array(piece, *array) : nullptr;
        CellPolygons polygons(mesh, file, piece.first_point, piece.points);
        for_each_cell(file, piece.cells, [&](std::size_t cell, CellCorners points) {
            if (is_left_out(piece, cell)) {
                ++hidden;
            } else {
                polygons.add(cell, piece.cells.types[cell], points,
                             faces == nullptr ? std::string(unnamed_group) : faces->face_of(cell));
            }
        });
    }
    if (hidden > 0)
        mesh.remark(fmt::format("{} hidden or a duplicate by {}, and {} left out",
                                hidden == 1 ? "1 cell is" : fmt::format("{} cells are", hidden), ghost_array,
                                hidden == 1 ? "is" : "are"));
}

}  // namespace ff::studies::meshes
