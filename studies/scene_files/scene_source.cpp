#include "studies/scene_files/scene_source.hpp"

#include "studies/scene_files/formats.hpp"

#include <fmt/format.h>

namespace ff::studies {
namespace {

/// The name of an EnergyPlus file can be followed by this and the name of a zone.
constexpr std::string_view before_zone = " zone:";
/// The name of a scene can be followed by this and the faces that are mirrors.
constexpr std::string_view before_mirrors = " mirrors:";
constexpr char between_mirrors = '+';

}  // namespace

bool SceneSource::is_file() const {
    return has_extension(name, ".toml") || has_extension(name, ".obj") || has_extension(name, ".vs3") ||
           names_energyplus(name) || names_mesh(name);
}

std::string SceneSource::title() const {
    const std::string place = zone.empty() ? name : fmt::format("{}{}{}", name, before_zone, zone);
    if (mirrors.empty()) return place;
    return fmt::format("{}{}{}", place, before_mirrors, fmt::join(mirrors, std::string_view(&between_mirrors, 1)));
}

std::string SceneSource::written() const {
    return text ? fmt::format("{}\n{}", title(), *text) : title();
}

SceneSource scene_source(std::string_view written) {
    const std::size_t end = written.find('\n');
    if (end != std::string_view::npos) return source_of_file(written.substr(0, end), written.substr(end + 1));
    SceneSource source;
    const std::size_t at = written.rfind(before_mirrors);
    source.name = written.substr(0, at);
    const std::size_t zone = source.name.find(before_zone);
    if (zone != std::string::npos && names_energyplus(source.name.substr(0, zone))) {
        source.zone = source.name.substr(zone + before_zone.size());
        source.name.resize(zone);
    }
    if (at == std::string_view::npos) return source;
    std::string_view left = written.substr(at + before_mirrors.size());
    while (true) {
        const std::size_t next = left.find(between_mirrors);
        source.mirrors.emplace_back(left.substr(0, next));
        if (next == std::string_view::npos) return source;
        left.remove_prefix(next + 1);
    }
}

SceneSource source_of_file(std::string_view title, std::string_view text) {
    SceneSource source = scene_source(title);
    source.text = text;
    return source;
}

}  // namespace ff::studies
