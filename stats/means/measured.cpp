#include "stats/means/measured.hpp"

#include "core/support/contract.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace ff::stats {
namespace {

double reach_of(const Measured::Part& part, int side, double tail) {
    const int of_mean = part.weight < 0 ? -side : side;
    const MeanEvidence& mean = part.mean;
    // Values that no evaluation has met can only increase a mean square.
    const double reach =
        mean.reach_of_met(of_mean, tail) + (of_mean > 0 ? mean.unmet.reach(mean.unmet.tail_of_unmet(tail)) : 0);
    const double weight = std::abs(part.weight);
    return weight * (part.logarithm ? gate::reach_of_logarithm(of_mean, reach / mean.difference) : reach);
}

/// Both reaches, added as the sides of a right triangle.
double reach_of_difference(const Measured& first, const Measured& second, int side, double tail, double correlation) {
    const double a = second.reach(side, tail);
    const double b = first.reach(-side, tail);
    if (std::isinf(a) || std::isinf(b)) return std::numeric_limits<double>::infinity();
    return std::sqrt(std::max(0.0, a * a + b * b - 2 * correlation * a * b));
}

std::size_t fewest(const Measured& first, const Measured& second) {
    std::size_t fewest = std::numeric_limits<std::size_t>::max();
    for (const Measured* each : {&first, &second}) {
        for (const Measured::Part& part : each->parts) fewest = std::min(fewest, part.mean.n);
    }
    return fewest;
}

}  // namespace

double Measured::reach(int side, double tail) const {
    double squares = 0;
    for (const Part& part : parts) {
        const double reach = reach_of(part, side, tail);
        squares += reach * reach;
    }
    return std::sqrt(squares);
}

Measured logarithm_of(const MeanEvidence& mean, double scale) {
    FF_EXPECT(mean.difference > 0 && scale > 0);
    return {std::log(scale * mean.difference), {{.mean = mean, .logarithm = true}}};
}

Measured with_error(double value, double standard_error, std::size_t trials) {
    FF_EXPECT(standard_error >= 0 && trials > 1);
    return {value,
            {{.mean = {.standard_error = standard_error,
                       .freedom = static_cast<double>(trials - 1),
                       .skewness = {.most = no_part},
                       .method = {},
                       .n = trials}}}};
}

std::optional<Interval> difference_interval(const Measured& first, const Measured& second, double level,
                                            double correlation) {
    if (first.is_exact() && second.is_exact()) return std::nullopt;
    const double difference = second.value - first.value;
    const double tail = (1 - level) / 2;
    return Interval{.low = difference - reach_of_difference(first, second, -1, tail, correlation),
                    .high = difference + reach_of_difference(first, second, 1, tail, correlation),
                    .level = level,
                    .method = "square_and_add",
                    .n = fewest(first, second)};
}

double p_of_equal(const Measured& first, const Measured& second) {
    const double difference = second.value - first.value;
    if (first.is_exact() && second.is_exact()) return difference == 0 ? 1 : 0;
    return two_sided_p([&](double tail) {
        return std::abs(difference) > reach_of_difference(first, second, difference > 0 ? -1 : 1, tail, 0);
    });
}

}  // namespace ff::stats
