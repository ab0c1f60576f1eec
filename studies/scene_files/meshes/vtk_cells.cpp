#include "studies/scene_files/meshes/vtk_cells.hpp"

#include "core/support/error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <iterator>

// Types of cells: https://vtk.org/doc/nightly/html/vtkCellType_8h.html

namespace ff::studies::meshes {
namespace {

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

}  // namespace

void CellPolygons::add(std::size_t number, std::int64_t type, CellCorners points, const std::string& group) {
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

void CellPolygons::fail(std::string_view problem) const {
    throw UserError(fmt::format("{}: {} {}", file_, cell_, problem));
}

CellCorners CellPolygons::first(std::size_t count, CellCorners points) const {
    if (points.size() < count)
        fail(fmt::format("has {} points (its type has {} corners). Correct it.", points.size(), count));
    return points.first(count);
}

void CellPolygons::add(CellCorners corners) {
    std::vector<std::int64_t> in_mesh;
    for (const std::int64_t corner : corners) {
        if (corner < 0 || corner >= points_)
            fail(fmt::format("has point {}, of {} that count from 0. Correct the index.", corner, points_));
        in_mesh.push_back(first_point_ + corner);
    }
    mesh_.add_polygon(group_, in_mesh, cell_);
}

/// Every second triangle of a strip has its corners the other way round.
void CellPolygons::add_strip(CellCorners points) {
    for (std::size_t i = 0; i + 2 < points.size(); ++i)
        add(std::array{points[i], points[i + 1 + i % 2], points[i + 2 - i % 2]});
}

bool is_polygon_type(std::int64_t type) {
    return !is_among(points_and_lines, type) && !is_among(volumes, type);
}

void VtkCells::append(const std::vector<std::int64_t>& more_points, const std::vector<std::int64_t>& more_ends,
                      std::int64_t type) {
    const std::uint64_t before = points.size();
    points.insert(points.end(), more_points.begin(), more_points.end());
    std::transform(more_ends.begin(), more_ends.end(), std::back_inserter(ends), [&](std::int64_t end) {
        return static_cast<std::int64_t>(before + static_cast<std::uint64_t>(end));
    });
    types.insert(types.end(), more_ends.size(), type);
}

void for_each_cell(std::string_view file, const VtkCells& cells,
                   const std::function<void(std::size_t, CellCorners)>& visit) {
    std::size_t begin = 0;
    for (std::size_t i = 0; i < cells.ends.size(); ++i) {
        const auto end = static_cast<std::size_t>(cells.ends[i]);
        if (end < begin || end > cells.points.size())
            throw UserError(
                fmt::format("{}: cell {} ends at point {} of the list of points of cells (it begins at {}, "
                            "and there are {}). Correct it.",
                            file, i, cells.ends[i], begin, cells.points.size()));
        visit(i, CellCorners(cells.points).subspan(begin, end - begin));
        begin = end;
    }
}

}  // namespace ff::studies::meshes
