#pragma once

#include <cstddef>

namespace ff::stats {

/// Half-width of the Dvoretzky-Kiefer-Wolfowitz band around an ECDF of n values: sqrt(ln(2/(1-level)) / (2n)).
/// Coverage >= level for every distribution, discrete ones included. @see [massart1990]
double dkw_half_width(std::size_t n, double level);

}  // namespace ff::stats
