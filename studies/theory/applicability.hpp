#pragma once

#include "core/geometry/scene.hpp"
#include "studies/spec/spec.hpp"

namespace ff::studies {

/// Whether a method can do a scene.
/// @throws UserError with the reason that its estimator gives
void expect_applicable(const Method& method, const Scene& scene);

}  // namespace ff::studies
