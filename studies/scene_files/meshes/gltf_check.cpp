#include "core/support/excerpt.hpp"
#include "studies/readers/json_reader.hpp"
#include "studies/scene_files/meshes/formats.hpp"
#include "studies/scene_files/meshes/mesh_input.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace ff::studies::meshes {
namespace {

// The format: https://registry.khronos.org/glTF/specs/2.0/glTF-2.0.html

/// Extensions whose names begin with these texts do not affect shapes and places.
constexpr std::array<std::string_view, 8> extensions_of_looks{"KHR_materials_", "KHR_texture_",    "KHR_lights_",
                                                              "KHR_xmp",        "EXT_texture_",    "EXT_lights_",
                                                              "MSFT_texture_",  "ADOBE_materials_"};
/// These extensions do affect them, even where a file says that it can be read without them.
constexpr std::array<std::string_view, 5> extensions_of_shapes{"EXT_mesh_gpu_instancing", "KHR_draco_mesh_compression",
                                                               "EXT_meshopt_compression", "KHR_meshopt_compression",
                                                               "KHR_node_visibility"};
constexpr double single_precision_code = 5126;
constexpr int bytes_of_place = 12;
constexpr double mode_of_triangles =
    4;  // the mode of a primitive; below it are points and lines, above it strips and fans

std::string_view json_of(std::string_view file, std::string_view bytes) {
    if (!bytes.starts_with("glTF")) return bytes;
    constexpr NumberType size_type{NumberType::Kind::natural, 4};
    MeshInput in(file, bytes);
    in.set_encoding(Encoding::little_endian);
    in.skip_bytes(2 * size_type.bytes);  // the mark and the version
    const std::int64_t whole = in.whole(size_type);
    if (std::cmp_greater(whole, bytes.size()))
        in.fail("{} bytes are announced, and the file has {} (it was cut off). Write it again.", whole, bytes.size());
    const std::int64_t json = in.whole(size_type);
    in.skip_bytes(size_type.bytes);  // the kind of what follows: in both versions JSON comes first
    return in.take_bytes(static_cast<std::size_t>(json));
}

class GltfCheck {
  public:
    GltfCheck(std::string_view file, std::string_view json) : reader_(file), root_(parse_json(json, file)) {}

    void run() const {
        for (const JsonValue& name : items(root_, "extensionsRequired")) {
            if (std::none_of(extensions_of_looks.begin(), extensions_of_looks.end(),
                             [&](std::string_view start) { return name.text.starts_with(start); }))
                refuse_extension(name, name.text);
        }
        expect_no_extension_of_shapes(root_);
        for (const JsonValue& mesh : items(root_, "meshes")) {
            expect_no_morphing(mesh);
            for (const JsonValue& primitive : items(mesh, "primitives")) expect_real_places(primitive);
        }
        for (const JsonValue& node : items(root_, "nodes")) {
            expect_no_morphing(node);
            // Version 5.2 of the library ends the program over a skin whose matrices are left to their defaults.
            if (const JsonValue* const skin = node.find("skin"))
                reader_.fail(
                    *skin,
                    "a node has a skin (only shapes at rest are read). Write the mesh as it is to be, without a skin.");
        }
        if (has_numbers()) expect_numbers_that_exist();
    }

    /// The number of triangles in the meshes of the scene, each counted once; 0 where it is not known. @pre it has run
    [[nodiscard]] std::size_t triangles_announced() const {
        std::size_t sum = 0;
        for (const std::size_t mesh : meshes_of_scene()) {
            for (const JsonValue& primitive : items(items(root_, "meshes")[mesh], "primitives")) {
                const JsonValue* const position = place_of(primitive);
                if (position == nullptr || mode_of(primitive) < mode_of_triangles) continue;
                const std::size_t corners = corners_of(primitive, *position);
                sum +=
                    mode_of(primitive) == mode_of_triangles ? corners / 3 : corners - std::min<std::size_t>(corners, 2);
            }
        }
        return sum;
    }

  private:
    JsonReader reader_;
    JsonValue root_;

    /// The items of a member; none where there is no such member.
    static const std::vector<JsonValue>& items(const JsonValue& value, std::string_view key) {
        static const std::vector<JsonValue> none;
        const JsonValue* const member = value.find(key);
        return member == nullptr ? none : member->items;
    }

    /// Version 1 of the format has names instead, and an object where version 2 has a list.
    [[nodiscard]] bool has_numbers() const {
        const JsonValue* const meshes = root_.find("meshes");
        return meshes != nullptr && meshes->kind == JsonValue::Kind::array;
    }

    /// Meshes of the nodes that the scene has; other scenes and nodes are not read.
    [[nodiscard]] std::set<std::size_t> meshes_of_scene() const {
        std::set<std::size_t> meshes;
        const std::vector<JsonValue>& scenes = items(root_, "scenes");
        const std::vector<JsonValue>& nodes = items(root_, "nodes");
        const JsonValue* const chosen = root_.find("scene");
        const std::size_t scene = chosen == nullptr ? 0 : static_cast<std::size_t>(chosen->number);
        if (!has_numbers() || scene >= scenes.size()) return meshes;
        std::set<std::size_t> met;
        std::vector<const JsonValue*> left;
        const auto meet = [&](const JsonValue& owner, std::string_view key) {
            for (const JsonValue& number : items(owner, key)) {
                const auto node = static_cast<std::size_t>(number.number);
                if (met.insert(node).second) left.push_back(&nodes[node]);
            }
        };
        meet(scenes[scene], "nodes");
        while (!left.empty()) {
            const JsonValue& node = *left.back();
            left.pop_back();
            if (const JsonValue* const mesh = node.find("mesh")) meshes.insert(static_cast<std::size_t>(mesh->number));
            meet(node, "children");
        }
        return meshes;
    }

    void expect_numbers_that_exist() const {
        expect_item(root_, "scene", "scenes");

        for (const JsonValue& view : items(root_, "bufferViews")) {
            expect_item(view, "buffer", "buffers");
            expect_natural(view, "byteOffset");
            expect_natural(view, "byteLength");
        }
        for (const JsonValue& accessor : items(root_, "accessors")) {
            expect_item(accessor, "bufferView", "bufferViews");
            expect_natural(accessor, "byteOffset");
            expect_natural(accessor, "count");
        }
        for (const JsonValue& mesh : items(root_, "meshes")) {
            for (const JsonValue& primitive : items(mesh, "primitives")) expect_whole_polygons(primitive);
        }
        for (const JsonValue& scene : items(root_, "scenes")) expect_items(scene, "nodes", "nodes");
        for (const JsonValue& node : items(root_, "nodes")) {
            expect_item(node, "mesh", "meshes");
            expect_items(node, "children", "nodes");
            expect_numbers(node, "matrix", 16);
            expect_numbers(node, "translation", 3);
            expect_numbers(node, "rotation", 4);
            expect_numbers(node, "scale", 3);
        }
    }

    [[noreturn]] void refuse_extension(const JsonValue& at, std::string_view name) const {
        reader_.fail(
            at,
            fmt::format(
                "the extension {} is needed and not read (it may change shapes or places). Write the file without it.",
                excerpt(name)));
    }

    void expect_no_extension_of_shapes(const JsonValue& value) const {
        for (std::size_t i = 0; i < value.items.size(); ++i) {
            const std::string_view key = i < value.keys.size() ? std::string_view(value.keys[i]) : "";
            if (key == "extras") continue;  // data of other programs
            const JsonValue& item = value.items[i];
            for (const std::string_view extension : extensions_of_shapes) {
                const JsonValue* const used = key == "extensions" ? item.find(extension) : nullptr;
                if (used != nullptr) refuse_extension(*used, extension);
            }
            expect_no_extension_of_shapes(item);
        }
    }

    void expect_no_morphing(const JsonValue& value) const {
        for (const JsonValue& weight : items(value, "weights")) {
            if (weight.number != 0)
                reader_.fail(weight, fmt::format("a morph target has weight {} (only shapes at rest are read). Write "
                                                 "the mesh as it is to be, without targets.",
                                                 weight.number));
        }
    }

    /// A whole number from 0 on, where there is such a member.
    void expect_natural(const JsonValue& value, std::string_view key) const {
        const JsonValue* const member = value.find(key);
        if (member == nullptr) return;
        const bool is_number = member->kind == JsonValue::Kind::number;
        constexpr double most = 1e15;  // bytes or things; whole numbers in double precision are exact far above
        if (!is_number || !(member->number >= 0 && member->number <= most) ||
            member->number != std::floor(member->number))
            reader_.fail(*member, fmt::format("{} is no whole number from 0 on. Correct it.", key));
    }

    /// The number of an item of a list of the file's.
    void expect_number(const JsonValue& number, std::string_view key, std::string_view list) const {
        const std::size_t count = items(root_, list).size();
        if (!(number.number >= 0 && number.number < static_cast<double>(count)))
            reader_.fail(number, fmt::format("{}: number {} of {} does not exist (there are {}, counted from 0). "
                                             "Correct it.",
                                             key, number.number, list, count));
    }

    void expect_item(const JsonValue& value, std::string_view key, std::string_view list) const {
        expect_natural(value, key);
        if (const JsonValue* const member = value.find(key)) expect_number(*member, key, list);
    }

    void expect_items(const JsonValue& value, std::string_view key, std::string_view list) const {
        for (const JsonValue& number : items(value, key)) expect_number(number, key, list);
    }

    void expect_numbers(const JsonValue& value, std::string_view key, std::size_t count) const {
        const JsonValue* const member = value.find(key);
        if (member != nullptr && member->items.size() != count)
            reader_.fail(*member, fmt::format("{} has {} numbers, and needs {}. Write the rest.", key,
                                              member->items.size(), count));
    }

    [[nodiscard]] const JsonValue& accessor(const JsonValue& number) const {
        return items(root_, "accessors")[static_cast<std::size_t>(number.number)];
    }

    /// Whole numbers are coordinates only by an extension.
    void expect_real_places(const JsonValue& primitive) const {
        const JsonValue* const position = place_of(primitive);
        const std::vector<JsonValue>& accessors = items(root_, "accessors");
        if (position == nullptr || !(position->number >= 0 && position->number < static_cast<double>(accessors.size())))
            return;
        const JsonValue* const type = accessor(*position).find("componentType");
        if (type != nullptr && type->number != single_precision_code) refuse_extension(*type, "KHR_mesh_quantization");
    }

    /// Places of three coordinates, and three corners for each triangle.
    void expect_whole_polygons(const JsonValue& primitive) const {
        const JsonValue* const position = place_of(primitive);
        if (position == nullptr) return;
        expect_item(*primitive.find("attributes"), "POSITION", "accessors");
        expect_item(primitive, "indices", "accessors");
        const JsonValue* const type = accessor(*position).find("type");
        if (type != nullptr && type->text != "VEC3")
            reader_.fail(*type, fmt::format("places are of type '{}' (they have three coordinates). Write VEC3.",
                                            excerpt(type->text)));
        if (const JsonValue* const view = accessor(*position).find("bufferView")) {
            const JsonValue* const stride =
                items(root_, "bufferViews")[static_cast<std::size_t>(view->number)].find("byteStride");
            if (stride != nullptr && stride->number < bytes_of_place)
                reader_.fail(*stride, fmt::format("byteStride is {}, and a place has {} bytes. Correct it.",
                                                  stride->number, bytes_of_place));
        }
        const std::size_t corners = corners_of(primitive, *position);
        if (mode_of(primitive) == mode_of_triangles && corners % 3 != 0)
            reader_.fail(primitive, fmt::format("its triangles have {} corners, which is no multiple of 3 (some are "
                                                "missing). Write the mesh again.",
                                                corners));
    }

    static const JsonValue* place_of(const JsonValue& primitive) {
        const JsonValue* const attributes = primitive.find("attributes");
        return attributes == nullptr ? nullptr : attributes->find("POSITION");
    }

    static double mode_of(const JsonValue& primitive) {
        const JsonValue* const mode = primitive.find("mode");
        return mode == nullptr ? mode_of_triangles : mode->number;
    }

    [[nodiscard]] std::size_t corners_of(const JsonValue& primitive, const JsonValue& position) const {
        const JsonValue* const indices = primitive.find("indices");
        const JsonValue* const count = accessor(indices == nullptr ? position : *indices).find("count");
        return count == nullptr ? 0 : static_cast<std::size_t>(count->number);
    }
};

}  // namespace

std::size_t expect_plain_gltf(std::string_view file, std::string_view bytes) {
    const GltfCheck check(file, json_of(file, bytes));
    check.run();
    return check.triangles_announced();
}

}  // namespace ff::studies::meshes
