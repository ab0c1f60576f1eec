#include "studies/form_factors/sampled_share.hpp"

#include "stats/binomial.hpp"
#include "stats/mean_interval.hpp"
#include "stats/moments.hpp"

#include <algorithm>
#include <cmath>

namespace ff::studies {
namespace {

/// Of fewer, counts are too skewed for means of 16 to be nearly normal.
constexpr std::uint64_t few = 100;

/// Student's half width; 0 for equal means.
double student_half_width(const std::vector<double>& means, double level) {
    const auto interval = stats::mean_interval_t(stats::moments_of(means), level);
    return interval ? interval->width() / 2 : 0;
}

/// What a rare share may be off by: down and up.
Estimate rare_widths(const SampledShare& share, double level) {
    const double mean = *stats::moments_of(share.means).mean();
    const double student = student_half_width(share.means, level);
    const bool nearly_all = share.hits && share.points - share.met < few;
    if (share.met < few || nearly_all) {
        const auto met = stats::clopper_pearson_interval({.hits = share.met, .trials = share.points}, level);
        // A point that meets something counts for 1 at most; one that has met less may not have met the most.
        const double low = share.hits ? met.low : 0;
        return {mean, std::max(student, mean - low), std::max(student, met.high - mean)};
    }
    // All means equal: what some unseen points may add, and no less than what one randomisation resolves.
    const double unseen = stats::clopper_pearson_interval({.hits = 0, .trials = share.points}, level).high;
    const double resolved = static_cast<double>(share.means.size()) / static_cast<double>(share.points);
    const double width = share.hits ? std::max(unseen, resolved) : unseen;
    return {mean, width, width};
}

}  // namespace

bool is_rare(const SampledShare& share) {
    const stats::Moments moments = stats::moments_of(share.means);
    // Means of equal values differ by rounding.
    const bool all_equal = *moments.standard_deviation() <= 1e-14 * *moments.mean();
    return share.met < few || (share.hits && share.points - share.met < few) || all_equal;
}

Estimate estimate_of(const SampledSum& sum, double level) {
    Estimate result{sum.offset, 0, 0};
    std::vector<double> sums(sum.terms.empty() ? 0 : sum.terms.front().share.means.size(), 0.0);
    bool any_common = false;
    for (const auto& [scale, share] : sum.terms) {
        result.value += scale * *stats::moments_of(share.means).mean();
        if (is_rare(share)) {
            const Estimate rare = rare_widths(share, level);
            result.down += std::abs(scale) * (scale > 0 ? rare.down : rare.up);
            result.up += std::abs(scale) * (scale > 0 ? rare.up : rare.down);
            continue;
        }
        any_common = true;
        for (std::size_t r = 0; r < sums.size(); ++r) sums[r] += scale * share.means[r];
    }
    if (!any_common) return result;
    const double student = student_half_width(sums, level);
    result.down += student;
    result.up += student;
    return result;
}

}  // namespace ff::studies
