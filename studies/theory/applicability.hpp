#pragma once

#include "core/geometry/scene.hpp"
#include "studies/spec/spec.hpp"

namespace ff::studies {

/// Whether a method can do a scene.
/// @throws UserError for the box tracer outside an empty box, for rays in a box that single precision cannot resolve,
///         and where an estimator that sees nothing in between would be used in a scene that is not convex
void expect_applicable(const Method& method, const Scene& scene);

}  // namespace ff::studies
