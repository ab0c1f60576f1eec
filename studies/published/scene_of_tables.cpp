#include "studies/published/scene_of_tables.hpp"

#include "core/geometry/scene.hpp"
#include "core/support/error.hpp"
#include "studies/published/published.hpp"
#include "studies/readers/text_file.hpp"
#include "studies/scene_files/scene_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>

namespace ff::studies {
namespace {

/// Audits have unknowns for every pair of faces.
constexpr std::size_t most_faces_of_tables = 512;

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

/// The text of a tables file that needs no other file: where it names a scene file beside it, that file's text follows
/// the name. Columns of later values in that line move, lines do not.
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

}  // namespace

std::string read_tables_text(const std::filesystem::path& file) {
    return with_scene_text(read_text_file(file, FileKind::tables), file);
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
            throw UserError("scene '{}' has {} faces (tables may be of {} at most). Join faces.", scene.name,
                            scene.faces.size(), most_faces_of_tables);
        }
        return scene;
    } catch (const UserError& error) {
        reader.fail(value, error.what());
    }
}

}  // namespace ff::studies
