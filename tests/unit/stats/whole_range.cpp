// Every function that numbers from files reach, over the whole range that its documentation allows: no exception, no
// NaN, no interval whose ends are exchanged. Contracts are on in tests, so a call outside a domain ends them.

#include "stats/basics/binomial.hpp"
#include "stats/basics/distributions.hpp"
#include "stats/basics/moments.hpp"
#include "stats/dependence/correlation.hpp"
#include "stats/dependence/repeats.hpp"
#include "stats/error_rates/multiplicity.hpp"
#include "stats/error_rates/power.hpp"
#include "stats/goodness_of_fit/anderson_darling.hpp"
#include "stats/means/mean_interval.hpp"
#include "stats/means/mean_test.hpp"
#include "stats/variances/tails.hpp"
#include "stats/variances/variance_interval.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <limits>
#include <optional>
#include <vector>

namespace ff::stats {
namespace {

/// Every run checks the same cases. RC_PARAMS of the caller, e.g. to try other seeds, goes before.
// NOLINTNEXTLINE(concurrency-mt-unsafe): before main
const int fixed_seed = setenv("RC_PARAMS", "seed=20261122 max_success=1000", 0);

/// 10^low ... 10^high, both ends often.
rc::Gen<double> decades(double low, double high) {
    const auto exponent = rc::gen::map(rc::gen::inRange(0, 1'000'001),
                                       [=](int step) { return std::pow(10.0, low + (high - low) * step * 1e-6); });
    return rc::gen::weightedOneOf<double>(
        {{6, exponent}, {1, rc::gen::just(std::pow(10.0, low))}, {1, rc::gen::just(std::pow(10.0, high))}});
}

rc::Gen<double> any_sign(const rc::Gen<double>& sizes) {
    return rc::gen::map(rc::gen::pair(sizes, rc::gen::arbitrary<bool>()),
                        [](const auto& drawn) { return drawn.second ? drawn.first : -drawn.first; });
}

/// Values of files: of very different size, equal ones among them.
rc::Gen<std::vector<double>> files() {
    const auto value = rc::gen::weightedOneOf<double>(
        {{4, any_sign(decades(-75, 75))}, {2, any_sign(decades(-2, 2))}, {1, rc::gen::element(0.0, -0.0, 0.2, 1.0)}});
    return rc::gen::resize(60, rc::gen::container<std::vector<double>>(value));
}

rc::Gen<double> tails() {
    return decades(-14, std::log10(0.4));
}
rc::Gen<double> levels() {
    return rc::gen::map(decades(-14, std::log10(0.49)), [](double tail) { return 1 - tail; });
}
rc::Gen<double> freedoms() {
    return decades(std::log10(0.5), 15);
}

void expect_interval(const Interval& interval) {
    RC_ASSERT(interval.low <= interval.high);
}
void expect_interval(const std::optional<Interval>& interval) {
    if (interval) expect_interval(*interval);
}
void expect_p(double p) {
    RC_ASSERT(p >= 0 && p <= 1);
}

RC_GTEST_PROP(WholeRange, CriticalValuesHaveTheirTail, ()) {
    const double tail = *tails();
    const double freedom = *decades(0, 15);
    const auto holds = [&](double found) { return std::abs(found - tail) <= 1e-5 * tail; };
    RC_ASSERT(holds(normal_tail(normal_critical(tail))));
    RC_ASSERT(holds(student_tail(student_critical(freedom, tail), freedom)));
    RC_ASSERT(holds(chi_squared_tail(chi_squared_critical(freedom, tail), freedom)));
}

RC_GTEST_PROP(WholeRange, FisherQuantilesHaveTheirTail, ()) {
    const double tail = *tails();
    const double above = *freedoms();
    const double below = *freedoms();
    for (const double wanted : {tail, 1 - tail}) {
        const double f = fisher_critical(wanted, above, below);
        RC_ASSERT(f > 0 && std::isfinite(f));
        // Above 1e12 degrees of freedom a tail changes by more than this between neighbouring doubles.
        if (above < 1e10 && below < 1e10 && f > 1e-280 && f < 1e280)
            RC_ASSERT(std::abs(fisher_tail(f, above, below) - wanted) <= 1e-4 * wanted + 1e-6);
    }
}

RC_GTEST_PROP(WholeRange, TailsOfAnythingAreProbabilities, ()) {
    const double x = *any_sign(decades(-308, 308));
    const double freedom = *freedoms();
    for (const double value : {x, std::copysign(std::numeric_limits<double>::infinity(), x), 5e-324}) {
        expect_p(normal_tail(value));
        expect_p(student_tail(value, freedom));
        expect_p(chi_squared_tail(std::abs(value), freedom));
        expect_p(fisher_tail(std::abs(value), freedom, *freedoms()));
    }
}

RC_GTEST_PROP(WholeRange, TailsOfNoncentralChiSquaredAreProbabilities, ()) {
    const double freedom = std::ceil(*decades(0, 7));
    const double lambda = *decades(-20, 17);
    const double mean = freedom + lambda;
    for (const double x : {0.0, *decades(-20, 17), mean, mean + 3 * std::sqrt(2 * mean), 2 * mean, mean / 3}) {
        const double above = noncentral_chi_squared_tail(x, freedom, lambda, true);
        const double below = noncentral_chi_squared_tail(x, freedom, lambda, false);
        expect_p(above);
        expect_p(below);
        RC_ASSERT(std::abs(above + below - 1) <= 1e-8);
    }
}

RC_GTEST_PROP(WholeRange, IntervalsOfSharesAreInOrder, ()) {
    const auto trials = static_cast<std::uint64_t>(*decades(0, 12));
    const auto hits = std::min(trials, static_cast<std::uint64_t>(static_cast<double>(trials) * *decades(-12, 0)));
    const double level = *levels();
    for (const Proportion& counts : {Proportion{hits, trials}, Proportion{0, trials}, Proportion{trials, trials}}) {
        const Interval interval = clopper_pearson_interval(counts, level);
        RC_ASSERT(0 <= interval.low && interval.low <= interval.high && interval.high <= 1);
        expect_interval(wilson_interval(counts, level));
        expect_interval(wald_interval(counts, level));
        expect_p(binomial_upper_p(counts, 0.2));
        expect_p(binomial_lower_p(counts, 0.2));
    }
}

RC_GTEST_PROP(WholeRange, StatisticsOfAnyFileAreNumbers, ()) {
    const std::vector<double> values = *files();
    const double level = *levels();
    const Moments moments = moments_of(values, values.empty() ? 0 : values.front());
    expect_interval(mean_interval_t(moments, level));
    expect_interval(bias_interval_t(moments, level));
    expect_interval(mean_interval_normal(moments, level));
    expect_interval(variance_interval_chi2(moments, level));
    expect_interval(variance_interval(values, level, {.key = {}, .replicates = 19}));
    if (const auto spread = mean_square_of(moments)) {
        RC_ASSERT(spread->freedom > 0 && spread->freedom <= static_cast<double>(values.size()));
        expect_interval(mean_square_interval(*spread, level));
        expect_interval(ratio_interval(*spread, {1, *freedoms(), 10}, level));
    }
    if (const auto repeats = find_repeats(values)) expect_p(repeats->p);
    find_period(values, 1e-6);
    if (const auto test = test_normality(values)) expect_p(test->p);
    for (const double fraction : {0.1, 0.9}) {
        if (const auto tail_fit = fit_tail(values, fraction)) RC_ASSERT(!std::isnan(tail_fit->shape));
    }
    if (const auto tail_fit = fit_tail_hill(values, 2)) RC_ASSERT(!std::isnan(tail_fit->shape));
}

RC_GTEST_PROP(WholeRange, SeriesThatSpreadHaveReachAndCorrelation, ()) {
    const std::vector<double> values = *files();
    const Moments moments = moments_of(values, values.empty() ? 0 : values.front());
    RC_PRE((values.size() >= 3 && *moments.standard_deviation() > 1e-75));
    const auto correlation = autocorrelation_of(values);
    RC_ASSERT(correlation.time >= 1 && correlation.freedom > 0);
    if (const auto test = test_serial_correlation(values)) expect_p(test->p);
    for (const auto& mean :
         {mean_evidence(values, values.front()), mean_evidence(values, values.front(), {}, correlation)}) {
        if (!mean) continue;
        expect_p(test_mean(*mean).p);
        const Interval interval = interval_of(*mean, *levels());
        RC_ASSERT(interval.low < mean->difference && mean->difference < interval.high);
    }
}

RC_GTEST_PROP(WholeRange, TwoFilesAreCompared, ()) {
    const std::vector<double> a = *files();
    const std::vector<double> b = *files();
    if (const auto mean = difference_of_means(a, b)) expect_p(test_mean(*mean).p);
}

RC_GTEST_PROP(WholeRange, PowersAreProbabilities, ()) {
    const double alpha = *tails();
    const auto trials = static_cast<std::size_t>(*decades(std::log10(5.0), 9));
    const double sigma = *decades(-75, 75);
    const Risks risks{alpha, std::max(0.5, 1 - *decades(-9, -1))};
    RC_ASSERT(minimum_detectable_bias(sigma, trials, risks) > 0);
    RC_ASSERT(equivalence_margin(sigma, trials, risks, 30) > 0);
}

RC_GTEST_PROP(WholeRange, AdjustedProbabilitiesAreProbabilities, ()) {
    const auto p =
        *rc::gen::container<std::vector<double>>(rc::gen::oneOf(decades(-300, 0), rc::gen::element(0.0, 1.0, 5e-324)));
    for (const auto& adjusted : {holm(p), sidak(p)}) {
        for (const double value : adjusted) expect_p(value);
    }
}

}  // namespace
}  // namespace ff::stats
