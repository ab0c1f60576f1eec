#pragma once

#include "core/geometry/scene.hpp"
#include "studies/readers/printable.hpp"

#include <fmt/format.h>

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace ff::studies {

/// Adds a text after the name of the scene.
template <class... Values>
void add(std::vector<std::string>& doubts, const Scene& scene, fmt::format_string<Values...> text, Values&&... values) {
    doubts.push_back(fmt::format("scene '{}': {}", scene.name, fmt::format(text, std::forward<Values>(values)...)));
}

inline std::string and_other_pairs(std::size_t count) {
    return count == 0 ? std::string() : fmt::format(" and {} other pair{}", count, count == 1 ? "" : "s");
}

/// The names of some faces, and how many more there are.
inline std::string names(const Scene& scene, const std::vector<std::size_t>& faces) {
    constexpr std::size_t most_named = 3;
    std::vector<std::string> all;
    for (const std::size_t face : faces) all.push_back(fmt::format("'{}'", scene.faces[face]));
    return fmt::format("{} {}", faces.size() == 1 ? "face" : "faces", first_names(std::move(all), most_named));
}

inline const std::string& name_of_face(const Scene& scene, int face) {
    return scene.faces[static_cast<std::size_t>(face)];
}

inline std::string face_in_words(const Scene& scene, int face) {
    return face < 0 ? std::string("an occluder") : fmt::format("face '{}'", name_of_face(scene, face));
}

}  // namespace ff::studies
