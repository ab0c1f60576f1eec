#pragma once

#include "core/geometry/scene.hpp"

#include <string>

namespace ff {

/// Why the rays of a scene cannot be traced in single precision, and what to do; empty where they can.
std::string why_not_traceable(const Scene& scene);

}  // namespace ff
