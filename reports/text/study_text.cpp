#include "reports/text/study_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>

namespace ff::reports {
namespace {

/// Longer texts bury the rest of the page; a mesh has a million lines.
constexpr std::ptrdiff_t most_scene_lines = 60;
constexpr int lines_shown = 20;

/// Cuts the text of a scene short. @return whether it was long
bool shorten(std::string& text) {
    const std::ptrdiff_t lines = std::count(text.begin(), text.end(), '\n') + (text.ends_with('\n') ? 0 : 1);
    if (lines <= most_scene_lines) return false;
    std::size_t end = text.find('\n');
    for (int line = 1; line < lines_shown; ++line) end = text.find('\n', end + 1);
    text.resize(end);
    text += fmt::format("\n… {} more lines: results.sqlite has them", lines - lines_shown);
    return true;
}

}  // namespace

StudyText study_text(studies::StudySpec spec) {
    StudyText result;
    for (studies::SceneSource& scene : spec.scenes) {
        if (scene.text && shorten(*scene.text)) result.whole = false;
    }
    result.text = studies::to_toml(spec);
    return result;
}

}  // namespace ff::reports
