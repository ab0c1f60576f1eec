#include "stats/basics/interval.hpp"

#include "core/support/contract.hpp"

#include <cmath>

namespace ff::stats {

Interval square_root(const Interval& interval) {
    FF_EXPECT(interval.low >= 0);
    Interval root = interval;
    root.low = std::sqrt(interval.low);
    root.high = std::sqrt(interval.high);
    return root;
}

}  // namespace ff::stats
