#include "stats/basics/binomial.hpp"

#include "core/support/contract.hpp"
#include "stats/basics/distributions.hpp"

#include <boost/math/distributions/binomial.hpp>

#include <algorithm>
#include <cmath>
#include <exception>

namespace ff::stats {
namespace {

using Binomial = boost::math::binomial;

void expect_valid_counts(Proportion counts) {
    FF_EXPECT(counts.trials >= 1 && counts.hits <= counts.trials);
}

Interval interval(double low, double high, double level, const char* method, Proportion counts) {
    return {.low = low, .high = high, .level = level, .method = method, .n = counts.trials};
}

/// @param p_of  falls from above `tail` at `from` to below it at `to`
template <class F>
double bisect(double from, double to, double tail, const F& p_of) {
    while (true) {
        const double middle = from + (to - from) / 2;
        if (middle == from || middle == to) return to;
        (p_of(middle) > tail ? from : to) = middle;
    }
}

// Boost's iterations give up on some counts from 1e12 on.

double lower_bound(Proportion counts, double tail) {
    if (counts.hits == 0) return 0;
    try {
        return Binomial::find_lower_bound_on_p(static_cast<double>(counts.trials), static_cast<double>(counts.hits),
                                               tail, Binomial::clopper_pearson_exact_interval);
    } catch (const std::exception&) {
        return bisect(counts.share(), 0, tail, [&](double p) { return binomial_upper_p(counts, p); });
    }
}

double upper_bound(Proportion counts, double tail) {
    if (counts.hits == counts.trials) return 1;
    try {
        return Binomial::find_upper_bound_on_p(static_cast<double>(counts.trials), static_cast<double>(counts.hits),
                                               tail, Binomial::clopper_pearson_exact_interval);
    } catch (const std::exception&) {
        return bisect(counts.share(), 1, tail, [&](double p) { return binomial_lower_p(counts, p); });
    }
}

}  // namespace

Interval clopper_pearson_interval(Proportion counts, double level) {
    expect_valid_counts(counts);
    FF_EXPECT(0 < level && level < 1);
    const double tail = (1 - level) / 2;
    const double low = lower_bound(counts, tail);
    const double high = upper_bound(counts, tail);
    return interval(low, high, level, "clopper_pearson", counts);
}

Interval wilson_interval(Proportion counts, double level) {
    expect_valid_counts(counts);
    const double n = static_cast<double>(counts.trials);
    const double p = counts.share();
    const double z = normal_critical((1 - level) / 2);
    const double spread = z * z / n;
    const double centre = (p + spread / 2) / (1 + spread);
    const double half = std::sqrt((p * (1 - p) + spread / 4) * spread) / (1 + spread);
    // Exact at the ends, where rounding would leave a bound of 1e-19 or 1 - 1e-16.
    const double low = counts.hits == 0 ? 0 : centre - half;
    const double high = counts.hits == counts.trials ? 1 : centre + half;
    return interval(low, high, level, "wilson", counts);
}

Interval wald_interval(Proportion counts, double level) {
    expect_valid_counts(counts);
    const double p = counts.share();
    const double half = normal_critical((1 - level) / 2) * std::sqrt(p * (1 - p) / static_cast<double>(counts.trials));
    return interval_around(p, half, level, "wald", counts.trials);
}

double binomial_upper_p(Proportion counts, double probability) {
    expect_valid_counts(counts);
    FF_EXPECT(0 <= probability && probability <= 1);
    if (counts.hits == 0) return 1;
    const Binomial law(static_cast<double>(counts.trials), probability);
    return cdf(complement(law, static_cast<double>(counts.hits - 1)));
}

double binomial_lower_p(Proportion counts, double probability) {
    expect_valid_counts(counts);
    FF_EXPECT(0 <= probability && probability <= 1);
    const Binomial law(static_cast<double>(counts.trials), probability);
    return cdf(law, static_cast<double>(counts.hits));
}

double binomial_two_sided_p(Proportion counts, double probability) {
    expect_valid_counts(counts);
    FF_EXPECT(0 <= probability && probability <= 1);
    if (probability == 0 || probability == 1) return counts.share() == probability ? 1 : 0;

    const Binomial law(static_cast<double>(counts.trials), probability);
    const auto likelihood = [&law](std::uint64_t hits) { return pdf(law, static_cast<double>(hits)); };
    // Outcomes that are equally likely up to rounding count as equally likely, as in R and SciPy.
    const double seen = likelihood(counts.hits) * (1 + 1e-7);
    const auto mode =
        std::min(static_cast<std::uint64_t>((static_cast<double>(counts.trials) + 1) * probability), counts.trials);

    if (likelihood(mode) <= seen) return 1;
    // On the far side of the mode likelihood is monotone: bisect for the first outcome that is no more likely.
    if (counts.hits < mode) {
        std::uint64_t likely = mode;
        std::uint64_t end = counts.trials + 1;
        while (end - likely > 1) {
            const std::uint64_t middle = likely + (end - likely) / 2;
            (likelihood(middle) > seen ? likely : end) = middle;
        }
        const double far = end > counts.trials ? 0 : binomial_upper_p({end, counts.trials}, probability);
        return std::min(1.0, binomial_lower_p(counts, probability) + far);
    }
    if (likelihood(0) > seen) return binomial_upper_p(counts, probability);
    std::uint64_t unlikely = 0;
    std::uint64_t likely = mode;
    while (likely - unlikely > 1) {
        const std::uint64_t middle = unlikely + (likely - unlikely) / 2;
        (likelihood(middle) > seen ? likely : unlikely) = middle;
    }
    return std::min(1.0,
                    binomial_upper_p(counts, probability) + binomial_lower_p({unlikely, counts.trials}, probability));
}

}  // namespace ff::stats
