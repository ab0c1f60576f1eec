#pragma once

#include "studies/scene_files/meshes/mesh_input.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <string>
#include <string_view>
#include <vector>

namespace ff::studies::meshes {

using Cell = std::vector<int>;

inline const std::vector<std::array<double, 3>> room_points{{0, 0, 0}, {4, 0, 0}, {4, 3, 0}, {0, 3, 0},
                                                            {0, 0, 2}, {4, 0, 2}, {4, 3, 2}, {0, 3, 2}};
inline const std::vector<Cell> room_walls{{0, 1, 2, 3}, {4, 7, 6, 5}, {0, 4, 5, 1},
                                          {2, 6, 7, 3}, {1, 5, 6, 2}, {3, 7, 4, 0}};
inline const Cell room_line{0, 1};
inline const Cell room_volume{0, 1, 2, 3, 4, 5, 6, 7};

/// Numbers in text or binary.
struct Numbers {
    Encoding encoding = Encoding::text;
    std::string bytes;

    template <class Number>
    void put(Number number) {
        if (encoding == Encoding::text) {
            bytes += fmt::format("{} ", number);
            return;
        }
        std::array<char, sizeof number> binary{};
        std::memcpy(binary.data(), &number, sizeof number);
        if (encoding == Encoding::big_endian) std::reverse(binary.begin(), binary.end());
        bytes.append(binary.begin(), binary.end());
    }

    template <class Number>
    void put_all(const std::vector<int>& numbers) {
        for (const int number : numbers) put(static_cast<Number>(number));
    }

    void put_points() {
        for (const auto& point : room_points) {
            for (const double coordinate : point) put(coordinate);
        }
    }
};

/// The line, the walls and, in grids, the hexahedron.
inline std::vector<Cell> cells_of(bool is_grid) {
    std::vector<Cell> cells{room_line};
    cells.insert(cells.end(), room_walls.begin(), room_walls.end());
    if (is_grid) cells.push_back(room_volume);
    return cells;
}

inline std::vector<int> groups_of(bool is_grid) {
    std::vector<int> groups{7, 1, 1, 2, 2, 3, 3};
    if (is_grid) groups.push_back(7);
    return groups;
}

enum class LegacyCells { counted, offset };

/// Formats of VTK before XML; cells from version 5.1 on have offsets.
std::string legacy_file(Encoding encoding, bool is_grid, LegacyCells form);

struct XmlForm {
    std::string_view format = "ascii";     ///< or binary, or appended
    std::string_view appended_as = "raw";  ///< or base64
    Encoding encoding = Encoding::little_endian;
    bool has_long_headers = false;
    bool is_compressed = false;
    bool is_grid = true;
};

std::string xml_file(const XmlForm& form);

/// Version 2.2, without a physical surface for its third group.
std::string gmsh2_file(Encoding encoding);
/// The same in version 4 or 4.1.
std::string gmsh4_file(Encoding encoding, std::string_view version);

/// Three solids in text, one in binary.
std::string stl_file(Encoding encoding);

enum class PlyPolygons { after_points, before_points, strips };

/// A file with properties and elements that mean nothing here.
std::string ply_file(Encoding encoding, PlyPolygons polygons);

/// @param keyword  with what follows it  @param after_points  normals, colours and such
std::string off_file(std::string_view keyword, std::string_view after_points);

}  // namespace ff::studies::meshes
