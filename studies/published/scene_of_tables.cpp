#include "studies/published/scene_of_tables.hpp"

#include "core/support/error.hpp"
#include "studies/scene_files/scene_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>

namespace ff::studies {
namespace {

std::string json_text(std::string_view text) {
    std::string out = "\"";
    for (const char c : text) {
        if (c == '"' || c == '\\') {
            out += '\\';
            out += c;
        } else if (static_cast<unsigned char>(c) < 0x20) {
            out += fmt::format("\\u{:04x}", static_cast<int>(c));
        } else {
            out += c;
        }
    }
    return out + '"';
}

std::size_t offset_of(std::string_view text, TextPosition position) {
    std::size_t at = 0;
    for (int line = 1; line < position.line; ++line) at = text.find('\n', at) + 1;
    return at + static_cast<std::size_t>(position.column - 1);
}

/// Where the JSON string that begins at `start` ends.
std::size_t end_of_string(std::string_view text, std::size_t start) {
    std::size_t at = start + 1;
    while (text[at] != '"') at += text[at] == '\\' ? 2U : 1U;
    return at + 1;
}

}  // namespace

std::string with_scene_text(const std::string& text, const std::filesystem::path& file) {
    if (text.find_first_not_of(" \t\r\n") == std::string::npos) return text;
    const JsonValue root = parse_json(text, file.string());
    const JsonValue* scene = root.find("scene");
    if (scene == nullptr || scene->kind != JsonValue::Kind::string) return text;
    SceneSource source = scene_source(scene->text);
    if (!source.is_file() || source.text) return text;
    source.text = read_scene_file(file.parent_path() / source.name);
    const std::size_t start = offset_of(text, scene->position);
    return text.substr(0, start) + json_text(source.written()) + text.substr(end_of_string(text, start));
}

Scene read_scene_of_tables(const JsonReader& reader, const JsonValue& value, SceneSource& source) {
    JsonValue title = value;
    title.text.erase(std::min(title.text.find('\n'), title.text.size()));
    reader.text(title, "scene");  // what follows the title is a scene file, which may have line breaks
    source = scene_source(value.text);
    try {
        if (!source.mirrors.empty())
            throw UserError("tables of scenes with mirrors are not read. Name the scene alone.");
        Scene scene = make_scene(source);
        expect_no_masks(scene);
        if (scene.faces.size() > most_faces_of_tables) {
            throw UserError(fmt::format("scene '{}' has {} faces (tables may be of {} at most). Join faces.",
                                        scene.name, scene.faces.size(), most_faces_of_tables));
        }
        return scene;
    } catch (const UserError& error) {
        reader.fail(value, error.what());
    }
}

std::optional<std::pair<std::string, std::string>> split_pair(std::string_view text,
                                                              const std::vector<std::string>& faces) {
    const auto is_face = [&](std::string_view name) { return std::ranges::find(faces, name) != faces.end(); };
    std::optional<std::pair<std::string, std::string>> pair;
    for (std::size_t dash = text.find('-'); dash != std::string_view::npos; dash = text.find('-', dash + 1)) {
        const std::string_view from = text.substr(0, dash);
        const std::string_view to = text.substr(dash + 1);
        if (!is_face(from) || !is_face(to)) continue;
        if (pair)
            throw UserError(fmt::format("\"{}\" may be several pairs of faces. Rename a face of the scene.", text));
        pair.emplace(from, to);
    }
    return pair;
}

}  // namespace ff::studies
