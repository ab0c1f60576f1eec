#include "studies/scene_files/meshes/vtk_cells.hpp"

#include "core/support/error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <span>

// Types of cells: https://vtk.org/doc/nightly/html/vtkCellType_8h.html

namespace ff::studies::meshes {
namespace {

using Corners = std::span<const std::int64_t>;

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

/// Polygons of cells; of those of higher order, corners alone.
class CellPolygons {
  public:
    CellPolygons(SurfaceMesh& mesh, std::string_view file, std::size_t first_point)
        : mesh_(mesh),
          file_(file),
          first_point_(static_cast<std::int64_t>(first_point)),
          points_(static_cast<std::int64_t>(mesh.point_count() - first_point)) {}

    void add(std::size_t number, std::int64_t type, Corners points, std::string_view group) {
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
            const Corners rows = first(4, points);
            return add(std::array{rows[0], rows[1], rows[3], rows[2]});
        }
        fail(fmt::format("is of type {}, which is not known. Write polygons.", type));
    }

    [[noreturn]] void fail(std::string_view problem) const {
        throw UserError(fmt::format("{}: {} {}", file_, cell_, problem));
    }

  private:
    SurfaceMesh& mesh_;
    std::string_view file_;
    std::int64_t first_point_;
    std::int64_t points_;
    std::string cell_;
    std::string group_;

    [[nodiscard]] Corners first(std::size_t count, Corners points) const {
        if (points.size() < count)
            fail(fmt::format("has {} points (its type has {} corners). Correct it.", points.size(), count));
        return points.first(count);
    }

    void add(Corners corners) {
        std::vector<std::int64_t> in_mesh;
        for (const std::int64_t corner : corners) {
            if (corner < 0 || corner >= points_)
                fail(fmt::format("has point {}, of {} that count from 0. Correct the index.", corner, points_));
            in_mesh.push_back(first_point_ + corner);
        }
        mesh_.add_polygon(group_, in_mesh, cell_);
    }

    /// Every second triangle of a strip has its corners the other way round.
    void add_strip(Corners points) {
        for (std::size_t i = 0; i + 2 < points.size(); ++i)
            add(std::array{points[i], points[i + 1 + i % 2], points[i + 2 - i % 2]});
    }
};

}  // namespace

void VtkCells::append(const std::vector<std::int64_t>& more_points, const std::vector<std::int64_t>& more_ends,
                      std::int64_t type) {
    const std::uint64_t before = points.size();
    points.insert(points.end(), more_points.begin(), more_points.end());
    std::transform(more_ends.begin(), more_ends.end(), std::back_inserter(ends), [&](std::int64_t end) {
        return static_cast<std::int64_t>(before + static_cast<std::uint64_t>(end));
    });
    types.insert(types.end(), more_ends.size(), type);
}

bool may_be_groups(std::string_view name, std::optional<NumberType> type, std::uint64_t components) {
    return type && type->is_whole() && components == 1 && !name.starts_with("vtk");
}

VtkGroups groups_by_number(std::string name, const std::vector<std::int64_t>& values) {
    VtkGroups groups{std::move(name), {}};
    for (const std::int64_t value : values) groups.labels.push_back(fmt::format("{}_{}", as_word(groups.name), value));
    return groups;
}

void add_cells(SurfaceMesh& mesh, std::string_view file, std::size_t first_point, const VtkCells& cells,
               const std::optional<VtkGroups>& groups) {
    CellPolygons polygons(mesh, file, first_point);
    std::size_t begin = 0;
    for (std::size_t i = 0; i < cells.ends.size(); ++i) {
        const auto end = static_cast<std::size_t>(cells.ends[i]);
        if (end < begin || end > cells.points.size())
            throw UserError(
                fmt::format("{}: cell {} ends at point {} of the list of points of cells (it begins at {}, "
                            "and there are {}). Correct it.",
                            file, i, cells.ends[i], begin, cells.points.size()));
        const Corners points = Corners(cells.points).subspan(begin, end - begin);
        const std::string group = groups ? groups->labels[i] : std::string(unnamed_group);
        polygons.add(i, cells.types[i], points, group);
        begin = end;
    }
}

}  // namespace ff::studies::meshes
