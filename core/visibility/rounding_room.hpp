#pragma once

namespace ff {

/// Allowance for rounding, relative to what is compared: a patch, a surface or a pair of surfaces. Gaps below this
/// share of its size count as none, and so do angles below it.
inline constexpr double rounding_room = 1e-12;

}  // namespace ff
