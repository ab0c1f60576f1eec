#include "studies/scene_files/meshes/mesh_kind.hpp"

#include "studies/scene_files/meshes/formats.hpp"
#include "studies/scene_files/meshes/mesh_input.hpp"

#include <algorithm>
#include <array>

namespace ff::studies::meshes {
namespace {

/// It has no mark, but is as long as its number of triangles says.
bool is_binary_stl(std::string_view beginning, std::uint64_t size) {
    constexpr std::size_t header = 80;
    constexpr std::uint64_t triangle = 50;
    if (beginning.size() < header + int32_type.bytes) return false;
    auto input = MeshInput::part("", beginning.substr(header), Encoding::little_endian);
    const auto triangles = static_cast<std::uint64_t>(input.whole({NumberType::Kind::natural, 4}));
    return triangles > 0 && size == header + int32_type.bytes + triangle * triangles;
}

bool begins_with_word(std::string_view beginning, std::string_view word) {
    constexpr std::string_view blanks = " \t\r\n";
    return beginning.starts_with(word) && beginning.size() > word.size() &&
           blanks.find(beginning[word.size()]) != std::string_view::npos;
}

using Recognises = bool (*)(std::string_view beginning, std::uint64_t size);

constexpr std::array<std::pair<Recognises, MeshKind>, 8> kinds{{
    {[](std::string_view beginning, std::uint64_t) { return is_vtk_legacy(beginning); },
     {"a VTK file", ".vtk", read_vtk_legacy}},
    {[](std::string_view beginning, std::uint64_t) { return is_vtk_xml(beginning); },
     {"a VTK file in XML", ".vtu", read_vtk_xml}},
    {[](std::string_view beginning, std::uint64_t) { return is_gmsh(beginning); },
     {"a mesh of gmsh", ".msh", read_gmsh}},
    {[](std::string_view beginning, std::uint64_t) { return beginning.starts_with("glTF"); },
     {"a binary glTF file", ".glb"}},
    {[](std::string_view beginning, std::uint64_t) { return begins_with_word(beginning, "ply"); },
     {"a PLY file", ".ply"}},
    {[](std::string_view beginning, std::uint64_t) { return begins_with_word(beginning, "OFF"); },
     {"an OFF file", ".off"}},
    {[](std::string_view beginning, std::uint64_t) { return is_text_stl(beginning); }, {"an STL file", ".stl"}},
    {is_binary_stl, {"a binary STL file", ".stl"}},
}};

}  // namespace

bool is_text_stl(std::string_view beginning) {
    return beginning.starts_with("solid") && beginning.find("facet") != std::string_view::npos;
}

const MeshKind* mesh_kind(std::string_view beginning, std::uint64_t size) {
    const auto* const found =
        std::find_if(kinds.begin(), kinds.end(), [&](const auto& kind) { return kind.first(beginning, size); });
    return found == kinds.end() ? nullptr : &found->second;
}

}  // namespace ff::studies::meshes
