#include "reports/text/study_text.hpp"

#include "studies/scene_files/scene_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>

namespace ff::reports {
namespace {

/// Longer ones bury what the rest of the page says; a mesh has a million.
constexpr std::ptrdiff_t most_scene_lines = 60;
constexpr int lines_shown = 20;

/// Cuts a scene's text short. @return whether it was long
bool shorten(std::string& scene) {
    const std::ptrdiff_t lines = std::count(scene.begin(), scene.end(), '\n') - (scene.ends_with('\n') ? 1 : 0);
    if (lines <= most_scene_lines) return false;
    std::size_t end = scene.find('\n');  // of the name
    for (int line = 0; line < lines_shown; ++line) end = scene.find('\n', end + 1);
    scene.resize(end);
    scene += fmt::format("\n… {} more lines: results.sqlite has them", lines - lines_shown);
    return true;
}

}  // namespace

StudyText study_text(studies::StudySpec spec) {
    StudyText result;
    for (std::string& scene : spec.scenes) {
        if (studies::has_scene_text(scene) && shorten(scene)) result.whole = false;
    }
    result.text = studies::to_toml(spec);
    return result;
}

}  // namespace ff::reports
