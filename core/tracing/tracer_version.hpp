#pragma once

#include <string>

namespace ff {

/// The Embree that this process has loaded, e.g. "Embree 4.3.3".
std::string tracer_version();

}  // namespace ff
