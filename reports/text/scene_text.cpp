#include "reports/text/scene_text.hpp"

#include "core/geometry/scene.hpp"
#include "reports/text/numbers.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace ff::reports {
namespace {

constexpr std::size_t most_listed = 12;

/// Lines below a heading, those beyond the most counted.
std::string listed(std::string_view heading, const std::vector<std::string>& lines, std::size_t most = most_listed) {
    std::string out = fmt::format("{}:\n", heading);
    for (std::size_t i = 0; i < std::min(lines.size(), most); ++i) out += fmt::format("  {}\n", lines[i]);
    if (lines.size() > most) out += fmt::format("  and {} more\n", lines.size() - most);
    return out;
}

/// ", grid 4 × 1"; nothing in a scene without grids.
std::string grids_text(const std::vector<Grid>& grids) {
    if (grids.empty()) return {};
    std::vector<std::string> texts;
    for (const Grid& grid : grids) texts.push_back(fmt::format("{} × {}", grid.columns, grid.rows));
    return fmt::format(", grid{} {}", grids.size() == 1 ? "" : "s", fmt::join(texts, ", "));
}

}  // namespace

SceneText scene_text(const Scene& scene, const studies::SceneExplanation& explanation) {
    SceneText text;
    text.summary = fmt::format("{}, {}", counted(scene.surfaces.size(), "surface"), scene.closed ? "closed" : "open");
    if (explanation.occluders > 0)
        text.summary += fmt::format(", {} of them only {} in the way", explanation.occluders,
                                    explanation.occluders == 1 ? "stands" : "stand");
    std::vector<std::string> faces;
    for (std::size_t face = 0; face < scene.faces.size(); ++face) {
        const std::size_t surfaces = explanation.surfaces[face];
        faces.push_back(fmt::format("{}: area {:.6g}{}{}", scene.faces[face], explanation.areas[face],
                                    surfaces == 1 ? "" : fmt::format(", {} surfaces", surfaces),
                                    grids_text(explanation.grids[face])));
    }
    text.details = listed("Faces", faces);
    std::vector<std::string> pairs;
    for (const studies::ExplainedPair& pair : explanation.pairs) {
        const auto label = [&](int face) { return scene.faces[static_cast<std::size_t>(face)]; };
        pairs.push_back(fmt::format("F {}-{} = {:.15f}  {} [{}]", label(pair.from), label(pair.to), pair.exact,
                                    pair.origin, pair.reference));
    }
    if (!pairs.empty()) text.details += listed("Exact", pairs);
    if (explanation.unknown_pairs > 0)
        text.details += fmt::format("No exact value: {} that face each other\n",
                                    counted(explanation.unknown_pairs, pairs.empty() ? "pair" : "other pair"));
    std::vector<std::string> estimators;
    for (const studies::ExplainedEstimator& estimator : explanation.estimators)
        estimators.push_back(estimator.why_not ? fmt::format("not {}: {}", estimator.name, *estimator.why_not)
                                               : estimator.name);
    text.details += listed("Estimators", estimators, estimators.size());
    return text;
}

}  // namespace ff::reports
