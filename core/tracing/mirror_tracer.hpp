#pragma once

#include "core/tracing/tracer.hpp"

#include <memory>

namespace ff {

/// A ray that has been reflected so often and meets a mirror again is lost. In a box no two of whose mirrors are
/// opposite none is reflected more than three times.
inline constexpr int most_reflections = 64;

/// Lets rays that meet the front of a mirror go on, reflected, from the place where they met it; `tracer` finds what
/// they meet. Hits are the last ones, none of them on a mirror. @pre a tracer of the same scene
std::unique_ptr<Tracer> make_mirror_tracer(const Scene& scene, std::unique_ptr<Tracer> tracer);

}  // namespace ff
