#pragma once

#include "studies/audit/printed_number.hpp"

namespace ff::test {

/// Rounded to six significant digits.
inline constexpr studies::NumberFormat rounded_digits{studies::Rounding::rounded, studies::Layout::significant_digits,
                                                      6};

}  // namespace ff::test
