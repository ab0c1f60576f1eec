// A scene file is a scene whose areas are numbers and that can be traced, or a UserError. The first byte says which
// format it is.

#include "studies/scene_files/scene_file.hpp"
#include "core/support/error.hpp"
#include "tests/fuzz/one_input.hpp"

#include <array>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <string_view>

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    if (size == 0) return 0;
    constexpr std::array<std::string_view, 3> names{"a.obj", "a.vs3", "a.toml"};
    const std::string_view text{reinterpret_cast<const char*>(data) + 1, size - 1};
    try {
        const ff::Scene scene = ff::studies::make_scene(ff::studies::source_of_file(names[data[0] % 3], text));
        for (int face = 0; face < static_cast<int>(scene.faces.size()); ++face) {
            if (!(std::isfinite(ff::face_area(scene, face)) && ff::face_area(scene, face) > 0)) std::abort();
        }
        static_cast<void>(ff::studies::doubts_about(scene));
    } catch (const ff::UserError&) {
    }
    return 0;
}
