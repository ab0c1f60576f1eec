#pragma once

#include <Eigen/Core>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

namespace ff::studies {

/// Groups of this name are occluders rather than faces.
inline constexpr std::string_view occluder_group = "occluder";

}  // namespace ff::studies

namespace ff::studies::meshes {

/// The beginning of a comment in OBJ files that holds a note on a converted mesh.
inline constexpr std::string_view note_on_mesh = "note on the mesh: ";

/// The faces of a mesh without groups.
inline constexpr std::string_view unnamed_group = "mesh";

/// A name as a word of an OBJ file: blanks, control characters, | and characters with a meaning in OBJ files become _.
std::string as_word(std::string_view name);

/// The polygons of a mesh file, in groups.
class SurfaceMesh {
  public:
    /// @param file  names it in messages
    explicit SurfaceMesh(std::string_view file) : file_(file) {}

    /// Points get numbers from 0 in the order in which they are added.
    void add_point(const Eigen::Vector3d& point) { points_.push_back(point); }
    [[nodiscard]] std::size_t point_count() const { return points_.size(); }

    /// Adds a polygon. @param group  as the file has it; different groups stay apart where they become one word
    /// @param cell  names it in messages: "cell 3"
    /// @throws UserError where it has fewer than three corners, or one that is not a point or is not finite
    void add_polygon(std::string_view group, std::span<const std::int64_t> corners, std::string_view cell);

    void leave_out_volume_cell() { ++volume_cells_; }
    /// Adds a note on the mesh.
    void remark(std::string_view text);

    /// The text of an OBJ file; what no polygon uses is left out. @throws UserError where there is no polygon
    [[nodiscard]] std::string as_obj() const;

  private:
    std::string file_;
    std::vector<Eigen::Vector3d> points_;
    std::unordered_map<std::size_t, std::size_t> vertices_;  ///< number in the text, from 1, by that of the point
    std::string notes_;                                      ///< notes, as comments of an OBJ file
    std::string text_;
    std::string group_;
    std::map<std::string, std::string, std::less<>> words_;  ///< words of groups
    std::set<std::string> used_;                             ///< words that a group has
    std::uint64_t volume_cells_ = 0;

    const std::string& word_of(std::string_view group);
};

/// The kind of a mesh file, by its content.
struct MeshKind {
    std::string_view name;       ///< "a PLY file"
    std::string_view extension;  ///< extension that its name should have
    bool (*is_that_of)(std::string_view bytes);
    /// Reads all bytes of the file with that name; null where another library reads it. @throws UserError
    SurfaceMesh (*read)(std::string_view file, std::string_view bytes) = nullptr;
};

/// A name in which blanks and others stand as %20: those of arrays in VTK's files, and of files in glTF's.
std::string percent_decoded(std::string_view name);

/// Null where the content of a file does not tell.
const MeshKind* mesh_kind(std::string_view bytes);

// Each function reads the bytes of a file, whose name is for messages.
// @throws UserError "file: place: problem (why). Suggestion."

/// VTK's older format: polygons and unstructured grids, in text or binary. Groups are the values of the first array of
/// whole numbers or texts that differs between polygons.
SurfaceMesh read_vtk_legacy(std::string_view file, std::string_view bytes);

/// VTK's XML: the same, in text, base64 or appended bytes, compressed by zlib or not.
bool is_vtk_xml(std::string_view bytes);
SurfaceMesh read_vtk_xml(std::string_view file, std::string_view bytes);

/// gmsh's formats 2, 4.0 and 4.1, in text or binary. Groups are physical surfaces, by name, or else surfaces:
/// see GmshSurfaces.
SurfaceMesh read_gmsh(std::string_view file, std::string_view bytes);

/// STL in text or binary. Groups are the solids of a text.
bool is_stl(std::string_view bytes);
SurfaceMesh read_stl(std::string_view file, std::string_view bytes);

/// PLY in text or binary: faces and strips of triangles.
SurfaceMesh read_ply(std::string_view file, std::string_view bytes);

/// OFF in text, with places of three coordinates.
bool is_off(std::string_view bytes);
SurfaceMesh read_off(std::string_view file, std::string_view bytes);

/// Looks for features that move, pack or repeat polygons and that the library which reads glTF would silently ignore:
/// extensions, coordinates of whole numbers, and shapes that morph or have a skin. Nor does it say which items do not
/// exist, or that corners are missing.
/// @param bytes  of a .gltf or .glb file  @return the number of triangles in it, 0 where that is not known
/// @throws UserError "file: place: problem (why). Suggestion."
std::size_t expect_plain_gltf(std::string_view file, std::string_view bytes);

}  // namespace ff::studies::meshes
