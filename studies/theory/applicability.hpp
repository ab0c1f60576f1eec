#pragma once

#include "core/geometry/scene.hpp"
#include "studies/spec/spec.hpp"

namespace ff::studies {

/// Checks that a method can be used in a scene.
/// @throws UserError with the reason that its estimator gives
void expect_applicable(const Method& method, const Scene& scene);

}  // namespace ff::studies
