#pragma once

#include "core/geometry/fwd.hpp"

#include <rapidcheck.h>

#include <utility>

namespace ff::test {

/// Any rectangle along the axes, in any of the six orientations. Coordinates are multiples of 1/16, so that pairs with
/// common planes, edges and corners come up often.
rc::Gen<Surface> any_rectangle();

/// Two rectangles along the axes of edges up to 1 that are at least 1 apart, where the kernel is smooth.
rc::Gen<std::pair<Surface, Surface>> any_distant_pair();

/// A box with edges from 1/64 to 64.
rc::Gen<Scene> any_box();

}  // namespace ff::test
