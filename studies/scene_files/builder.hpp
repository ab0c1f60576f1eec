#pragma once

#include "core/geometry/scene.hpp"
#include "studies/scene_files/scene_file.hpp"

#include <cstdint>
#include <string>
#include <string_view>
#include <unordered_map>
#include <unordered_set>
#include <vector>

namespace ff::studies {

/// Least area of a surface relative to its squared extent.
inline constexpr double least_share_of_area = 1e-12;

/// Collects the surfaces of a scene file, and rejects unusable ones by file and line.
class SceneBuilder {
  public:
    /// @param name  of the file, for messages and as the scene's name
    explicit SceneBuilder(std::string_view name) : name_(name) {}

    /// The face of that name; a new one if there is none.
    /// @throws UserError where the name cannot be used in tables and files
    int face(const std::string& label, std::uint64_t line);

    /// @throws UserError where the surface has no area, a number is not finite or too large
    void add(Surface surface, std::uint64_t line);

    /// A polygon of three or more corners, counter-clockwise from its radiating side: a parallelogram where it is one,
    /// else triangles from the first corner.
    /// @throws UserError also where it is not convex, or not plane to 1e-6 of its size
    void add_polygon(const std::vector<Eigen::Vector3d>& corners, int face, std::uint64_t line);

    [[noreturn]] void fail(std::uint64_t line, std::string_view problem) const;

    /// Cuts out what bodies cover that stand on surfaces. Faces of which nothing is left are left out.
    /// @param materials  of the faces; those of faces that are left out are taken out. Null: none
    /// @throws UserError where there is no surface, no face, a face without surfaces, or a surface twice
    Scene finish(bool closed, std::vector<FaceMaterial>* materials = nullptr);

  private:
    [[nodiscard]] std::string owner(int face) const;
    void note(const Eigen::Vector3d& place);
    void append(Surface surface, std::uint64_t line);
    void cut_out_covered_parts(std::vector<FaceMaterial>* materials);

    std::string name_;
    Scene scene_;
    std::unordered_map<std::string, int> faces_;
    std::vector<std::uint64_t> lines_;        ///< one per surface
    std::unordered_set<double> coordinates_;  ///< different ones, without signs and 0; of a large file, the first
};

}  // namespace ff::studies
