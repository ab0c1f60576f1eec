#include "studies/form_factors/sampled_share.hpp"

#include "stats/basics/moments.hpp"
#include "stats/means/mean_interval.hpp"

#include <algorithm>
#include <cmath>

namespace ff::studies::form_factors {
namespace {

/// Student's half width; 0 for equal means.
double student_half_width(const std::vector<double>& means, double level) {
    const auto interval = stats::mean_interval_t(stats::moments_of(means), level);
    return interval ? interval->width() / 2 : 0;
}

}  // namespace

double none_of(std::uint64_t points, double level) {
    return -std::expm1(std::log((1 - level) / 2) / static_cast<double>(points));
}

double UnmetBound::at(double p) const {
    return std::max(rough * p, smooth * std::pow(p, power));
}

double unmet_of(double scale, const SampledShare& share, double level) {
    return std::abs(scale) * share.unmet.at(none_of(share.points, level));
}

EstimatedSum with_means(EstimatedSum known, const std::vector<double>& means, double unmet, double level) {
    known.unmet = unmet;
    known.value += *stats::moments_of(means).mean();
    const double width = student_half_width(means, level) + unmet;
    known.down += width;
    known.up += width;
    return known;
}

EstimatedSum estimate_of(const SampledSum& sum, double level) {
    const EstimatedSum known{sum.offset, sum.offset_error, sum.offset_error, 0};
    if (sum.terms.empty()) return known;
    std::vector<double> sums(sum.terms.front().share.means.size(), 0.0);
    double unmet = 0;
    for (const auto& [scale, share] : sum.terms) {
        for (std::size_t r = 0; r < sums.size(); ++r) sums[r] += scale * share.means[r];
        // The points of all terms together share the few that a set of places may be entitled to and get none of.
        unmet = std::max(unmet, unmet_of(scale, share, level));
    }
    return with_means(known, sums, unmet, level);
}

}  // namespace ff::studies::form_factors
