#include "studies/explain/explain.hpp"

#include "core/configurations/built_in_scene.hpp"
#include "core/configurations/catalogue.hpp"
#include "core/estimators/estimator.hpp"
#include "core/exact/known_factors.hpp"
#include "core/visibility/facing.hpp"
#include "core/visibility/mirrors.hpp"
#include "samplers/sampler.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <utility>
#include <vector>

namespace ff::studies {
namespace {

/// @param info  of an estimator or a sampler
Description description_of(const auto& info) {
    return {info.name, info.summary, info.details, info.reference};
}

std::vector<Description> describe_estimators() {
    std::vector<Description> all;
    for (const EstimatorEntry& estimator : ff::estimators()) all.push_back(description_of(estimator.info));
    return all;
}

constexpr std::array scene_kinds{
    Description{
        "cube", "the inside of the paper's cube, edges of 6",
        "Faces as in the paper: 1 opposite 6, 2 opposite 3, 4 opposite 5; 3 is frontal. The same scene as box:6x6x6.",
        "baranoski1999"},
    Description{"box:AxBxC", "the inside of any box, e.g. box:2x1x0.5",
                "Faces 1 and 6 are A x B at distance C, faces 2 and 3 are A x C at distance B, faces 4 and 5 are B x C "
                "at distance A.",
                "howell"},
    Description{"FILE", "a scene file beside the study file: .obj, .vs3, .toml or a mesh",
                "Wavefront OBJ (groups are faces), View3D, or TOML with every shape; what is in each: docs/scenes.md.\n"
                "Exact values are known of unoccluded rectangles along the axes, and of closed "
                "convex rooms with\n"
                "flat walls or of revolution.",
                ""},
};

constexpr std::array completions{
    Description{"direct", "every row of the matrix of faces from its own samples (the default)",
                "completion = \"direct\". In a closed scene the rows of ray shooting sum to exactly 1.", ""},
    Description{"reciprocal", "F(j, i) with j > i from F(i, j), by reciprocity, as in the paper",
                "completion = \"reciprocal\": F(j, i) = A_i F(i, j) / A_j. Applied to the stored direct estimates, so "
                "that it changes\nno random number. Errors of the first face's row add up in those of the last.",
                "baranoski1999"},
};

constexpr std::array allocations{
    Description{"patch", "every patch has its own sequence of points (the default)",
                "allocation = \"patch\", for ray_shooting and point_to_polygon. The size that counts for a sampler is "
                "samples_per_patch.",
                ""},
    Description{
        "face", "one sequence of points for all patches of a face",
        "allocation = \"face\", for ray_shooting and point_to_polygon: patch p takes points p n to (p + 1) n - 1. "
        "The size that\ncounts for a sampler is patches_per_face times samples_per_patch. Refused for "
        "stratified, of whose points a part is biased.",
        ""},
};

constexpr std::array maps{
    Description{"uniform", "points are laid evenly on both patches (the default)",
                "map = \"uniform\", for area_kernel. Between patches that share an edge or a vertex the variance is "
                "infinite.",
                ""},
    Description{"graded", "points are laid densely where two patches touch, and weighed accordingly",
                "map = \"graded\", for area_kernel: distances s^3 from a common edge, s^2 from a common vertex. The "
                "variance becomes\nfinite (tail index 5/2 at an edge), the fourth moment stays infinite, and the "
                "estimate stays unbiased. No help to\ngauss_legendre.",
                ""},
};

constexpr std::array tracers{
    Description{"automatic", "the analytic tracer where it applies, Embree elsewhere (the default)",
                "tracer = \"automatic\", for ray_shooting.", ""},
    Description{
        "box", "an analytic, vectorised tracer for the inside of an empty box",
        "tracer = \"box\", for ray_shooting. Refused for other scenes. Both tracers shoot the same rays and agree "
        "but for rays that\npass within rounding of an edge.",
        ""},
    Description{"embree", "the general tracer",
                "tracer = \"embree\", for ray_shooting. Robust mode, no epsilon: a ray's own surface is left out by a "
                "mask.",
                "wald2014"},
};

constexpr Description leaky{
    "leaky", "loses the rays that end within 1e-4 of an edge of the surface they hit",
    "tracer = \"leaky\" with estimator = \"ray_shooting\". Rays are traced as usual, but those that end closer to an "
    "edge "
    "than\n1e-4 of the surface's extent are lost, as with meshes that are not watertight or hits that are tested with "
    "an\nepsilon. In a cube one ray in 2000 is lost: less than the noise of most runs.\n"
    "Caught by: a gate on lost rays, and one on closure.",
    ""};

constexpr Description adjacent_kernel{
    "adjacent_kernel", "the area kernel with random points between faces that touch: infinite variance",
    "sampler = \"random\", estimator = \"area_kernel\", on adjacent pairs. The kernel grows without bound where faces "
    "touch:\nthe mean is right, the variance infinite (tail index 3/2), and sample variances and t intervals mean "
    "nothing.\nCaught by: theory, for the program's own runs (the gate is refused), and by the tail index, for "
    "estimates "
    "that\nothers bring.",
    "pederson1997"};

/// Pairs are not examined one by one in scenes with more faces than this.
constexpr std::size_t most_faces = 256;

void add_origin(const Scene& scene, ExplainedPair& pair) {
    if (!known_form_factor(scene, pair.from, pair.to)) {
        pair.origin = "closed form, unoccluded";
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

std::span<const Choices> all_choices() {
    static const std::vector<Description> estimators = describe_estimators();
    static const std::array choices{
        Choices{"estimator", "estimators", estimators},
        Choices{"scene", "scenes", scene_kinds},
        Choices{"completion", "completions", completions},
        Choices{"allocation", "allocations", allocations},
        Choices{"map", "maps", maps},
        Choices{"tracer", "tracers", tracers},
    };
    return choices;
}

std::vector<Control> controls() {
    std::vector<Control> all;
    for (const auto& sampler : samplers::controls()) all.push_back({"sampler", description_of(sampler.info)});
    all.push_back({"tracer", leaky});
    all.push_back({"combination", adjacent_kernel});
    return all;
}

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
        const bool is_new = std::ranges::find(grids, surface.grid) == grids.end();
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
