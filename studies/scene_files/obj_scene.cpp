#include "studies/scene_files/builder.hpp"
#include "studies/scene_files/formats.hpp"
#include "studies/scene_files/meshes/formats.hpp"
#include "studies/scene_files/scene_file.hpp"

#include "core/geometry/placement.hpp"
#include "core/support/error.hpp"
#include "core/support/excerpt.hpp"
#include "core/support/nearest_name.hpp"
#include "core/support/words.hpp"
#include "studies/readers/printable.hpp"
#include "studies/scene_files/scene_with_materials.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <set>
#include <string>
#include <string_view>
#include <unordered_map>
#include <unordered_set>
#include <utility>
#include <vector>

namespace ff::studies {
namespace {

constexpr char up_in_scenes = 'z';
/// Statements of OBJ files that add no polygon.
constexpr std::array<std::string_view, 36> without_polygons{
    "vt",     "vn",    "vp",         "p",         "l",        "s",    "mg",   "mtllib", "maplib",
    "usemap", "bevel", "lod",        "c_interp",  "d_interp", "end",  "parm", "trim",   "hole",
    "scrv",   "sp",    "con",        "cstype",    "deg",      "bmat", "step", "curv",   "curv2",
    "ctech",  "stech", "shadow_obj", "trace_obj", "bzp",      "bsp",  "cdc",  "cdp",    "res"};

/// The group, object and material of a polygon, as numbers of names.
struct Owners {
    std::size_t group = 0;     ///< name given by `g`, or by `o` where there is none
    std::size_t object = 0;    ///< name given by `o`
    std::size_t material = 0;  ///< name given by `usemtl`
};

struct Polygon {
    std::uint64_t line = 0;
    Owners owners;
    std::vector<std::int64_t> corners;  ///< numbers of vertices, from 0, which may follow later in the file
    std::int64_t vertices_before = 0;   ///< number of vertices above it in the file

    /// A number of a vertex that does not exist, as written in the file.
    [[nodiscard]] std::int64_t written(std::int64_t vertex) const {
        return vertex < 0 ? vertex - vertices_before : vertex + 1;
    }
};

/// Names by number, in the order of their first use; the first is empty.
class NumberedNames {
  public:
    std::size_t number(std::string name) {
        const auto [entry, is_new] = numbers_.try_emplace(name, names_.size());
        if (is_new) names_.push_back(std::move(name));
        return entry->second;
    }
    const std::string& operator[](std::size_t number) const { return names_[number]; }

  private:
    std::vector<std::string> names_{""};
    std::unordered_map<std::string, std::size_t> numbers_{{"", 0}};
};

/// Reads the lines of an OBJ file; lines that do not concern polygons are skipped.
class ObjReader {
  public:
    explicit ObjReader(std::string_view name)
        : builder_(name, names_mesh(name) ? Lines::of_converted_mesh : Lines::of_file) {}

    void read_line(std::uint64_t line, std::string_view text) {
        auto words = split_words(text);
        if (words.empty()) return;
        const std::string_view keyword = words[0];
        const bool is_polygon = keyword == "f" || keyword == "fo";  // in older files
        // Elsewhere what begins with # is a part of a name.
        if (keyword == "v" || is_polygon)
            words.erase(std::ranges::find_if(words, [](auto word) { return word.starts_with('#'); }), words.end());
        if (keyword == "v") {
            read_vertex(line, words);
        } else if (is_polygon) {
            read_polygon(line, words);
        } else if (keyword == "g") {
            owners_.group = names_.number(rest(words));
            if (owners_.group == 0) owners_.group = owners_.object;
        } else if (keyword == "o") {
            owners_.object = owners_.group = names_.number(rest(words));
        } else if (keyword == "usemtl") {
            owners_.material = names_.number(rest(words));
        } else if (keyword == "#") {
            read_comment(rest(words));
        } else if (keyword == "surf" || keyword == "call" || keyword == "csh") {
            builder_.fail(line, "'{}' {}. Write the scene as polygons, in one file.", keyword,
                          keyword == "surf" ? "is a free-form surface (only polygons are read)"
                                            : "takes what it adds from elsewhere (only this file is read)");
        } else if (!keyword.starts_with('#') &&
                   std::ranges::find(without_polygons, keyword) == without_polygons.end()) {
            unknown_.emplace_back(line, keyword);
        }
    }

    SceneWithMaterials finish() {
        remark_on_unknown();
        choose_faces();
        if (faces_ == "polygon") builder_.let_polygons_be_faces();
        for (const Polygon& polygon : polygons_) add(polygon);
        remark_on_lost_faces();
        if (scale_ != 1) builder_.remark("its lengths are multiplied by {}", scale_);
        if (up_ != up_in_scenes) builder_.remark("its {} axis, which points up, becomes the z axis", up_);
        Scene scene = placed(builder_.finish(closed_, &materials_), {Eigen::Vector3d::Zero(), 1 / scale_});
        materials_.resize(scene.faces.size());
        return {std::move(scene), std::move(materials_), scale_};
    }

  private:
    using Words = std::vector<std::string_view>;

    SceneBuilder builder_;
    std::vector<Eigen::Vector3d> vertices_;
    std::vector<Polygon> polygons_;
    NumberedNames names_;
    Owners owners_;
    std::vector<std::pair<std::uint64_t, std::string>> unknown_;  ///< lines and what they begin with
    std::string faces_;                                           ///< what a face is; empty: not said
    bool closed_ = false;
    double scale_ = 1;
    char up_ = up_in_scenes;
    std::unordered_map<std::size_t, std::size_t> polygons_of_;  ///< number of polygons so far, by name
    std::vector<FaceMaterial> materials_;
    std::vector<std::string> without_area_;  ///< names of the faces of polygons that have none

    static std::string rest(const Words& words) {
        return fmt::format("{}", fmt::join(words.begin() + 1, words.end(), " "));
    }

    void read_vertex(std::uint64_t line, const Words& words) {
        Eigen::Vector3d place;
        for (std::size_t i = 0; i < 3; ++i) {
            const auto coordinate = i + 1 < words.size() ? finite_number(words[i + 1]) : std::nullopt;
            if (!coordinate) builder_.fail(line, "a vertex needs three finite coordinates. Write v 0 1 0.5.");
            place[static_cast<Eigen::Index>(i)] = *coordinate;
        }
        vertices_.push_back(place);
    }

    void read_polygon(std::uint64_t line, const Words& words) {
        if (words.size() < 2) builder_.fail(line, "a polygon needs three corners or more. Remove it.");
        Polygon& polygon =
            polygons_.emplace_back(Polygon{line, owners_, {}, static_cast<std::int64_t>(vertices_.size())});
        for (std::size_t corner = 1; corner < words.size(); ++corner)
            polygon.corners.push_back(vertex_of(line, corner, words[corner]));
    }

    /// The vertex of a corner like "3", "3/1/2", "3//2" or "-1".
    [[nodiscard]] std::int64_t vertex_of(std::uint64_t line, std::size_t corner, std::string_view word) const {
        const auto index = [](std::string_view text) { return parse_number<std::int32_t>(text).value_or(0); };
        const auto indices = split_at('/', word);
        const bool good = indices.size() <= 3 && index(indices[0]) != 0 &&
                          std::all_of(indices.begin() + 1, indices.end(),
                                      [&](std::string_view other) { return other.empty() || index(other) != 0; });
        if (!good)
            builder_.fail(line, "corner {} is '{}' (vertices count from 1, or back from -1). Write f 1 2 3.", corner,
                          excerpt(word));
        const std::int64_t given = index(indices[0]);
        return given > 0 ? given - 1 : static_cast<std::int64_t>(vertices_.size()) + given;
    }

    void read_comment(std::string comment) {
        if (comment.starts_with(meshes::note_on_mesh))
            return builder_.remark(comment.substr(meshes::note_on_mesh.size()));
        comment = in_small_letters(comment);
        closed_ = closed_ || comment == closed_scene;
        const auto words = split_words(comment);
        if (words.size() != 2) return;  // a sentence
        const std::string_view value = words[1];
        if (words[0] == "faces") {
            if (std::ranges::find(obj_faces, value) != obj_faces.end())
                faces_ = value;
            else if (const std::string hint = did_you_mean(value, obj_faces); !hint.empty())
                builder_.remark("the comment '# {}' says nothing. {}", excerpt(comment), trimmed(hint));
        } else if (words[0] == "up") {
            if (std::ranges::find(obj_axes, value) != obj_axes.end())
                up_ = value.front();
            else if (value.size() == 2)
                builder_.remark("the comment '# {}' says nothing (x, y or z can point up)", excerpt(comment));
        } else if (words[0] == "scale") {
            const auto scale = finite_number(value);
            if (scale && is_scale(*scale))
                scale_ = *scale;
            else if (scale)
                builder_.remark("the comment '# {}' says nothing (a scale is from 1e-9 to 1e9)", excerpt(comment));
        }
    }

    void remark_on_unknown() {
        if (unknown_.empty()) return;
        const auto& [line, keyword] = unknown_.front();
        if (polygons_.empty())
            builder_.fail(line, "no line of an OBJ file begins with '{}', and none here with f. Check the format.",
                          excerpt(keyword));
        builder_.remark("{} with what is no statement of OBJ files, and {} passed over (the first, '{}', in line {})",
                        unknown_.size() == 1 ? "a line begins" : fmt::format("{} lines begin", unknown_.size()),
                        unknown_.size() == 1 ? "is" : "are", excerpt(keyword), line);
    }

    void remark_on_lost_faces() {
        constexpr std::size_t most_named = 3;
        std::vector<std::string> lost;
        for (const std::string& label : without_area_) {
            std::string name = fmt::format("'{}'", excerpt(label));
            if (!builder_.has_face(label) && std::find(lost.begin(), lost.end(), name) == lost.end())
                lost.push_back(std::move(name));
        }
        if (lost.empty()) return;
        builder_.remark("{} {} left out, since no polygon with an area is left of {}", first_names(lost, most_named),
                        lost.size() == 1 ? "is" : "are", lost.size() == 1 ? "it" : "them");
    }

    [[nodiscard]] bool is_occluder(const Polygon& polygon) const {
        return names_[polygon.owners.group] == occluder_group || names_[polygon.owners.object] == occluder_group;
    }

    /// How many different names the polygons that are not occluders have.
    template <class Member>
    [[nodiscard]] std::size_t count(Member member) const {
        std::unordered_set<std::size_t> different;
        for (const Polygon& polygon : polygons_) {
            if (!is_occluder(polygon)) different.insert(polygon.owners.*member);
        }
        return different.size();
    }

    /// Where nothing says what a face is, it is whatever distinguishes polygons: groups, or else objects or materials.
    void choose_faces() {
        if (!faces_.empty()) return;
        faces_ = "group";
        const std::size_t groups = count(&Owners::group);
        const std::size_t objects = count(&Owners::object);
        const std::size_t materials = count(&Owners::material);
        if (groups > 1) {
            std::set<std::pair<std::size_t, std::size_t>> kinds;
            for (const Polygon& polygon : polygons_) {
                if (!is_occluder(polygon)) kinds.emplace(polygon.owners.group, polygon.owners.material);
            }
            if (kinds.size() > groups)
                builder_.remark("its faces are its {} groups or objects (with --faces material its {} materials)",
                                groups, materials);
        } else if (std::max(objects, materials) > 1) {
            faces_ = objects > 1 ? "object" : "material";
            builder_.remark(
                "its faces are its {} {}s, since all polygons are of one group (with --faces group they are one face)",
                objects > 1 ? objects : materials, faces_);
        }
    }

    [[nodiscard]] std::string label_of(const Polygon& polygon) {
        const Owners& owners = polygon.owners;
        std::size_t name = owners.group;
        if (faces_ == "material" && owners.material != 0) name = owners.material;
        if (faces_ == "object") name = owners.object;
        const std::string label = name == 0 ? "1" : names_[name];
        return faces_ == "polygon" ? fmt::format("{}.{}", label, ++polygons_of_[name]) : label;
    }

    /// A place turned so that z points up.
    [[nodiscard]] Eigen::Vector3d upright(const Eigen::Vector3d& place) const {
        if (up_ == 'x') return {place.y(), place.z(), place.x()};
        if (up_ == 'y') return {place.x(), -place.z(), place.y()};
        return place;
    }

    void add(const Polygon& polygon) {
        std::vector<Eigen::Vector3d> corners;
        for (const std::int64_t vertex : polygon.corners) {
            if (vertex < 0 || vertex >= static_cast<std::int64_t>(vertices_.size()))
                builder_.fail(polygon.line, "corner {} is vertex {} (the file has {}). Correct the index.",
                              corners.size() + 1, polygon.written(vertex), vertices_.size());
            corners.push_back(upright(vertices_[static_cast<std::size_t>(vertex)]));
        }
        if (!builder_.has_area(corners, polygon.line)) {
            if (!is_occluder(polygon) && faces_ != "polygon") without_area_.push_back(label_of(polygon));
            return;
        }
        int face = no_face;
        if (!is_occluder(polygon)) {
            face = builder_.face(label_of(polygon), polygon.line);
            add_material(static_cast<std::size_t>(face), names_[polygon.owners.material]);
        }
        builder_.add_polygon(corners, face, polygon.line);
    }

    void add_material(std::size_t face, const std::string& name) {
        if (face >= materials_.size()) materials_.resize(face + 1);
        auto& known = materials_[face].names;
        if (!name.empty() && std::find(known.begin(), known.end(), name) == known.end()) known.push_back(name);
    }
};

}  // namespace

bool is_scale(double factor) {
    return factor >= 1e-9 && factor <= 1e9;
}

std::string with_obj_comment(std::string_view text, std::string_view comment) {
    return fmt::format("{}\n# {}\n", text, comment);
}

SceneWithMaterials read_obj_scene(std::string_view name, std::string_view text) {
    ObjReader reader(name);
    std::string continued;  // lines that end in a backslash, without it
    for_each_line(text, [&](std::uint64_t number, std::string_view line) {
        const std::string_view content = trimmed(line);
        const bool goes_on = content.ends_with('\\') && !content.starts_with('#');
        if (continued.empty() && !goes_on) return reader.read_line(number, content);
        continued += content.substr(0, content.size() - (goes_on ? 1 : 0));
        continued += ' ';
        if (!goes_on) reader.read_line(number, std::exchange(continued, {}));
    });
    reader.read_line(0, continued);
    return reader.finish();
}

}  // namespace ff::studies
