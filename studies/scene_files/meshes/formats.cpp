#include "studies/scene_files/meshes/formats.hpp"

#include <algorithm>
#include <array>

namespace ff::studies::meshes {
namespace {

bool begins_with_word(std::string_view bytes, std::string_view word) {
    constexpr std::string_view blanks = " \t\r\n";
    return bytes.starts_with(word) && bytes.size() > word.size() &&
           blanks.find(bytes[word.size()]) != std::string_view::npos;
}

using Recognises = bool (*)(std::string_view bytes);

constexpr std::array<std::pair<Recognises, MeshKind>, 7> kinds{{
    {[](std::string_view bytes) { return bytes.starts_with("# vtk DataFile"); },
     {"a VTK file", ".vtk", read_vtk_legacy}},
    {is_vtk_xml, {"a VTK file in XML", ".vtu", read_vtk_xml}},
    {[](std::string_view bytes) { return bytes.starts_with("$MeshFormat"); }, {"a mesh of gmsh", ".msh", read_gmsh}},
    {[](std::string_view bytes) { return bytes.starts_with("glTF"); }, {"a binary glTF file", ".glb"}},
    {[](std::string_view bytes) { return begins_with_word(bytes, "ply"); }, {"a PLY file", ".ply", read_ply}},
    {is_off, {"an OFF file", ".off", read_off}},
    {is_stl, {"an STL file", ".stl", read_stl}},
}};

}  // namespace

const MeshKind* mesh_kind(std::string_view bytes) {
    const auto* const found =
        std::find_if(kinds.begin(), kinds.end(), [&](const auto& kind) { return kind.first(bytes); });
    return found == kinds.end() ? nullptr : &found->second;
}

const MeshKind* mesh_kind_named(std::string_view extension) {
    const auto* const found = std::find_if(kinds.begin(), kinds.end(), [&](const auto& kind) {
        return kind.second.extension == extension && kind.second.read != nullptr;
    });
    return found == kinds.end() ? nullptr : &found->second;
}

}  // namespace ff::studies::meshes
