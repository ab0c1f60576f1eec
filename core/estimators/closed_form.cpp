#include "core/estimators/closed_form.hpp"

#include "core/exact/exact.hpp"
#include "core/support/contract.hpp"
#include "core/visibility/mirrors.hpp"

#include <fmt/format.h>

namespace ff {

std::string ClosedForm::refusal(const EstimatorOptions& /*options*/, const Scene& scene) {
    if (exact_form_factors(scene)) return {};
    return fmt::format(
        "scene '{}' has no closed form (there is one for rectangles along the axes{}). Use another estimator.",
        scene.name, mirrors(scene).empty() ? "" : ", and in mirrors of boxes that are not opposite");
}

void ClosedForm::observe(const EstimatorTask& /*task*/, Outcome& outcome, PatchTotals& /*totals*/) const {
    const auto factors = exact_form_factors(*scene_);
    FF_EXPECT(factors);
    outcome.estimates = *factors;
}

}  // namespace ff
