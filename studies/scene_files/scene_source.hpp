#pragma once

#include <compare>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace ff::studies {

/// Where a scene comes from. A study names a scene file beside it, whose text becomes part of the study, so that stores
/// need no other file and a changed text is a different study.
struct SceneSource {
    std::string name;                  ///< "cube", "box:1x2x3" or the name of a file
    std::string zone;                  ///< zone or space of an EnergyPlus file; empty: the only one
    std::vector<std::string> mirrors;  ///< faces that are mirrors
    /// Text of the file, a mesh converted to OBJ; empty for built-in scenes and until it is read.
    std::optional<std::string> text;

    /// Whether the name is that of a file: it ends with .toml, .obj, .vs3, .idf, .epJSON or an ending of
    /// meshes.
    [[nodiscard]] bool is_file() const;
    /// The name with its zone and its mirrors: "cube mirrors:6", with '+' between faces, "house.idf zone:Attic".
    [[nodiscard]] std::string title() const;
    /// The source as studies in stores have it: the title and, after a line break, the text.
    [[nodiscard]] std::string written() const;

    auto operator<=>(const SceneSource&) const = default;
};

/// The source that is written in this form.
SceneSource scene_source(std::string_view written);

/// A title with the text of that file.
SceneSource source_of_file(std::string_view title, std::string_view text);

}  // namespace ff::studies
