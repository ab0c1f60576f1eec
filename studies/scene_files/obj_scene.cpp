#include "studies/scene_files/builder.hpp"
#include "studies/scene_files/formats.hpp"
#include "studies/scene_files/scene_file.hpp"

#include "core/support/error.hpp"
#include "core/support/excerpt.hpp"
#include "core/support/words.hpp"

#include <fmt/format.h>

// The header alone, so that coordinates are read as doubles: the packaged library was built for single precision.
#define TINYOBJLOADER_USE_DOUBLE
#define TINYOBJLOADER_IMPLEMENTATION
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wconversion"
#pragma GCC diagnostic ignored "-Wsign-conversion"
#pragma GCC diagnostic ignored "-Wold-style-cast"
#pragma GCC diagnostic ignored "-Wshadow"
#include <tiny_obj_loader.h>
#pragma GCC diagnostic pop
#undef TINYOBJLOADER_IMPLEMENTATION
#undef TINYOBJLOADER_USE_DOUBLE

#include <algorithm>
#include <array>
#include <string>
#include <string_view>
#include <unordered_map>
#include <utility>
#include <vector>

namespace ff::studies {
namespace {

/// The loader counts the corners of a polygon in a byte.
constexpr std::size_t most_corners = 255;

/// Lines that the loader gets. It computes with what stands in others, and not always with care.
constexpr std::array<std::string_view, 6> shape_keywords{"v", "vt", "vn", "f", "g", "o"};

/// What the loader is given, and what it does not tell: lines of polygons, and what it would take for 0.
struct Lines {
    std::string of_shapes;
    std::vector<std::uint64_t> of_polygon;
    std::vector<std::string> materials;            ///< by first use; the first is that of no name
    std::vector<std::size_t> material_of_polygon;  ///< in `materials`
    bool closed = false;
    bool faces_of_polygons = false;
    bool faces_of_materials = false;
};

/// The loader reads what begins like a number, and wraps what does not fit.
/// @throws UserError where a corner is not an index of a vertex, with those of texture and normal behind slashes
void expect_indices(const SceneBuilder& builder, std::uint64_t line, const std::vector<std::string_view>& words) {
    const auto is_index = [](std::string_view text) { return parse_number<std::int32_t>(text).value_or(0) != 0; };
    for (std::size_t corner = 1; corner < words.size(); ++corner) {
        const auto indices = split_at('/', words[corner]);
        const bool good = indices.size() <= 3 && is_index(indices[0]) &&
                          std::all_of(indices.begin() + 1, indices.end(),
                                      [&](std::string_view index) { return index.empty() || is_index(index); });
        if (!good)
            builder.fail(line, fmt::format("corner {} is '{}' (vertices count from 1, or back from -1). Write f 1 2 3.",
                                           corner, excerpt(words[corner])));
    }
}

/// @throws UserError at a coordinate that is no number, at a corner that is no index, and at a group without polygons
Lines read_lines(const SceneBuilder& builder, std::string_view text) {
    Lines lines;
    lines.materials.emplace_back();
    std::size_t material = 0;
    std::string group;
    std::uint64_t group_line = 0;  // of a group that has no polygon yet
    const auto expect_polygons = [&] {
        if (group_line != 0) builder.fail(group_line, fmt::format("group '{}' is empty. Remove it.", excerpt(group)));
    };
    for_each_line(text, [&](std::uint64_t number, std::string_view line) {
        const auto words = split_words(line);
        const bool wanted =
            !words.empty() && std::find(shape_keywords.begin(), shape_keywords.end(), words[0]) != shape_keywords.end();
        if (wanted) lines.of_shapes += fmt::format("{}", fmt::join(words, " "));
        lines.of_shapes += '\n';  // so that the loader counts lines as we do
        if (words.empty()) return;
        if (words[0] == "v") {
            for (std::size_t i = 1; i <= 3; ++i) {
                if (i >= words.size() || !finite_number(words[i]))
                    builder.fail(number, "a vertex needs three finite coordinates. Write v 0 1 0.5.");
            }
        } else if (words[0] == "f") {
            if (words.size() < 4) builder.fail(number, "a polygon needs three corners or more. Remove it.");
            if (words.size() > 1 + most_corners)
                builder.fail(number, fmt::format("more than {} corners. Divide the polygon.", most_corners));
            expect_indices(builder, number, words);
            lines.of_polygon.push_back(number);
            lines.material_of_polygon.push_back(material);
            group_line = 0;
        } else if (words[0] == "g" && words.size() > 1) {
            expect_polygons();
            group = words[1];
            group_line = number;
        } else if (words[0] == "usemtl" && words.size() > 1) {
            material = static_cast<std::size_t>(std::find(lines.materials.begin(), lines.materials.end(), words[1]) -
                                                lines.materials.begin());
            if (material == lines.materials.size()) lines.materials.emplace_back(words[1]);
        } else if (words[0] == "#") {
            const std::string comment = fmt::format("{}", fmt::join(words.begin() + 1, words.end(), " "));
            lines.closed = lines.closed || comment == closed_scene;
            lines.faces_of_polygons = lines.faces_of_polygons || comment == faces_of_polygons;
            lines.faces_of_materials = lines.faces_of_materials || comment == faces_of_materials;
        }
    });
    expect_polygons();
    return lines;
}

/// Notes the name of a polygon's material, if it has one.
void add_name(std::vector<FaceMaterial>& materials, std::size_t face, const std::string& name) {
    if (face >= materials.size()) materials.resize(face + 1);
    auto& known = materials[face].names;
    if (!name.empty() && std::find(known.begin(), known.end(), name) == known.end()) known.push_back(name);
}

}  // namespace

std::string with_obj_comment(std::string_view text, std::string_view comment) {
    return fmt::format("{}\n# {}\n", text, comment);
}

SceneWithMaterials read_obj_scene(std::string_view name, std::string_view text) {
    SceneBuilder builder(name);
    const Lines lines = read_lines(builder, text);
    tinyobj::ObjReaderConfig config;
    config.triangulate = false;
    config.vertex_color = false;
    tinyobj::ObjReader reader;
    if (!reader.ParseFromString(lines.of_shapes, "", config)) {
        throw UserError(fmt::format("{}: cannot be read as OBJ ({}). See docs/scenes.md.", name, reader.Error()));
    }
    const auto& vertices = reader.GetAttrib().vertices;
    std::size_t polygon = 0;
    std::unordered_map<std::string, std::size_t> polygons_of;  // a group
    std::vector<FaceMaterial> materials;
    for (const tinyobj::shape_t& shape : reader.GetShapes()) {
        const std::string label = shape.name.empty() ? "1" : shape.name;
        const std::uint64_t first_line = polygon < lines.of_polygon.size() ? lines.of_polygon[polygon] : 1;
        const bool divided = (lines.faces_of_polygons || lines.faces_of_materials) && label != occluder_group;
        int face = no_face;
        if (label != occluder_group && !divided) face = builder.face(label, first_line);
        std::size_t first = 0;
        for (const auto corners_of_polygon : shape.mesh.num_face_vertices) {
            if (polygon >= lines.of_polygon.size()) break;
            const std::string& material = lines.materials[lines.material_of_polygon[polygon]];
            const std::uint64_t line = lines.of_polygon[polygon++];
            std::vector<Eigen::Vector3d> corners;
            for (std::size_t i = 0; i < corners_of_polygon; ++i) {
                const int index = shape.mesh.indices[first + i].vertex_index;
                if (index < 0 || static_cast<std::size_t>(index) >= vertices.size() / 3) {
                    builder.fail(line, fmt::format("corner {} of face '{}' is vertex {}, of {}. Mend the index.", i + 1,
                                                   label, index + 1, vertices.size() / 3));
                }
                const double* place = &vertices[3 * static_cast<std::size_t>(index)];
                corners.emplace_back(place[0], place[1], place[2]);
            }
            first += corners_of_polygon;
            if (divided) {
                const std::string& part = lines.faces_of_materials && !material.empty() ? material : label;
                face = builder.face(lines.faces_of_polygons ? fmt::format("{}.{}", part, ++polygons_of[part]) : part,
                                    line);
            }
            builder.add_polygon(corners, face, line);
            if (face != no_face) add_name(materials, static_cast<std::size_t>(face), material);
        }
    }
    Scene scene = builder.finish(lines.closed, &materials);
    materials.resize(scene.faces.size());
    return {std::move(scene), std::move(materials)};
}

}  // namespace ff::studies
