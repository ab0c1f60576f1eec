// A scene file is a scene whose areas are numbers and that can be traced, or a UserError. The first byte says which
// format it is; for meshes the content does.

#include "studies/scene_files/scene_file.hpp"
#include "core/geometry/scene.hpp"
#include "core/support/error.hpp"
#include "studies/scene_files/meshes/formats.hpp"
#include "tests/fuzz/one_input.hpp"

#include <array>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <string_view>

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    if (size == 0) return 0;
    constexpr std::array<std::string_view, 6> names{"a.obj", "a.vs3", "a.toml", "a.vtk", "a.idf", "a.epJSON"};
    const std::string_view name = names[data[0] % names.size()];
    std::string text(reinterpret_cast<const char*>(data) + 1, size - 1);
    try {
        if (name == "a.vtk") {
            const auto* const kind = ff::studies::meshes::mesh_kind(text);
            if (kind == nullptr || kind->read == nullptr) return 0;
            text = kind->read(name, text).as_obj();
        }
        const ff::Scene scene = ff::studies::make_scene(ff::studies::source_of_file(name, text));
        for (int face = 0; face < static_cast<int>(scene.faces.size()); ++face) {
            if (!(std::isfinite(ff::face_area(scene, face)) && ff::face_area(scene, face) > 0)) std::abort();
        }
        static_cast<void>(ff::studies::doubts_about(scene));
    } catch (const ff::UserError&) {
    }
    return 0;
}
