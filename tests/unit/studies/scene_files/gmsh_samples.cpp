#include "tests/unit/studies/scene_files/sample_room.hpp"

#include <fmt/format.h>

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace ff::studies::meshes {
namespace {

constexpr std::string_view gmsh_names = "\n$PhysicalNames\n2\n1 1 \"edge\"\n2 1 \"floor plate\"\n$EndPhysicalNames\n";

std::string gmsh_start(Numbers& out, std::string_view version) {
    out.bytes = fmt::format("$MeshFormat\n{} {} 8\n", version, out.encoding == Encoding::text ? 0 : 1);
    if (out.encoding != Encoding::text) out.put(std::int32_t{1});
    return out.bytes += fmt::format("\n$EndMeshFormat{}", gmsh_names);
}

/// Nodes count from 10.
void put_nodes(Numbers& out, const Cell& cell, bool is_long) {
    for (const int node : cell) {
        if (is_long)
            out.put(static_cast<std::uint64_t>(node) + 10);
        else
            out.put(std::int32_t{node} + 10);
    }
}

}  // namespace

std::string gmsh2_file(Encoding encoding) {
    Numbers out{encoding, {}};
    gmsh_start(out, "2.2");
    out.bytes += "$Nodes\n8\n";
    for (std::size_t i = 0; i < room_points.size(); ++i) {
        out.put(static_cast<std::int32_t>(10 + i));
        for (const double coordinate : room_points[i]) out.put(coordinate);
    }
    out.bytes += "\n$EndNodes\n$Elements\n8\n";
    const std::vector<int> types{1, 3, 3, 3, 3, 3, 3, 5};
    const std::vector<int> groups = groups_of(true);
    std::int32_t number = 0;
    for (const Cell& cell : cells_of(true)) {
        const int group = groups[static_cast<std::size_t>(number)];
        const std::int32_t type = types[static_cast<std::size_t>(number)];
        ++number;
        if (encoding == Encoding::text)
            out.put_all<std::int32_t>({number, type, 2});
        else
            out.put_all<std::int32_t>({type, 1, 2, number});
        out.put_all<std::int32_t>({group == 3 ? 0 : group, group});
        put_nodes(out, cell, false);
        if (encoding == Encoding::text) out.bytes += '\n';
    }
    out.bytes += "\n$EndElements\n";
    return out.bytes;
}

namespace {

void put_gmsh4_entities(Numbers& out, bool is_newest) {
    out.bytes += "$Entities\n";
    for (const int count : {1, 0, 3, 0}) out.put(static_cast<std::uint64_t>(count));
    out.put(std::int32_t{1});  // a point
    for (int i = 0; i < (is_newest ? 3 : 6); ++i) out.put(0.0);
    out.put(std::uint64_t{0});
    for (const std::int32_t surface : {1, 2, 3}) {
        out.put(surface);
        for (int i = 0; i < 6; ++i) out.put(0.0);
        out.put(std::uint64_t(surface == 3 ? 0 : 1));
        if (surface != 3) out.put(surface);
        out.put(std::uint64_t{0});
    }
    out.bytes += "\n$EndEntities\n";
}

}  // namespace

std::string gmsh4_file(Encoding encoding, std::string_view version) {
    const bool is_newest = version == "4.1";
    Numbers out{encoding, {}};
    gmsh_start(out, version);
    put_gmsh4_entities(out, is_newest);
    const auto put_sizes = [&](std::size_t blocks, std::uint64_t first, std::uint64_t last) {
        out.put(std::uint64_t{blocks});
        out.put(std::uint64_t{8});
        if (!is_newest) return;
        out.put(first);
        out.put(last);
    };
    const auto put_entity = [&](int dimension, int tag) {
        out.put_all<std::int32_t>(is_newest ? std::vector<int>{dimension, tag} : std::vector<int>{tag, dimension});
    };
    out.bytes += "$Nodes\n";
    put_sizes(1, 10, 17);
    put_entity(2, 1);
    out.put(std::int32_t{1});  // with parameters
    out.put(std::uint64_t{8});
    if (is_newest) put_nodes(out, room_volume, true);
    for (const int i : room_volume) {
        if (!is_newest) put_nodes(out, {i}, false);
        for (const double coordinate : room_points[static_cast<std::size_t>(i)]) out.put(coordinate);
        for (const double parameter : {0.25, 0.75}) out.put(parameter);
    }
    out.bytes += "\n$EndNodes\n$Elements\n";
    put_sizes(5, 1, 8);
    std::int32_t number = 0;
    const auto put_block = [&](int dimension, int tag, int type, const std::vector<Cell>& cells) {
        put_entity(dimension, tag);
        out.put(std::int32_t{type});
        out.put(std::uint64_t{cells.size()});
        for (const Cell& cell : cells) {
            ++number;
            put_nodes(out, {number}, is_newest);
            put_nodes(out, cell, is_newest);
        }
    };
    put_block(1, 1, 1, {room_line});
    for (std::size_t i = 0; i < 3; ++i)
        put_block(2, static_cast<int>(i + 1), 3, {room_walls[2 * i], room_walls[2 * i + 1]});
    put_block(3, 1, 5, {room_volume});
    out.bytes += "\n$EndElements\n";
    return out.bytes;
}

}  // namespace ff::studies::meshes
