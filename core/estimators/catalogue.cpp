#include "core/estimators/added.hpp"
#include "core/estimators/entry.hpp"
#include "core/estimators/pairs/area_kernel.hpp"
#include "core/estimators/pairs/contour.hpp"
#include "core/estimators/pairs/control_variate.hpp"
#include "core/estimators/pairs/rays_and_kernel.hpp"
#include "core/estimators/pairs/solid_angle.hpp"
#include "core/estimators/points/point_to_polygon.hpp"
#include "core/estimators/rays/global_lines.hpp"
#include "core/estimators/rays/projections.hpp"
#include "core/estimators/rays/ray_shooting.hpp"
#include "core/exact/exact.hpp"
#include "core/support/contract.hpp"
#include "core/support/error.hpp"
#include "core/support/excerpt.hpp"
#include "core/support/nearest_name.hpp"
#include "core/visibility/mirrors.hpp"
#include "core/visibility/occlusion.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string>
#include <string_view>
#include <vector>

namespace ff {
namespace {

/// Exact factors (core/exact/exact.hpp), as an estimator: the reference beside the others.
class ClosedForm : public SceneEstimator {
  public:
    static constexpr EstimatorInfo info{
        .name = "closed_form",
        .summary = "exact formulas for parallel and perpendicular rectangles",
        .details =
            "Takes no points and has no error but rounding (about 1e-15 of the squared extent). Axis-aligned "
            "rectangles,\nunoccluded. The reference that bias is measured from, and the baseline that "
            "others have to beat.",
        .reference = "howell",
        .exact = true,
        .sees_reflections = true,
        .nanoseconds = 1e6,
    };

    static std::string refusal(const EstimatorOptions& /*options*/, const Scene& scene) {
        if (exact_form_factors(scene)) return {};
        return fmt::format(
            "scene '{}' has no closed form (there is one for rectangles along the axes{}). Use another estimator.",
            scene.name, mirrors(scene).empty() ? "" : ", and in mirrors of boxes that are not opposite");
    }

    using SceneEstimator::SceneEstimator;

    void observe(const EstimatorTask& /*task*/, Outcome& outcome, PatchTotals& /*totals*/) const {
        const auto factors = exact_form_factors(scene());
        FF_EXPECT(factors);
        outcome.estimates = *factors;
    }
};

bool has_polygonal_faces(const Scene& scene) {
    return std::all_of(scene.surfaces.begin(), scene.surfaces.end(),
                       [](const Surface& surface) { return !is_of_face(surface) || is_polygon(surface.shape); });
}

}  // namespace

std::span<const EstimatorEntry> estimators() {
    // The only list of estimators.
    static const std::array all{
        estimator_entry<RayShooting>(),            //
        estimator_entry<GlobalLines>(),            //
        estimator_entry<AreaKernel>(),             //
        estimator_entry<PointToPolygon>(),         //
        estimator_entry<PointToVisiblePolygon>(),  //
        estimator_entry<SolidAngle>(),             //
        estimator_entry<RaysAndKernel>(),          //
        estimator_entry<RaysAndKernelPower>(),     //
        estimator_entry<ControlVariate>(),         //
        estimator_entry<Contour>(),                //
        estimator_entry<AdaptiveContour>(),        //
        estimator_entry<Hemicube>(),               //
        estimator_entry<CubicTetrahedron>(),       //
        estimator_entry<SinglePlane>(),            //
        estimator_entry<ClosedForm>(),             //
    };
    return all;
}

const EstimatorEntry& find_estimator(std::string_view name) {
    for (const EstimatorEntry& estimator : estimators()) {
        if (estimator.info.name == name) return estimator;
    }
    if (const auto* const added = find_added_estimator(name)) return added->entry();
    std::vector<std::string_view> names;
    for (const EstimatorEntry& estimator : estimators()) names.push_back(estimator.info.name);
    throw UserError("estimator \"{}\" (there is none of this name). {}Known estimators: {}.", excerpt(name),
                    did_you_mean(name, names, '"'), fmt::join(names, ", "));
}

std::string refusal_of(const EstimatorInfo& info, const Scene& scene) {
    if (!info.sees_reflections && !mirrors(scene).empty()) {
        return fmt::format(
            "{} cannot be used in scene '{}' with mirrors (it sees nothing by way of them). Use estimator = "
            "\"ray_shooting\", or leave 'mirrors' out.",
            info.name, scene.name);
    }
    if (!info.sees_occluders && may_be_occluded(scene))
        return refused(info, scene,
                       "two of its faces may be occluded from each other, and the estimator does not see occluders");
    if (info.needs_polygons && !has_polygonal_faces(scene))
        return refused(info, scene, "not all of its faces are parallelograms and triangles");
    return {};
}

std::string refused(const EstimatorInfo& info, const Scene& scene, std::string_view why, std::string_view instead) {
    return fmt::format("{} cannot be used in scene '{}' ({}). Use estimator = {}.", info.name, scene.name, why,
                       instead);
}

}  // namespace ff
