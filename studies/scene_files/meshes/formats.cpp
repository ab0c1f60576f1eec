#include "studies/scene_files/meshes/formats.hpp"

#include "core/support/error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <cstddef>
#include <string>
#include <string_view>
#include <system_error>

namespace ff::studies::meshes {
namespace {

bool begins_with_word(std::string_view bytes, std::string_view word) {
    constexpr std::string_view blanks = " \t\r\n";
    return bytes.starts_with(word) && bytes.size() > word.size() &&
           blanks.find(bytes[word.size()]) != std::string_view::npos;
}

/// Comments may precede the section that tells the version.
bool is_gmsh(std::string_view bytes) {
    return begins_with_word(bytes, "$MeshFormat") || begins_with_word(bytes, "$Comments");
}

constexpr std::array kinds{
    MeshKind{"a VTK file", ".vtk", [](std::string_view bytes) { return bytes.starts_with("# vtk DataFile"); },
             read_vtk_legacy},
    MeshKind{"a VTK file in XML", ".vtu", is_vtk_xml, read_vtk_xml},
    MeshKind{"a mesh of gmsh", ".msh", is_gmsh, read_gmsh},
    MeshKind{"a binary glTF file", ".glb", [](std::string_view bytes) { return bytes.starts_with("glTF"); }},
    MeshKind{"a PLY file", ".ply", [](std::string_view bytes) { return begins_with_word(bytes, "ply"); }, read_ply},
    MeshKind{"an OFF file", ".off", is_off, read_off},
    MeshKind{"an STL file", ".stl", is_stl, read_stl},
};

}  // namespace

std::string as_word(std::string_view name) {
    std::string word(name);
    for (char& c : word) {
        const auto byte = static_cast<unsigned char>(c);
        if (std::isspace(byte) != 0 || std::iscntrl(byte) != 0 || c == '|') c = '_';
    }
    // OBJ files have comments after #, and lines that continue after a backslash.
    if (word.starts_with('#')) word.front() = '_';
    if (word.ends_with('\\')) word.back() = '_';
    return word;
}

void SurfaceMesh::add_polygon(std::string_view group, std::span<const std::int64_t> corners, std::string_view cell) {
    const auto fail = [&](std::string_view problem) { throw UserError("{}: {} {}", file_, cell, problem); };
    if (corners.size() < 3)
        fail(fmt::format("is a polygon of {} points (three are the least). Remove it.", corners.size()));
    std::string polygon = "f";
    for (const std::int64_t corner : corners) {
        if (corner < 0 || static_cast<std::size_t>(corner) >= points_.size())
            fail(fmt::format("has point {}, of {} that count from 0. Correct the index.", corner, points_.size()));
        const Eigen::Vector3d& point = points_[static_cast<std::size_t>(corner)];
        if (!point.allFinite())
            fail(fmt::format("has a point at ({}, {}, {}), which is no place. Correct it.", point.x(), point.y(),
                             point.z()));
        const auto [vertex, is_new] = vertices_.try_emplace(static_cast<std::size_t>(corner), vertices_.size() + 1);
        if (is_new) text_ += fmt::format("v {} {} {}\n", point.x(), point.y(), point.z());
        polygon += fmt::format(" {}", vertex->second);
    }
    if (const std::string& word = word_of(group); word != group_) text_ += fmt::format("g {}\n", group_ = word);
    text_ += polygon + '\n';
}

const std::string& SurfaceMesh::word_of(std::string_view group) {
    const auto known = words_.find(group);
    if (known != words_.end()) return known->second;
    const std::string word = group.empty() ? std::string(unnamed_group) : as_word(group);
    std::string free = word;
    for (int number = 2; !used_.insert(free).second; ++number) free = fmt::format("{}.{}", word, number);
    return words_[std::string(group)] = free;
}

void SurfaceMesh::remark(std::string_view text) {
    notes_ += fmt::format("# {}{}\n", note_on_mesh, text);
}

std::string SurfaceMesh::as_obj() const {
    if (volume_cells_ == 0 && text_.empty())
        throw UserError("{}: no polygon (nothing would be computed). Write the mesh with its polygons.", file_);
    if (text_.empty())
        throw UserError(
            "{}: volume cells alone, {} of them (only surfaces exchange radiation). Extract the surface, "
            "as ParaView's filter Extract Surface does, or save the polygons of the boundary too.",
            file_, volume_cells_);
    if (volume_cells_ == 0) return notes_ + text_;
    return fmt::format("# {}{} volume cell{} left out (surfaces alone exchange radiation)\n{}{}", note_on_mesh,
                       volume_cells_, volume_cells_ == 1 ? " is" : "s are", notes_, text_);
}

std::string percent_decoded(std::string_view name) {
    std::string decoded;
    for (std::size_t i = 0; i < name.size(); ++i) {
        unsigned char code = 0;
        const std::string_view digits = name.substr(std::min(i + 1, name.size()), 2);
        const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), code, 16);
        const bool is_code = name[i] == '%' && error == std::errc() && end == digits.data() + 2;
        decoded += is_code ? static_cast<char>(code) : name[i];
        if (is_code) i += 2;
    }
    return decoded;
}

const MeshKind* mesh_kind(std::string_view bytes) {
    const auto* const found =
        std::find_if(kinds.begin(), kinds.end(), [&](const MeshKind& kind) { return kind.is_that_of(bytes); });
    return found == kinds.end() ? nullptr : found;
}

}  // namespace ff::studies::meshes
