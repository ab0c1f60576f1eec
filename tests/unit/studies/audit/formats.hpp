#pragma once

#include "studies/audit/printed_number.hpp"

namespace ff::test {

/// Rounded to six significant digits.
inline constexpr studies::audit::NumberFormat rounded_digits{studies::audit::Rounding::rounded,
                                                             studies::audit::Layout::significant_digits, 6};

}  // namespace ff::test
