#pragma once

/// For headers that only pass scenes on.

namespace ff {

struct Parallelogram;
struct Surface;
struct Scene;

}  // namespace ff
