#include "tests/validation/rates/measured_rate.hpp"

#include <algorithm>
#include <limits>

namespace ff::studies {

stats::Interval interval_of(const MeasuredRate& rate, double level) {
    return stats::clopper_pearson_interval(rate.counts, level);
}

double tail_of(const MeasuredRate& rate) {
    switch (rate.claim) {
        case RateClaim::equal:
            return std::min(stats::binomial_upper_p(rate.counts, rate.claimed),
                            stats::binomial_lower_p(rate.counts, rate.claimed));
        case RateClaim::at_most:
            return stats::binomial_upper_p(rate.counts, rate.claimed);
        case RateClaim::at_least:
            return stats::binomial_lower_p(rate.counts, rate.claimed);
        case RateClaim::none:
            break;
    }
    return std::numeric_limits<double>::infinity();
}

bool holds(const MeasuredRate& rate, double level) {
    return tail_of(rate) >= (1 - level) / 2;
}

std::size_t RateTable::claims() const {
    return static_cast<std::size_t>(
        std::ranges::count_if(rates, [](const MeasuredRate& rate) { return rate.claim != RateClaim::none; }));
}

std::size_t RateTable::contradictions(double level) const {
    return static_cast<std::size_t>(
        std::ranges::count_if(rates, [&](const MeasuredRate& rate) { return !holds(rate, level); }));
}

}  // namespace ff::studies
