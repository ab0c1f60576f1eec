#include "tests/validation/rates/measured_rate.hpp"

namespace ff::studies {

stats::Interval interval_of(const MeasuredRate& rate, double level) {
    return stats::clopper_pearson_interval(rate.counts, level);
}

bool holds(const MeasuredRate& rate, double level) {
    const stats::Interval interval = interval_of(rate, level);
    switch (rate.claim) {
        case RateClaim::equal:
            return interval.contains(rate.claimed);
        case RateClaim::at_most:
            return interval.low <= rate.claimed;
        case RateClaim::at_least:
            return interval.high >= rate.claimed;
        case RateClaim::none:
            break;
    }
    return true;
}

}  // namespace ff::studies
