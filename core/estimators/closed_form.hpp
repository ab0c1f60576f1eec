#pragma once

#include "core/estimators/estimator.hpp"

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

    static std::string refusal(const EstimatorOptions& options, const Scene& scene);

    ClosedForm(const Scene& scene, TracerChoice /*tracer*/) : scene_(&scene) {}
    void observe(const EstimatorTask& task, Outcome& outcome, PatchTotals& totals) const;

  private:
    const Scene* scene_;
};

}  // namespace ff
