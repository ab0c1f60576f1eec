#include "stats/bias_test.hpp"

#include "core/support/contract.hpp"
#include "stats/distributions.hpp"
#include "stats/mean_interval.hpp"

#include <cmath>

namespace ff::stats {

std::optional<BiasTest> test_bias(const Moments& moments) {
    if (moments.count() < 2 || *moments.variance() == 0) return std::nullopt;
    BiasTest test;
    test.bias = *moments.bias();
    test.standard_error = *moments.standard_error();
    test.t = test.bias / test.standard_error;
    test.freedom = static_cast<double>(moments.count() - 1);
    test.p = student_two_sided_p(test.t, test.freedom);
    return test;
}

std::optional<EquivalenceTest> test_equivalence(const Moments& moments, double margin, double alpha) {
    FF_EXPECT(margin > 0 && 0 < alpha && alpha < 0.5);
    const auto interval = bias_interval_t(moments, 1 - 2 * alpha);
    if (!interval) return std::nullopt;
    EquivalenceTest test;
    test.interval = *interval;
    test.margin = margin;
    test.p = student_tail((margin - std::abs(*moments.bias())) / *moments.standard_error(),
                          static_cast<double>(moments.count() - 1));
    test.equivalent = -margin < interval->low && interval->high < margin;
    test.different = interval->low > margin || interval->high < -margin;
    return test;
}

}  // namespace ff::stats
