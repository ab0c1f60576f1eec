#include "tests/validation/gates/coverage.hpp"

#include "stats/basics/quantiles.hpp"
#include "stats/convergence/convergence.hpp"
#include "stats/goodness_of_fit/anderson_darling.hpp"
#include "stats/means/mean_interval.hpp"
#include "stats/variances/variance_interval.hpp"
#include "studies/comparison/ranking.hpp"
#include "studies/diagnostics/variances.hpp"
#include "studies/verdicts/measurement.hpp"
#include "tests/support/kolmogorov.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>

namespace ff::studies::gates {
namespace {

constexpr double nominal_level = 0.95;

using Draw = double (*)(stats::Draws&);
using IntervalOf = std::function<std::optional<stats::Interval>(const std::vector<double>&)>;

/// A distribution of known mean and variance 1.
struct Distribution {
    std::string_view name;
    Draw draw;
    double mean;
};
constexpr Distribution normal_data{"normal", draw_normal, 0};
constexpr Distribution exponential_data{"exponential", draw_exponential, 1};

std::vector<double> draw_sample(const Distribution& distribution, std::size_t n, stats::Draws& draws) {
    std::vector<double> values(n);
    for (double& value : values) value = distribution.draw(draws);
    return values;
}

class CoverageTable {
  public:
    CoverageTable(const Repetitions& repetitions, std::uint64_t times) : repetitions_(repetitions), times_(times) {
        table_.title = "Coverage of intervals";
        table_.text =
            "How often an interval of nominal level 0.95 contains the true value. *At least* is claimed where a method "
            "is conservative by construction, nothing where it is approximate or serves for comparison only.";
    }

    /// Adds how often the interval that `make` makes from n values of the data contains `truth`.
    void add(std::string_view method, const Distribution& data, std::size_t n, RateClaim claim, const IntervalOf& make,
             double truth, std::uint64_t divisor = 1) {
        const std::string what = fmt::format("{}, {} data, n = {}", method, data.name, n);
        add_event(what, claim, divisor, [&](stats::Draws& draws) {
            const auto interval = make(draw_sample(data, n, draws));
            return interval && interval->contains(truth);
        });
    }

    void add_event(const std::string& what, RateClaim claim, std::uint64_t divisor,
                   const std::function<bool(stats::Draws&)>& event) {
        const auto counts = repetitions_.count(std::max<std::uint64_t>(20, times_ / divisor), what, event);
        table_.rates.push_back({.what = what, .counts = counts, .claim = claim, .claimed = nominal_level});
    }

    [[nodiscard]] RateTable take() { return std::move(table_); }

  private:
    RateTable table_;
    const Repetitions& repetitions_;
    std::uint64_t times_;
};

stats::ResamplingPlan resampling(const std::vector<double>& values) {
    // A key for each sample: its own first value, to the bit.
    return {.key = derive_key(Seed{1}, fmt::format("{:a}", values.front())), .replicates = 599};
}

void add_means(CoverageTable& table) {
    const IntervalOf student = [](const auto& x) {
        return stats::mean_interval_t(stats::moments_of(x), nominal_level);
    };
    const IntervalOf gauss = [](const auto& x) {
        return stats::mean_interval_normal(stats::moments_of(x), nominal_level);
    };
    const IntervalOf bootstrap = [](const auto& x) {
        return stats::mean_interval_bootstrap(x, nominal_level, resampling(x));
    };
    for (const std::size_t n : {5u, 10u, 100u})
        table.add("mean: student_t", normal_data, n, RateClaim::equal, student, 0);
    for (const std::size_t n : {10u, 100u})
        table.add("mean: student_t", exponential_data, n, RateClaim::none, student, 1);
    table.add("mean: normal", normal_data, 5, RateClaim::none, gauss, 0);
    table.add("mean: percentile_bootstrap", normal_data, 5, RateClaim::none, bootstrap, 0, 10);
    table.add_event("mean: stein_two_stage, normal data, pilot of 10", RateClaim::equal, 1, [](stats::Draws& draws) {
        auto values = draw_sample(normal_data, 10, draws);
        const auto pilot = *stats::pilot_of(values, values.size());
        const auto more =
            draw_sample(normal_data, stats::trials_for_half_width(pilot, 0.4, nominal_level) - pilot.n, draws);
        values.insert(values.end(), more.begin(), more.end());
        return stats::interval_of(stats::mean_evidence_after(pilot, values, 0), nominal_level).contains(0);
    });
    table.add_event("mean: welch_t, normal data, n = 10, reference n = 30 twice as noisy", RateClaim::none, 1,
                    [](stats::Draws& draws) {
                        const auto reference = stats::moments_of(draw_sample(normal_data, 30, draws));
                        const double truth = 2 * *reference.mean();
                        const auto values = draw_sample(normal_data, 10, draws);
                        const Levels levels{
                            .fail_alpha = 1 - nominal_level, .pass_alpha = (1 - nominal_level) / 2, .power = 0.9};
                        return measure_mean(values, {truth, 2 * *reference.standard_error(), 29}, {-1, 1}, levels,
                                            stats::not_skewed)
                            ->failing.contains(0);
                    });
}

ClassError ten_pairs(const std::vector<double>& errors) {
    return class_error_of(errors, 10, 1, VarianceStatus::finite, nominal_level);
}

/// One pair, with one error per trial.
ClassError one_pair(const std::vector<double>& errors) {
    return class_error_of(errors, 1, 1, VarianceStatus::finite, nominal_level);
}

/// Whether the interval of the ratio of two equal numbers contains 1.
bool covers_equality(const stats::Measured& first, const stats::Measured& second) {
    return stats::difference_interval(first, second, nominal_level)->contains(0);
}

void add_variances(CoverageTable& table) {
    const IntervalOf chi2 = [](const auto& x) {
        return stats::variance_interval_chi2(stats::moments_of(x), nominal_level);
    };
    const IntervalOf bootstrap = [](const auto& x) {
        return stats::variance_interval_bootstrap(x, nominal_level, resampling(x));
    };
    const IntervalOf chosen = [](const auto& x) { return stats::variance_interval(x, nominal_level, resampling(x)); };
    const IntervalOf spread = [](const auto& x) -> std::optional<stats::Interval> {
        const auto found = stats::mean_square_of(stats::moments_of(x));
        return found ? std::optional(stats::mean_square_interval(*found, nominal_level)) : std::nullopt;
    };
    table.add("variance: chi_squared", normal_data, 30, RateClaim::equal, chi2, 1);
    table.add("variance: chi_squared", exponential_data, 30, RateClaim::none, chi2, 1);
    for (const Distribution& data : {normal_data, exponential_data}) {
        table.add("variance: bootstrap", data, 30, RateClaim::none, bootstrap, 1, 20);
        table.add("variance: as chosen in reports", data, 30, RateClaim::none, chosen, 1, 20);
        table.add("variance: of gates", data, 30, RateClaim::none, spread, 1);
        table.add("variance: of gates", data, 300, RateClaim::none, spread, 1);
    }
    const IntervalOf square = [](const auto& errors) { return one_pair(errors).interval; };
    table.add("mean squared error: student_t", normal_data, 30, RateClaim::none, square, 1);
    // 30 trials of 10 pairs.
    const IntervalOf of_class = [](const auto& errors) { return ten_pairs(errors).variance_interval; };
    table.add("variance over 10 pairs: skewed_t", normal_data, 300, RateClaim::none, of_class, 1);
}

void add_proportions(CoverageTable& table) {
    using Method = stats::Interval (*)(stats::Proportion, double);
    struct Named {
        std::string_view name;
        Method make;
        RateClaim claim;
    };
    constexpr std::uint64_t n = 625;
    for (const Named& method : {Named{"clopper_pearson", stats::clopper_pearson_interval, RateClaim::at_least},
                                Named{"wilson", stats::wilson_interval, RateClaim::none},
                                Named{"wald", stats::wald_interval, RateClaim::none}}) {
        for (const double p : {0.001, 0.005, 0.2}) {
            table.add_event(fmt::format("proportion: {}, p = {}, n = {}", method.name, p, n), method.claim, 4,
                            [&](stats::Draws& draws) {
                                stats::Proportion counts{.hits = 0, .trials = n};
                                for (std::uint64_t i = 0; i < n; ++i) counts.hits += draws.uniform() < p ? 1u : 0u;
                                return method.make(counts, nominal_level).contains(p);
                            });
        }
    }
}

void add_ratios(CoverageTable& table) {
    for (const Distribution& data : {normal_data, exponential_data}) {
        table.add_event(fmt::format("ratio of spreads: F of gates, {} data, n = 100 and 30", data.name),
                        RateClaim::none, 1, [&](stats::Draws& draws) {
                            const auto a = stats::mean_square_of(stats::moments_of(draw_sample(data, 100, draws)));
                            const auto b = stats::mean_square_of(stats::moments_of(draw_sample(data, 30, draws)));
                            return stats::ratio_interval(*a, *b, nominal_level).contains(1);
                        });
    }
    for (const Distribution& data : {normal_data, exponential_data}) {
        table.add_event(
            fmt::format("ratio of variances over 10 pairs: square_and_add, {} data, n = 300 and 300", data.name),
            RateClaim::at_least, 1, [&](stats::Draws& draws) {
                const auto a = ten_pairs(draw_sample(data, 300, draws));
                return covers_equality(log_variance(a), log_variance(ten_pairs(draw_sample(data, 300, draws))));
            });
        table.add_event(fmt::format("ratio of RMSEs: square_and_add, {} data, n = 30 and 30", data.name),
                        RateClaim::at_least, 1, [&](stats::Draws& draws) {
                            const auto a = one_pair(draw_sample(data, 30, draws));
                            return covers_equality(*log_rmse(a), *log_rmse(one_pair(draw_sample(data, 30, draws))));
                        });
    }
}

/// Errors whose root mean square falls exactly as size^-0.5.
std::vector<stats::Rung> draw_ladder(stats::Draws& draws) {
    std::vector<stats::Rung> ladder;
    for (const double size : {64, 256, 1024, 4096}) {
        stats::Rung rung{.size = size, .errors = draw_sample(normal_data, 64, draws)};
        for (double& error : rung.errors) error /= std::sqrt(size);
        ladder.push_back(std::move(rung));
    }
    return ladder;
}

void add_slopes(CoverageTable& table) {
    table.add_event("slope: weighted least squares, normal errors, 4 sizes x 64", RateClaim::none, 4,
                    [](stats::Draws& draws) {
                        const auto rate = stats::fit_rmse_rate(draw_ladder(draws), nominal_level,
                                                               stats::ResamplingPlan{.key = {}, .replicates = 1});
                        return rate && rate->interval.contains(-0.5);
                    });
    table.add_event("slope: bootstrap, normal errors, 4 sizes x 64", RateClaim::none, 40, [](stats::Draws& draws) {
        const auto ladder = draw_ladder(draws);
        const auto plan = resampling(ladder.front().errors);
        const auto rate = stats::fit_rmse_rate(ladder, nominal_level, plan);
        return rate && rate->bootstrap.contains(-0.5);
    });
    table.add_event(
        "slope of the median: bootstrap, normal errors, 4 sizes x 64", RateClaim::none, 40, [](stats::Draws& draws) {
            const auto ladder = draw_ladder(draws);
            const auto rate = stats::fit_median_rate(ladder, nominal_level, resampling(ladder.front().errors));
            return rate && rate->interval.contains(-0.5);
        });
}

void add_distributions(CoverageTable& table) {
    table.add_event(
        "distribution: Dvoretzky-Kiefer-Wolfowitz band, n = 50", RateClaim::at_least, 1, [](stats::Draws& draws) {
            std::vector<double> values(50);
            for (double& value : values) value = draws.uniform();
            return test::test_uniformity(values)->distance <= stats::dkw_half_width(values.size(), nominal_level);
        });
}

}  // namespace

RateTable measure_coverage(const Repetitions& repetitions, std::uint64_t times) {
    CoverageTable table(repetitions, times);
    add_means(table);
    add_variances(table);
    add_ratios(table);
    add_proportions(table);
    add_slopes(table);
    add_distributions(table);
    return table.take();
}

}  // namespace ff::studies::gates
