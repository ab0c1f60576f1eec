#pragma once

#include "core/tracing/tracer.hpp"

#include <memory>

namespace ff {

/// Width of the crack along each edge of a surface, as a share of the surface's extent.
inline constexpr float crack_width = 1e-4f;

/// Control: a tracer that is broken on purpose. Rays are traced as by `make_tracer`, but those that end within
/// `crack_width` of an edge of the surface they hit slip through and are lost, as with meshes that are not watertight
/// or hits that are tested with an epsilon. In a closed cube about one ray in 2000 is lost.
std::unique_ptr<Tracer> make_leaky_tracer(const Scene& scene);

}  // namespace ff
