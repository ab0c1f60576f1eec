#include "studies/scene_files/polygon_changes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>
#include <utility>

namespace ff::studies {
namespace {

constexpr std::size_t most_lines_named = 3;

/// The messages for one polygon, and for several.
constexpr std::array<std::pair<std::string_view, std::string_view>, 5> words_of_changes{{
    {"has no area and is left out", "have no area and are left out"},
    {"is a copy of another and is left out", "are copies of others and are left out"},
    {"is not plane and is divided into triangles", "are not plane and are divided into triangles"},
    {"is not convex and is divided into triangles", "are not convex and are divided into triangles"},
    {"is wound in the opposite direction to the rest of its face and is turned round",
     "are wound in the opposite direction to the rest of their faces and are turned round"},
}};

}  // namespace

void PolygonChanges::note(PolygonChange change, std::uint64_t line) {
    lines_.at(static_cast<std::size_t>(change)).push_back(line);
}

std::vector<std::string> PolygonChanges::in_words() const {
    std::vector<std::string> texts;
    for (std::size_t kind = 0; kind < kinds; ++kind) {
        std::vector<std::uint64_t> lines = lines_[kind];
        if (lines.empty()) continue;
        std::sort(lines.begin(), lines.end());
        const std::size_t count = lines.size();
        lines.erase(std::unique(lines.begin(), lines.end()), lines.end());
        const std::size_t left = lines.size() - std::min(lines.size(), most_lines_named);
        lines.resize(lines.size() - left);
        const auto& [one, many] = words_of_changes[kind];
        std::string text = count == 1 ? fmt::format("a polygon {} (line {}", one, lines[0])
                                      : fmt::format("{} polygons {} ({} {}", count, many,
                                                    lines.size() == 1 ? "line" : "lines", fmt::join(lines, ", "));
        if (left > 0) text += fmt::format(" and {} more", left);
        texts.push_back(text + ")");
    }
    return texts;
}

}  // namespace ff::studies
