#include "tests/unit/studies/scene_files/sample_room.hpp"

namespace ff::studies::meshes {
namespace {

void put_triangle(Numbers& numbers, const std::array<int, 3>& corners) {
    for (const int corner : corners) {
        if (numbers.encoding == Encoding::text) numbers.bytes += "\n   vertex ";
        for (const double coordinate : room_points[static_cast<std::size_t>(corner)])
            numbers.put(static_cast<float>(coordinate));
    }
}

/// Two triangles of each wall.
template <class Put>
void for_each_triangle(std::size_t wall, Put put) {
    const Cell& corners = room_walls[wall];
    put({corners[0], corners[1], corners[2]});
    put({corners[0], corners[2], corners[3]});
}

}  // namespace

std::string stl_file(Encoding encoding) {
    Numbers numbers{encoding, {}};
    if (encoding != Encoding::text) {
        numbers.bytes = "solid SolidWorks, facet" + std::string(80 - 23, ' ');
        numbers.put(static_cast<std::uint32_t>(2 * room_walls.size()));
        for (std::size_t wall = 0; wall < room_walls.size(); ++wall) {
            for_each_triangle(wall, [&](const std::array<int, 3>& corners) {
                numbers.bytes.append(12, '\0');
                put_triangle(numbers, corners);
                numbers.bytes.append(2, '\0');
            });
        }
        return numbers.bytes;
    }
    const std::array<std::string_view, 3> names{" floor plate", " #2|two", ""};
    for (std::size_t solid = 0; solid < names.size(); ++solid) {
        numbers.bytes += fmt::format("solid{}\r\n", names[solid]);
        for (std::size_t wall = 2 * solid; wall < 2 * solid + 2; ++wall) {
            for_each_triangle(wall, [&](const std::array<int, 3>& corners) {
                numbers.bytes += " facet normal nan 0 -1e+00\n  outer loop";
                put_triangle(numbers, corners);
                numbers.bytes += "\n  endloop\n endfacet\n";
            });
        }
        numbers.bytes += fmt::format("endsolid{}\n", names[solid]);
    }
    return numbers.bytes;
}

std::string ply_file(Encoding encoding, PlyPolygons polygons) {
    constexpr std::array<std::string_view, 3> formats{"ascii", "binary_little_endian", "binary_big_endian"};
    const bool has_strips = polygons == PlyPolygons::strips;
    const std::string of_points =
        "element vertex 8\nproperty uchar grey\nproperty double x\nproperty double y\nproperty list ushort float "
        "weights\nproperty double z\n";
    const std::string of_polygons =
        has_strips
            ? "element tristrips 2\nproperty list int int vertex_indices\n"
            : "element face 7\nproperty short part\nproperty list uchar uint vertex_index\nproperty float32 heat\n";
    Numbers points{encoding, {}};
    for (const auto& point : room_points) {
        points.put(std::uint8_t{9});
        points.put(point[0]);
        points.put(point[1]);
        points.put(std::uint16_t{1});
        points.put(0.5F);
        points.put(point[2]);
    }
    Numbers corners{encoding, {}};
    if (has_strips) {
        for (const std::vector<int>& strip : {std::vector{0, 1, 3, 2, -1, 5, 4, 6, 7, -1, 0, 4, 1, 5},
                                              {3, 2, 7, 6, -1, -1, 1, 5, 2, 6, -1, 0, 3, 4, 7, -1}}) {
            corners.put(static_cast<std::int32_t>(strip.size()));
            corners.put_all<std::int32_t>(strip);
        }
    }
    for (const Cell& cell : has_strips ? std::vector<Cell>{} : cells_of(false)) {
        corners.put(std::int16_t{-7});
        corners.put(static_cast<std::uint8_t>(cell.size()));
        corners.put_all<std::uint32_t>(cell);
        corners.put(1.5F);
    }
    Numbers last{encoding, {}};
    last.put(std::uint32_t{3});
    const bool is_turned = polygons == PlyPolygons::before_points;
    return fmt::format(
        "ply\nformat {} 1.0\ncomment element face 9\n{}{}element edge 1\nproperty uint end\nelement nothing 99\n"
        "obj_info of a room\nend_header\n{}{}{}",
        formats.at(static_cast<std::size_t>(encoding)), is_turned ? of_polygons : of_points,
        is_turned ? of_points : of_polygons, is_turned ? corners.bytes : points.bytes,
        is_turned ? points.bytes : corners.bytes, last.bytes);
}

std::string off_file(std::string_view keyword, std::string_view after_points) {
    std::string text = fmt::format("{}8 7 12 # vertices, polygons\r\n\n", keyword);
    for (const auto& point : room_points)
        text += fmt::format("{} {} {}{}\n# next\n", point[0], point[1], point[2], after_points);
    for (const Cell& cell : cells_of(false))
        text += fmt::format("{} {}{}\n", cell.size(), fmt::join(cell, " "), cell.size() == 2 ? " 255 0 0" : "");
    return text;
}

}  // namespace ff::studies::meshes
