#include "tests/validation/gates/estimate_checks.hpp"

#include "core/support/error.hpp"
#include "stats/error_rates/multiplicity.hpp"
#include "studies/analysis/analysis.hpp"
#include "studies/verdicts/measurement.hpp"
#include "studies/verdicts/reported/estimate_gates.hpp"
#include "tests/validation/gates/made_up_files.hpp"
#include "tests/validation/rates/bench.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

namespace ff::studies::gates {
namespace {

/// A band that every interval lies in.
constexpr double widest_band = 1e9;

/// Verdict of a file on a gate for its mean; empty where it is refused.
std::optional<Verdict> judge_file(std::vector<double> values, double truth, const Band& band, double alpha) {
    Spec spec;
    spec.alpha = alpha;
    Gate gate;
    gate.name = gate.quantity = "x";
    gate.against = Against::number;
    gate.reference = truth;
    gate.band = band;
    spec.gates = {gate};
    EstimateSeries series{.quantity = "x", .values = std::move(values), .lines = {}};
    series.lines.assign(series.values.size(), 1);
    try {
        return judge_estimates(spec, gate, {"x.csv", {series}}).verdict;
    } catch (const UserError&) {
        return std::nullopt;
    }
}

RateTable measure_skewed(const Repetitions& repetitions, std::uint64_t times) {
    RateTable table{.title = "Skewed estimates",
                    .text =
                        "Files without bias under a band far narrower than the noise, so that both ends can be "
                        "left and the rate may be α; and wrong passes, the effect at the upper or the lower end of "
                        "a band that is wide compared with the noise.",
                    .rates = {}};
    const Bench bench{repetitions, times, table};
    for (const Law& law :
         {normal_law(), gamma_law(), poisson_law(1), exponential_law(), zero_inflated_law(), log_normal_law(1.5)}) {
        for (const std::size_t n : {20u, 50u, 200u}) {
            for (const double alpha : {1e-2, 1e-4}) {
                bench.add(fmt::format("fails: {}, {} estimates, α = {}", law.name, n, alpha), RateClaim::at_most, alpha,
                          [&, n, alpha](stats::Draws& draws) {
                              return judge_file(draw_file(law, n, draws), law.mean, {-narrow_band, narrow_band},
                                                alpha) == Verdict::fail;
                          });
            }
        }
    }
    for (const Law& law : {normal_law(), gamma_law(), poisson_law(1), exponential_law()}) {
        for (const double end : {1.0, -1.0}) {
            bench.add(fmt::format("passes at the {} end: {}, 50 estimates", end > 0 ? "upper" : "lower", law.name),
                      RateClaim::at_most, 0.05, [&, end](stats::Draws& draws) {
                          const double width = 1e3;
                          return judge_file(draw_file(law, 50, draws), law.mean - end * width, {-width, width}, 1e-4) ==
                                 Verdict::pass;
                      });
        }
    }
    for (const std::size_t n : {30u, 50u, 100u, 200u}) {
        bench.add(fmt::format("fails: normal, {} estimates, α = 0.0001, bias of one σ", n), RateClaim::none, 0,
                  [n](stats::Draws& draws) {
                      return judge_file(draw_file(normal_law(), n, draws), -1, {-narrow_band, narrow_band}, 1e-4) ==
                             Verdict::fail;
                  });
    }
    return table;
}

RateTable measure_correlated(const Repetitions& repetitions, std::uint64_t times) {
    RateTable table{.title = "Serially correlated estimates",
                    .text =
                        "Files in which each estimate resembles the one before (autoregressive; correlation 1 is a "
                        "random walk), bias exactly at the end of the band, α = 0.05. *As independent* is what "
                        "Student's t would do; a correlation that 30 values do not show remains in the others.",
                    .rates = {}};
    const Bench bench{repetitions, times, table};
    constexpr double alpha = 0.05;
    constexpr double end = 1e3;
    const auto chain = [&](double correlation, std::size_t n, stats::Draws& draws) {
        return draw_chain(correlation, n, end, draws);
    };
    for (const std::size_t n : {30u, 100u, 400u}) {
        for (const double correlation : {0.0, 0.3, 0.6, 0.9, 1.0}) {
            const std::string file = fmt::format("correlation {:g}, {} estimates", correlation, n);
            const bool seen = correlation == 0 || correlation >= 0.9;
            const auto claim = seen ? RateClaim::at_most : RateClaim::none;
            bench.add("fails as independent: " + file, RateClaim::none, 0, [&](stats::Draws& draws) {
                const Band band{-end, end};
                const Levels levels{.fail_alpha = alpha, .pass_alpha = 0.05, .power = 0.9};
                return judge(measure_mean(chain(correlation, n, draws), {}, band, levels, stats::not_skewed), band) ==
                       Verdict::fail;
            });
            bench.add("fails: " + file, claim, alpha / 2, [&](stats::Draws& draws) {
                return judge_file(chain(correlation, n, draws), 0, {-end, end}, alpha) == Verdict::fail;
            });
            bench.add("passes: " + file, claim, 0.05, [&](stats::Draws& draws) {
                return judge_file(chain(correlation, n, draws), 0, {-end, end}, alpha) == Verdict::pass;
            });
        }
    }
    return table;
}

RateTable measure_heavy(const Repetitions& repetitions, std::uint64_t times) {
    RateTable table{.title = "Estimates of infinite variance",
                    .text =
                        "Files under a band so wide that every interval lies inside: those whose tail has no "
                        "variance must not pass, as that of the area kernel between faces that touch (index 3/2). "
                        "Normal and exponential ones have to.",
                    .rates = {}};
    const Bench bench{repetitions, times, table};
    const auto passes = [&](const Law& law, std::size_t n, RateClaim claim, double claimed) {
        bench.add(fmt::format("passes: {}, {} estimates", law.name, n), claim, claimed, [&](stats::Draws& draws) {
            return judge_file(draw_file(law, n, draws), 0, {-widest_band, widest_band}, 1e-4) == Verdict::pass;
        });
    };
    for (const std::size_t n : {50u, 100u, 199u, 200u, 1000u, 10'000u}) {
        passes(cauchy_law(), n, n >= 199 ? RateClaim::at_most : RateClaim::none, 0.02);
        passes(pareto_law(1.5), n, n > 200 ? RateClaim::at_most : RateClaim::none, 0.1);
        passes(exponential_law(), n, n >= 200 ? RateClaim::at_least : RateClaim::none, 0.9);
        passes(normal_law(), n, RateClaim::at_least, 0.9);
    }
    return table;
}

/// Estimates of which each is one of `seeds` values.
std::vector<double> draw_shared_seeds(std::size_t n, std::size_t seeds, stats::Draws& draws) {
    const std::vector<double> distinct = draw_file(normal_law(), seeds, draws);
    std::vector<double> values(n);
    for (double& value : values) value = distinct[draws.below(seeds)];
    return values;
}

RateTable measure_repeats(const Repetitions& repetitions, std::uint64_t times) {
    constexpr double claimed = 1e-6;
    RateTable table{.title = "Repeated estimates",
                    .text =
                        "Files of 100 honest estimates that repeat by nature must not be refused; files whose "
                        "trials share seeds must be, and what hangs on one trial must not pass.",
                    .rates = {}};
    const Bench bench{repetitions, times, table};
    for (const Law& law : {zero_inflated_law(), poisson_law(0.1), poisson_law(1), poisson_law(30),
                           clustered_counts_law(5), clustered_counts_law(50), clustered_counts_law(500),
                           printed(normal_law()), printed(exponential_law()), printed(log_normal_law(1.5))}) {
        bench.add("refused: " + law.name, RateClaim::at_most, claimed, [&](stats::Draws& draws) {
            std::vector<double> values = draw_file(law, 100, draws);
            values.front() += values.front() == values.back() ? 1 : 0;  // all equal is refused, rightly
            return !judge_file(values, 0, {-widest_band, widest_band}, 1e-4);
        });
    }
    for (const std::size_t seeds : {5u, 20u, 80u}) {
        bench.add(fmt::format("refused: 100 estimates of {} seeds", seeds), RateClaim::at_least, 0.99,
                  [seeds](stats::Draws& draws) {
                      return !judge_file(draw_shared_seeds(100, seeds, draws), 0, {-widest_band, widest_band}, 1e-4);
                  });
    }
    for (const std::size_t n : {20u, 50u, 100u, 1000u}) {
        bench.add(fmt::format("passes: {} equal estimates and one other", n - 1), RateClaim::at_most, claimed,
                  [n](stats::Draws& draws) {
                      std::vector<double> values(n, 0.2);
                      values[draws.below(n)] += 1e-3 * (draws.uniform() - 0.5);
                      return judge_file(values, 0.2, {-1e-2, 1e-2}, 1e-4) == Verdict::pass;
                  });
    }
    return table;
}

/// Hits of as many rays over their number.
double draw_share(std::uint64_t rays, double p, stats::Draws& draws) {
    std::uint64_t hits = 0;
    for (std::uint64_t ray = 0; ray < rays; ++ray) hits += draws.uniform() < p ? 1u : 0u;
    return static_cast<double>(hits) / static_cast<double>(rays);
}

/// Whether a study of 3 sizes and 30 pairs finds one wrong value in every trial, by that rule alone.
bool finds_constant(std::size_t trials, bool same_numbers, stats::Draws& draws) {
    constexpr std::uint64_t rays = 256;
    constexpr double truth = 0.2;
    std::vector<double> p_values;
    for (int pair = 0; pair < 3 * 30; ++pair) {
        const double value = draw_share(rays, truth, draws);
        bool constant = true;
        for (std::size_t t = 1; constant && !same_numbers && t < trials; ++t)
            constant = draw_share(rays, truth, draws) == value;
        p_values.push_back(constant ? p_of_constant(value - truth, 1.0 / rays, trials) : 1);
    }
    const auto adjusted = stats::holm(p_values);
    return *std::min_element(adjusted.begin(), adjusted.end()) < 0.05;
}

RateTable measure_constants(const Repetitions& repetitions, std::uint64_t times) {
    RateTable table{.title = "One value in every trial",
                    .text =
                        "Studies of 30 pairs at 3 sizes, 256 rays each, at level 0.95: how often equal hits in all "
                        "trials are called a bias by themselves. (Below 5 trials a study judges nothing.)",
                    .rates = {}};
    const Bench bench{repetitions, times, table};
    for (const std::size_t trials : {2u, 3u, 5u, 20u})
        bench.add(fmt::format("biased: independent rays, {} trials", trials), RateClaim::at_most, 0.05,
                  [trials](stats::Draws& draws) { return finds_constant(trials, false, draws); });
    for (const std::size_t trials : {5u, 8u, 20u})
        bench.add(fmt::format("biased: the same random numbers in every trial, {} trials", trials),
                  trials < 8 ? RateClaim::none : RateClaim::at_least, 0.99,
                  [trials](stats::Draws& draws) { return finds_constant(trials, true, draws); });
    return table;
}

}  // namespace

std::vector<RateTable> measure_estimate_checks(const Repetitions& repetitions, std::uint64_t times) {
    const auto share = [times](std::uint64_t divisor) { return std::max<std::uint64_t>(20, times / divisor); };
    return {measure_skewed(repetitions, times), measure_correlated(repetitions, share(10)),
            measure_heavy(repetitions, share(40)), measure_repeats(repetitions, share(10)),
            measure_constants(repetitions, share(40))};
}

}  // namespace ff::studies::gates
