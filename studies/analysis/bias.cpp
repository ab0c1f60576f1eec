#include "studies/analysis/bias.hpp"

#include "core/points/stream.hpp"
#include "samplers/sampler.hpp"
#include "stats/basics/binomial.hpp"
#include "stats/basics/moments.hpp"
#include "stats/basics/resampling.hpp"
#include "stats/error_rates/multiplicity.hpp"
#include "stats/error_rates/power.hpp"
#include "stats/means/mean_test.hpp"
#include "stats/variances/tails.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>
#include <utility>

namespace ff::studies {
namespace {

/// Cells whose bias is tested; at least 1.
std::size_t sampled_cells(const StudyPlan& plan) {
    const auto sampled = std::ranges::count(plan.cells, false, &Cell::deterministic);
    return static_cast<std::size_t>(std::max<std::ptrdiff_t>(1, sampled));
}

/// The test of one pair.
struct PairTest {
    double t = 0;
    stats::MeanTest test;
    bool bounded = false;                     ///< the tails are known to end
    std::optional<stats::MeanEvidence> mean;  ///< empty for binomial hits, which are counted
    stats::Interval equivalence;              ///< interval of the bias, level 1 - 2 alpha
    stats::Interval strict;                   ///< interval of the bias, level 1 - pair_alpha
};

/// How a cell's pairs are tested.
struct PairTester {
    const StudyPlan& plan;
    const CellEstimates& estimates;
    double alpha;       ///< level of an equivalence test
    double pair_alpha;  ///< level of the test of one pair in its family

    [[nodiscard]] const Cell& cell() const { return plan.cells[estimates.cell]; }
    [[nodiscard]] const Method& method() const { return plan.spec.methods[cell().method]; }

    /// Whether values that jump may make the difference where no evaluation has been.
    [[nodiscard]] bool may_be_unmet(const Summary& summary) const {
        return std::abs(*summary.bias) <= known_limits(plan, estimates, summary.quantity).unmet.reach(pair_alpha / 2);
    }

    /// Empty where nothing can be tested.
    [[nodiscard]] std::optional<PairTest> test(const Summary& summary) const {
        if (!summary.reference || summary.not_finite > 0) return std::nullopt;
        const auto& values = estimates.values(summary.quantity);
        if (counts_hits(plan, estimates, summary.quantity, summary.variance)) {
            const auto hits = binomial_hits(values, *estimates.lattice(summary.quantity));
            if (hits) return test_hits(summary, *hits);
        }
        if (summary.variance != VarianceStatus::finite) return std::nullopt;
        stats::KnownLimits limits = known_limits(plan, estimates, summary.quantity);
        limits.rounding = rounding_of_bias(plan.scenes[cell().scene], summary.quantity);
        const auto pilot =
            plan.spec.until ? std::optional<std::size_t>(plan.spec.until->pilot) : std::optional<std::size_t>();
        const auto mean = mean_of_trials(values, *summary.reference, pilot, limits);
        if (!mean) return std::nullopt;
        return PairTest{.t = mean->t(),
                        .test = stats::test_mean(*mean),
                        .bounded = std::isfinite(limits.largest_part),
                        .mean = mean,
                        .equivalence = stats::interval_of(*mean, 1 - 2 * alpha),
                        .strict = stats::interval_of(*mean, 1 - pair_alpha)};
    }

  private:
    [[nodiscard]] std::optional<PairTest> test_hits(const Summary& summary, const stats::Proportion& counts) const {
        const double truth = *summary.reference;
        if (truth <= 0 || truth >= 1) return std::nullopt;
        const double p = stats::binomial_two_sided_p(counts, truth);
        const auto of_bias = [&](double level) {
            return stats::clopper_pearson_interval(counts, level).shifted(-truth);
        };
        return PairTest{.t = *summary.bias / std::sqrt(truth * (1 - truth) / static_cast<double>(counts.trials)),
                        .test = {.p = p, .student_p = p},
                        .bounded = true,
                        .mean = {},
                        .equivalence = of_bias(1 - 2 * alpha),
                        .strict = of_bias(1 - pair_alpha)};
    }
};

/// No statement is made about a mean whose trials may have no variance.
void withdraw(PairTest& found) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    found.test.p = 1;
    for (stats::Interval* interval : {&found.equivalence, &found.strict})
        std::tie(interval->low, interval->high) = std::pair(-infinity, infinity);
}

/// Withdraws statements about pairs whose tails are in doubt, by their own trials or by those of all pairs together.
/// @return whether there are any
bool withdraw_heavy_tails(const CellEstimates& estimates, std::span<const Quantity> pairs,
                          std::vector<std::optional<PairTest>>& tests) {
    stats::PooledTails pooled;
    for (std::size_t i = 0; i < pairs.size(); ++i) {
        if (tests[i] && !tests[i]->bounded) pooled.add(estimates.values(pairs[i]));
    }
    const bool all = pooled.doubt().has_value();
    bool some = false;
    for (std::size_t i = 0; i < pairs.size(); ++i) {
        if (!tests[i] || tests[i]->bounded || !(all || stats::doubt_tails(estimates.values(pairs[i])))) continue;
        withdraw(*tests[i]);
        some = true;
    }
    return some;
}

/// Withdraws statements about pairs whose t is not rare in samples of the trials of all pairs together: where a second
/// hump or a long tail is met by one trial in ten, some pair of thirty has not met it in forty trials, while the others
/// have.
/// @return whether there are any
bool withdraw_what_others_explain(const PairTester& tester, std::span<const Quantity> pairs,
                                  std::vector<std::optional<PairTest>>& tests) {
    constexpr std::size_t most_values = 20'000'000;  // number of values drawn: a third of a second
    constexpr std::size_t most_samples = 200'000;
    constexpr std::size_t many_trials = 400;  // their own skewness shows as much as that of the others
    const CellEstimates& estimates = tester.estimates;
    const auto trials = estimates.trials();
    const auto found_biased = [&](const std::optional<PairTest>& test) {
        return test && test->mean && test->test.p < tester.pair_alpha;
    };
    if (trials == 0 || trials > many_trials || std::ranges::none_of(tests, found_biased)) return false;
    // Pairs may lean to either side: those that clearly lean downwards are mirrored. Normal trials seem to lean, too.
    const double clearly = 2 * stats::skewness_standard_error(estimates.trials()).value_or(0);
    std::vector<double> pooled;
    for (std::size_t i = 0; i < pairs.size(); ++i) {
        if (!tests[i] || !tests[i]->mean) continue;
        stats::PooledTails pair;
        pair.add(estimates.values(pairs[i]));
        const bool leans_down = stats::moments_of(pair.values()).skewness().value_or(0) < -clearly;
        for (const double value : pair.values()) pooled.push_back(leans_down ? -value : value);
    }
    const auto sound = stats::resampled_t(pooled, trials, std::min(most_samples, most_values / trials),
                                          derive_key(tester.plan.spec.seed, "bias|" + tester.cell().canonical));
    const double rare = tester.pair_alpha / 2 * static_cast<double>(sound.size());
    bool some = false;
    for (auto& test : tests) {
        if (!found_biased(test)) continue;
        const double size = std::abs(test->t);
        const auto below = std::ranges::count_if(sound, [size](double t) { return t <= -size; });
        const auto above = std::ranges::count_if(sound, [size](double t) { return t >= size; });
        if (static_cast<double>(std::max(below, above)) <= rare) continue;
        withdraw(*test);
        some = true;
    }
    return some;
}

/// Whether the law of a method's estimates is about that of hits: points of a sampler from outside may lie together.
bool has_known_law(const Method& method) {
    return !method.sampler.empty() && samplers::find(method.sampler).info.spread != samplers::Spread::other;
}

/// The value that would make `truth` the mean if all trials had missed it, except with probability `tail`; empty where
/// there can be none.
std::optional<stats::UnseenValue> unseen_value(const PairTester& tester, const Summary& summary, double truth,
                                               double tail) {
    const auto unseen = stats::unseen_value(*summary.mean, truth, summary.trials, tail);
    const double largest = estimator_info(tester.method()).largest_value;
    const bool impossible = std::isfinite(largest) && (unseen.value < 0 || unseen.value > largest);
    return impossible ? std::nullopt : std::optional(unseen);
}

/// The value that would explain the difference on a pair; empty where there can be none.
std::optional<stats::UnseenValue> what_explains(const PairTester& tester, const PairTest& found,
                                                const Summary& summary) {
    if (!found.mean) return std::nullopt;
    return unseen_value(tester, summary, *summary.reference, tester.pair_alpha / 2);
}

/// Keeps the value closest to the mean of its pair that would put a pair outside the margin.
void look_beyond_margin(const PairTester& tester, const PairTest& found, const Summary& summary, BiasFamily& family,
                        double& least_step) {
    if (!family.margin || (found.bounded && has_known_law(tester.method()))) return;
    for (const double side : {-1.0, 1.0}) {
        const auto unseen = unseen_value(tester, summary, *summary.reference + side * *family.margin, tester.alpha);
        if (!unseen || std::abs(unseen->value - *summary.mean) >= least_step) continue;
        least_step = std::abs(unseen->value - *summary.mean);
        family.unseen_beyond_margin = unseen;
    }
}

bool leaves_out(const stats::Interval& interval, double margin) {
    return interval.low > margin || interval.high < -margin;
}

}  // namespace

double level_of_pair(const StudyPlan& plan, std::size_t tested) {
    return stats::sidak_level(stats::sidak_level(1.0 - plan.spec.level, sampled_cells(plan)), tested);
}

bool counts_hits(const StudyPlan& plan, const CellEstimates& estimates, Quantity pair, VarianceStatus variance) {
    const Cell& cell = plan.cells[estimates.cell];
    // A value that reciprocity derives from another pair's hits is not a multiple of a hit.
    const bool completed = plan.spec.methods[cell.method].completion == Completion::reciprocal && pair.from > pair.to;
    return !completed && !plan.spec.until && estimates.lattice(pair) &&
           has_independent_hits(plan.spec.methods[cell.method], pair) &&
           (variance == VarianceStatus::sparse ||
            (variance == VarianceStatus::finite && starts_anywhere(plan.scenes[cell.scene], cell.subdivision, pair)));
}

BiasFamily judge_bias(const StudyPlan& plan, const CellEstimates& estimates, std::span<const Quantity> pairs,
                      std::span<const Summary> summaries, bool& refuted) {
    const StudySpec& spec = plan.spec;
    const auto summary_of = [&](Quantity pair) -> const Summary& {
        return *std::ranges::find(summaries, pair, &Summary::quantity);
    };
    const auto known =
        std::ranges::count_if(pairs, [&](Quantity pair) { return summary_of(pair).reference.has_value(); });
    const auto tested = static_cast<std::size_t>(std::max<std::ptrdiff_t>(1, known));
    const double alpha = 1.0 - spec.level;
    const std::size_t cells = sampled_cells(plan);
    const PairTester tester{plan, estimates, alpha, level_of_pair(plan, tested)};
    BiasFamily family;
    family.pairs = pairs.size();
    family.margin = spec.equivalence_margin;
    if (estimates.trials() < stats::fewest_replicates) {
        family.few_trials = true;
        family.untestable = family.pairs;
        return family;
    }
    std::vector<std::optional<PairTest>> tests;
    for (const Quantity pair : pairs) tests.push_back(tester.test(summary_of(pair)));
    const bool matters = spec.equivalence_margin || std::ranges::any_of(tests, [&](const auto& test) {
                             return test && test->test.p < tester.pair_alpha;
                         });
    family.heavy_tails = matters && withdraw_heavy_tails(estimates, pairs, tests);
    family.others_explain = matters && withdraw_what_others_explain(tester, pairs, tests);
    std::vector<double> p_values;
    std::vector<double> student_p;
    std::vector<std::size_t> constants;  // places in p_values of pairs with one value in every trial
    double largest_std = 0;
    double least_step = std::numeric_limits<double>::infinity();  // from a mean to BiasFamily::unseen_beyond_margin
    for (std::size_t i = 0; i < pairs.size(); ++i) {
        const Summary& summary = summary_of(pairs[i]);
        const auto& test = tests[i];
        if (!test) {
            ++family.untestable;
            if (!summary.reference) {
                ++family.no_exact_value;
                continue;
            }
            if (summary.variance == VarianceStatus::infinite) ++family.infinite_variance;
            if (summary.variance == VarianceStatus::sparse) ++family.too_few_hits;
            if (summary.variance == VarianceStatus::undefined) ++family.not_finite;
            const bool varies = summary.std && *summary.std > 0;
            if (summary.variance != VarianceStatus::finite || varies || !summary.bias || estimates.trials() < 2)
                continue;
            // Trials that all give one wrong value: they are not replicates, or the method is wrong.
            const double p = p_of_constant(*summary.bias, estimates.lattice(pairs[i]), estimates.trials());
            if (p == 1) continue;
            if (tester.may_be_unmet(summary)) {
                ++family.too_skewed;
                continue;
            }
            constants.push_back(p_values.size());
            p_values.push_back(has_known_law(tester.method())
                                   ? p
                                   : p_of_any_constant(*summary.mean, *summary.reference,
                                                       estimator_info(tester.method()).largest_value,
                                                       estimates.trials()));
            student_p.push_back(p);
            continue;
        }
        p_values.push_back(test->test.p);
        student_p.push_back(test->test.student_p);
        largest_std = std::max(largest_std, summary.std.value_or(0.0));
        if (std::abs(test->t) > family.largest_t) {
            family.largest_t = std::abs(test->t);
            family.largest_pair = pairs[i];
            family.may_be_unmet = tester.may_be_unmet(summary);
            family.unseen = what_explains(tester, *test, summary);
        }
        if (test->strict.is_finite()) {
            family.minimum_detectable_bias =
                std::max(family.minimum_detectable_bias.value_or(0), summary.minimum_detectable_bias.value_or(1.0));
        } else {
            ++family.untestable;
            ++family.too_skewed;
        }
        look_beyond_margin(tester, *test, summary, family, least_step);
        const stats::Interval& interval = test->equivalence;
        family.shown_below = std::max({family.shown_below, std::abs(interval.low), std::abs(interval.high)});
        refuted = refuted || leaves_out(test->strict, spec.equivalence_margin.value_or(1.0));
    }
    if (p_values.empty()) return family;
    const auto adjusted = stats::holm(p_values);
    const auto over_cells = [cells](double p) { return -std::expm1(static_cast<double>(cells) * std::log1p(-p)); };
    const auto smallest = [&](const std::vector<double>& p) { return over_cells(*std::ranges::min_element(p)); };
    family.adjusted_p = smallest(adjusted);
    const auto student_adjusted = stats::holm(student_p);
    family.student_p = smallest(student_adjusted);
    const auto some_constant_below_alpha = [&](const std::vector<double>& p) {
        return std::ranges::any_of(constants, [&](std::size_t k) { return over_cells(p[k]) < alpha; });
    };
    family.constant_and_wrong = some_constant_below_alpha(adjusted);
    family.constant = some_constant_below_alpha(student_adjusted);
    // A form factor lies between 0 and 1, so a larger bias is impossible.
    const bool nothing_found = family.student_p >= alpha && family.untestable < family.pairs;
    if (nothing_found && family.minimum_detectable_bias >= 1) {
        family.few_trials = true;
        family.untestable = family.pairs;
        family.minimum_detectable_bias.reset();
    }
    if (largest_std > 0 && estimates.trials() >= 2) {
        family.planned_margin = stats::equivalence_margin(largest_std, estimates.trials(), {alpha, spec.power}, tested);
    }
    return family;
}

}  // namespace ff::studies
