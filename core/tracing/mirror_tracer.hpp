#pragma once

#include "core/tracing/tracer.hpp"

#include <memory>

namespace ff {

/// A ray that meets a mirror after this many reflections is lost. In a box without opposite mirrors no ray is reflected
/// more than three times.
inline constexpr int most_reflections = 64;

/// Reflects rays that meet the front of a mirror; `tracer` finds what they meet. Only final hits are reported, none of
/// them on a mirror. @pre a tracer of the same scene
std::unique_ptr<Tracer> make_mirror_tracer(const Scene& scene, std::unique_ptr<Tracer> tracer);

}  // namespace ff
