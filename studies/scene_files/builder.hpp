#pragma once

#include "core/geometry/fwd.hpp"
#include "core/geometry/scene.hpp"
#include "studies/scene_files/scene_file.hpp"

#include <Eigen/Core>

#include <fmt/format.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <unordered_map>
#include <unordered_set>
#include <utility>
#include <vector>

namespace ff::studies {

/// Why a polygon cannot be used as it is, but is left out, divided, turned round or shortened.
enum class PolygonChange { no_area, twice, bent, concave, turned, spiked };

/// Whether the lines of what is read are those of the user's file, and can be named to the user.
enum class Lines { of_file, of_converted_mesh };

/// Collects the surfaces of a scene file, and rejects unusable ones by file and line.
class SceneBuilder {
  public:
    /// @param name  of the file, for messages and as the scene's name
    explicit SceneBuilder(std::string_view name, Lines lines = Lines::of_file)
        : name_(name), has_lines_(lines == Lines::of_file) {}

    /// The face of that name; a new one if there is none.
    /// @throws UserError where the name cannot be used in tables and files
    int face(const std::string& label, std::uint64_t line);

    /// A new face, whose name gets a number where the name is already used.
    int new_face(const std::string& label, std::uint64_t line);

    /// Faces are polygons: those that are the same as others are left out.
    void let_polygons_be_faces() { has_named_faces_ = false; }

    /// Reserves a name that nothing else has: this one, or this one with a number appended.
    std::string reserve_name(const std::string& label, bool numbered = false);
    /// Whether there is a face of that name in the file.
    [[nodiscard]] bool has_face(const std::string& label) const { return faces_.contains(label); }
    [[nodiscard]] const std::string& name_of(int face) const { return scene_.faces[static_cast<std::size_t>(face)]; }

    /// @throws UserError where the surface has no area, a number is not finite or too large
    void add(Surface surface, std::uint64_t line);

    /// Whether a polygon has an area. Where it has none, a remark is added, and the polygon is to be left out.
    /// @throws UserError where its edges cross each other, so that the areas of its parts cancel out
    [[nodiscard]] bool has_area(const std::vector<Eigen::Vector3d>& corners, std::uint64_t line);

    /// A polygon of three or more corners, counter-clockwise from its radiating side: a parallelogram where it is one,
    /// otherwise triangles. A remark is added where it is not plane to 1e-6 of its size, not convex, or runs
    /// back along itself.
    /// @pre it has an area @throws UserError where its edges cross each other, or it is too large
    void add_polygon(const std::vector<Eigen::Vector3d>& outline, int face, std::uint64_t line);

    /// Adds a remark about the scene as read, which may have values in it as for fmt::format.
    void remark(std::string text) { scene_.remarks.push_back(std::move(text)); }
    template <class... Values>
    void remark(fmt::format_string<Values...> text, Values&&... values) {
        remark(fmt::format(text, std::forward<Values>(values)...));
    }

    /// Refuses what stands in a line; the problem may have values in it as for fmt::format.
    [[noreturn]] void fail(std::uint64_t line, std::string_view problem) const;
    template <class... Values>
    [[noreturn]] void fail(std::uint64_t line, fmt::format_string<Values...> problem, Values&&... values) const {
        fail(line, fmt::format(problem, std::forward<Values>(values)...));
    }

    /// Leaves out duplicates and triangles that are no higher than coordinates may be off, reverses polygons that face
    /// the other way than the rest of their face, and cuts out the parts of surfaces that bodies stand on. Faces of
    /// which nothing remains are left out.
    /// @param materials  of the faces; those of faces that are left out are removed. Null: none
    /// @throws UserError where there is no surface, no face, a face without surfaces, or a surface of two faces
    Scene finish(bool closed, std::vector<FaceMaterial>* materials = nullptr);

  private:
    [[nodiscard]] std::string owner(int face) const;
    [[nodiscard]] std::string free_name(const std::string& label, bool numbered = false) const;
    void note(PolygonChange change, std::uint64_t line) {
        changes_.at(static_cast<std::size_t>(change)).push_back(line);
    }
    void remark_on_changes();
    void remark_on_names();
    void leave_out_doubles();
    void leave_out_slivers();
    void leave_out(const std::vector<bool>& is_left_out);
    void note(const Eigen::Vector3d& place);
    void append(Surface surface, std::uint64_t line);
    void cut_out_covered_parts();
    void leave_out_empty_faces(std::vector<FaceMaterial>* materials);

    std::vector<std::string> names_with_bars_;  ///< names of faces with |, in quotes
    std::vector<std::string> formulas_;  ///< names of faces, in quotes, that spreadsheets would take for formulas
    std::string name_;
    bool has_lines_;
    bool has_named_faces_ = true;  ///< faces are not merely polygons with a number
    Scene scene_;
    std::unordered_map<std::string, int> faces_;         ///< faces by their names in the file
    std::unordered_set<std::string> names_;              ///< names that faces and masks have in the scene
    std::vector<std::uint64_t> lines_;                   ///< one per surface
    std::array<std::vector<std::uint64_t>, 6> changes_;  ///< lines of the polygons, by what was done with them
    bool has_windings_ = true;                           ///< every surface is a polygon whose corners tell its side
    std::unordered_set<double> coordinates_;  ///< different ones, without signs and 0; of a large file, the first
};

}  // namespace ff::studies
