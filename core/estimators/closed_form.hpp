#pragma once

#include "core/estimators/estimator.hpp"
#include "core/exact/exact.hpp"
#include "core/support/contract.hpp"
#include "core/visibility/mirrors.hpp"

#include <fmt/format.h>

#include <string>

namespace ff {

/// Exact factors (core/exact/exact.hpp), as an estimator: the reference beside the others.
class ClosedForm {
  public:
    static constexpr EstimatorInfo info{
        .name = "closed_form",
        .summary = "exact formulas for parallel and perpendicular rectangles",
        .details =
            "Takes no points and has no error but rounding (about 1e-15 of the squared extent). Axis-aligned "
            "rectangles with\nnothing in between. The reference that bias is measured from, and the baseline that "
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

    ClosedForm(const Scene& scene, TracerChoice /*tracer*/) : scene_(&scene) {}

    void observe(const EstimatorTask& /*task*/, Outcome& outcome, PatchTotals& /*totals*/) const {
        const auto factors = exact_form_factors(*scene_);
        FF_EXPECT(factors);
        outcome.estimates = *factors;
    }

  private:
    const Scene* scene_;
};

}  // namespace ff
