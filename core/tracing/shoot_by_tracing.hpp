#pragma once

#include "core/geometry/scene.hpp"
#include "core/tracing/tracer.hpp"

namespace ff {

/// `Tracer::shoot` in terms of `trace`, for tracers that trace rays one by one.
/// @param scene  that the tracer was made for
void shoot_by_tracing(const Tracer& tracer, const Scene& scene, std::uint32_t source, Grid grid, std::uint32_t patch,
                      const PointBlock& block, std::span<std::uint64_t> hits);

}  // namespace ff
