#include "stats/mean_difference.hpp"

#include "core/support/contract.hpp"
#include "stats/distributions.hpp"

#include <cmath>

namespace ff::stats {

std::optional<MeanDifference> test_means_welch(const Moments& first, const Moments& second) {
    FF_EXPECT(first.reference() == second.reference());
    if (first.count() < 2 || second.count() < 2) return std::nullopt;
    const double a = *first.variance() / static_cast<double>(first.count());
    const double b = *second.variance() / static_cast<double>(second.count());
    if (a + b == 0) return std::nullopt;
    MeanDifference test;
    test.difference = *second.bias() - *first.bias();
    test.standard_error = std::sqrt(a + b);
    // As shares of the whole: squares of variances of 1e-160 would be 0.
    const double share_a = a / (a + b);
    const double share_b = b / (a + b);
    test.freedom = 1 / (share_a * share_a / static_cast<double>(first.count() - 1) +
                        share_b * share_b / static_cast<double>(second.count() - 1));
    test.p = student_two_sided_p(test.difference / test.standard_error, test.freedom);
    return test;
}

}  // namespace ff::stats
