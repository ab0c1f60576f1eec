#include "studies/explain/scene_explanation.hpp"

#include "core/configurations/catalogue.hpp"
#include "core/configurations/families.hpp"
#include "core/estimators/estimator.hpp"
#include "core/exact/known_factors.hpp"
#include "core/visibility/facing.hpp"
#include "core/visibility/mirrors.hpp"

#include <algorithm>
#include <optional>
#include <utility>

namespace ff::studies {
namespace {

/// In scenes with more faces, pairs are not examined one by one.
constexpr std::size_t most_faces = 256;

void add_origin(const Scene& scene, ExplainedPair& pair) {
    if (!known_form_factor(scene, pair.from, pair.to)) {
        pair.origin = "closed form, nothing can stand in between";
        pair.reference = "howell";
        return;
    }
    const auto member = family_member(scene);
    for (const Configuration& configuration : configurations()) {
        const bool same =
            member ? configuration.scene_name == member->family->name : is_configuration(scene, configuration);
        if (!same) continue;
        // Where several configurations have the same scene, the one that states this very pair is named. A pair whose
        // factor only follows from another one has no configuration of its own.
        const bool is_its_pair = configuration.from == pair.from && configuration.to == pair.to;
        if (!pair.origin.empty() && !is_its_pair) continue;
        pair.origin = configuration.formula;
        if (!is_its_pair) pair.origin += "; reciprocity or closure";
        pair.reference = configuration.reference;
    }
}

std::optional<std::string> why_not(const Scene& scene, const EstimatorEntry& estimator) {
    std::string refusal = estimator.refusal({}, scene);
    return refusal.empty() ? std::nullopt : std::optional(std::move(refusal));
}

}  // namespace

SceneExplanation explain_scene(const Scene& scene) {
    SceneExplanation explanation;
    const std::size_t faces = scene.faces.size();
    explanation.areas.resize(faces);
    explanation.surfaces.resize(faces);
    explanation.grids.resize(faces);
    const bool with_grids = has_grids(scene);
    for (const Surface& surface : scene.surfaces) {
        if (!is_of_face(surface)) {
            ++explanation.occluders;
            continue;
        }
        explanation.areas[static_cast<std::size_t>(surface.face)] += area(surface.shape);
        ++explanation.surfaces[static_cast<std::size_t>(surface.face)];
        auto& grids = explanation.grids[static_cast<std::size_t>(surface.face)];
        const bool is_new = std::find(grids.begin(), grids.end(), surface.grid) == grids.end();
        if (with_grids && is_new) grids.push_back(surface.grid);
    }
    if (faces <= most_faces) {
        const KnownFactors known = known_factors(scene);
        for (int from = 0; from < static_cast<int>(faces); ++from) {
            for (int to = 0; to < static_cast<int>(faces); ++to) {
                if (from == to || !face_each_other(scene, from, to)) continue;
                const auto factor = known.at(from, to);
                if (!factor) {
                    ++explanation.unknown_pairs;
                    continue;
                }
                ExplainedPair pair{from, to, *factor, {}, {}};
                add_origin(scene, pair);
                explanation.pairs.push_back(std::move(pair));
            }
        }
    }
    for (const EstimatorEntry& estimator : estimators())
        explanation.estimators.push_back({std::string(estimator.info.name), why_not(scene, estimator)});
    return explanation;
}

}  // namespace ff::studies
