#include "core/support/excerpt.hpp"
#include "studies/readers/json_reader.hpp"
#include "studies/scene_files/meshes/formats.hpp"
#include "studies/scene_files/meshes/mesh_input.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string>
#include <utility>
#include <vector>

// The format: https://registry.khronos.org/glTF/specs/2.0/glTF-2.0.html

namespace ff::studies::meshes {
namespace {

/// Extensions whose names begin with these texts do not affect shapes and places.
constexpr std::array<std::string_view, 8> extensions_of_looks{"KHR_materials_", "KHR_texture_",    "KHR_lights_",
                                                              "KHR_xmp",        "EXT_texture_",    "EXT_lights_",
                                                              "MSFT_texture_",  "ADOBE_materials_"};
/// These extensions do affect them, even where a file says that it can be read without them.
constexpr std::array<std::string_view, 5> extensions_of_shapes{"EXT_mesh_gpu_instancing", "KHR_draco_mesh_compression",
                                                               "EXT_meshopt_compression", "KHR_meshopt_compression",
                                                               "KHR_node_visibility"};
constexpr double single_precision_code = 5126;

std::string_view json_of(std::string_view file, std::string_view bytes) {
    if (!bytes.starts_with("glTF")) return bytes;
    constexpr NumberType size_type{NumberType::Kind::natural, 4};
    MeshInput in(file, bytes);
    in.set_encoding(Encoding::little_endian);
    in.skip_bytes(2 * size_type.bytes);  // the mark and the version
    const std::int64_t whole = in.whole(size_type);
    if (std::cmp_greater(whole, bytes.size()))
        in.fail(fmt::format("{} bytes are announced, and the file has {} (it was cut off). Write it again.", whole,
                            bytes.size()));
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
                reader_.fail(*skin,
                             "a node has a skin (only shapes at rest are read). Write the mesh as it is to be, "
                             "without a skin.");
        }
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

    [[noreturn]] void refuse_extension(const JsonValue& at, std::string_view name) const {
        reader_.fail(at,
                     fmt::format("the extension {} is needed and not read (it may change shapes or places). Write the "
                                 "file without it.",
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

    /// Whole numbers are coordinates only by an extension.
    void expect_real_places(const JsonValue& primitive) const {
        const JsonValue* const attributes = primitive.find("attributes");
        const JsonValue* const position = attributes == nullptr ? nullptr : attributes->find("POSITION");
        const std::vector<JsonValue>& accessors = items(root_, "accessors");
        if (position == nullptr || !(position->number >= 0 && position->number < static_cast<double>(accessors.size())))
            return;  // the library says what is wrong
        const JsonValue* const type = accessors[static_cast<std::size_t>(position->number)].find("componentType");
        if (type != nullptr && type->number != single_precision_code) refuse_extension(*type, "KHR_mesh_quantization");
    }
};

}  // namespace

void expect_plain_gltf(std::string_view file, std::string_view bytes) {
    GltfCheck(file, json_of(file, bytes)).run();
}

}  // namespace ff::studies::meshes
