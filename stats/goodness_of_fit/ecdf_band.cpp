#include "stats/goodness_of_fit/ecdf_band.hpp"

#include "core/support/contract.hpp"

#include <cmath>

namespace ff::stats {

double dkw_half_width(std::size_t n, double level) {
    FF_EXPECT(n >= 1 && 0 < level && level < 1);
    return std::sqrt(std::log(2 / (1 - level)) / (2 * static_cast<double>(n)));
}

}  // namespace ff::stats
