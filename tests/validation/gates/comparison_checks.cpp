#include "tests/validation/gates/comparison_checks.hpp"

#include "stats/basics/resampling.hpp"
#include "stats/error_rates/multiplicity.hpp"
#include "studies/analysis/class_error.hpp"
#include "tests/validation/gates/made_up_files.hpp"
#include "tests/validation/rates/bench.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace ff::studies::gates {
namespace {

constexpr double study_level = 0.95;

/// A law of errors without bias, in units of its RMSE.
struct ErrorLaw {
    Law law;
    double rms = 1;  ///< standard deviation of the law
};

ErrorLaw normal_errors() {
    return {normal_law(), 1};
}

ErrorLaw exponential_errors() {
    return {exponential_law(), 1};
}

ErrorLaw log_normal_errors(double sigma) {
    const double s = sigma * sigma;
    return {log_normal_law(sigma), std::sqrt(std::expm1(s) * std::exp(s))};
}

/// Errors that are equally large in all trials.
ErrorLaw errors_of_one_size() {
    return {{"of one size", 0, [](stats::Draws& draws) { return draws.uniform() < 0.5 ? -1 : 1; }}, 1};
}

/// The logarithm of a method's RMSE on a class of pairs, as its trials show it.
stats::Measured measured_error(const ErrorLaw& errors, double rmse, std::size_t trials, std::size_t pairs,
                               stats::Draws& draws) {
    std::vector<double> drawn = draw_file(errors.law, trials * pairs, draws);
    for (double& value : drawn) value = (value - errors.law.mean) * rmse / errors.rms;
    const auto found = class_error_of(drawn, pairs, 1, VarianceStatus::finite, study_level);
    // The RMSE of errors of one size does not vary.
    return *log_rmse(found, !found.mean_square);
}

/// Whether the first of two methods is called better (-1), or the second (1).
int called_better(const stats::Measured& first, const stats::Measured& second, double level) {
    const auto interval = stats::difference_interval(first, second, level);
    if (!interval || interval->contains(0)) return 0;
    return interval->low > 0 ? -1 : 1;
}

RateTable measure_false_winners(const Repetitions& repetitions, std::uint64_t times) {
    RateTable table{.title = "Methods of equal error",
                    .text =
                        "Two methods whose RMSE is equal and whose errors have the laws named: how often one is called "
                        "better, at a stated 5 %. The RMSE is that of 1, 4 or 24 pairs of faces. Nothing is claimed "
                        "of log-normal errors of sigma 1: their squares are far more skewed, and trials may miss "
                        "their tail.",
                    .rates = {}};
    const Bench bench{repetitions, times, table};
    struct Rivals {
        ErrorLaw first;
        ErrorLaw second;
        RateClaim claim = RateClaim::at_most;
    };
    for (const Rivals& rivals : {Rivals{normal_errors(), normal_errors()},
                                 {normal_errors(), errors_of_one_size()},
                                 {exponential_errors(), errors_of_one_size()},
                                 {exponential_errors(), exponential_errors()},
                                 {log_normal_errors(0.7), errors_of_one_size()},
                                 {log_normal_errors(0.7), normal_errors()},
                                 {log_normal_errors(1), normal_errors(), RateClaim::none}}) {
        for (const std::size_t pairs : {1u, 4u, 24u}) {
            for (const std::size_t trials : {10u, 20u, 60u, 200u}) {
                bench.add(fmt::format("apart: {} and {}, {} pair{}, {} trials", rivals.first.law.name,
                                      rivals.second.law.name, pairs, pairs == 1 ? "" : "s", trials),
                          rivals.claim, 1 - study_level, [&rivals, pairs, trials](stats::Draws& draws) {
                              const auto first = measured_error(rivals.first, 1, trials, pairs, draws);
                              const auto second = measured_error(rivals.second, 1, trials, pairs, draws);
                              return called_better(first, second, study_level) != 0;
                          });
            }
        }
    }
    return table;
}

RateTable measure_found_winners(const Repetitions& repetitions, std::uint64_t times) {
    constexpr std::size_t compared = 10;
    RateTable table{.title = "Methods of unequal error",
                    .text =
                        "Two methods of normal errors whose RMSE have the ratio named: how often the better one is "
                        "found, if they are the only ones or two of ten that are compared with each other.",
                    .rates = {}};
    const Bench bench{repetitions, times, table};
    for (const std::size_t methods : {std::size_t{2}, compared}) {
        const double level = 1 - 2 * (1 - study_level) / static_cast<double>(methods * (methods - 1));
        for (const double ratio : {1.5, 2.0, 4.0}) {
            for (const std::size_t pairs : {1u, 24u}) {
                for (const std::size_t trials : {20u, 30u, 100u}) {
                    const bool promised = pairs > 1 && ratio >= 2 && trials >= 30;
                    bench.add(fmt::format("found: ratio {:g}, {}, {} trials, {} methods", ratio,
                                          pairs == 1 ? "1 pair" : "24 pairs", trials, methods),
                              promised ? RateClaim::at_least : RateClaim::none, 0.95, [=](stats::Draws& draws) {
                                  const auto better = measured_error(normal_errors(), 1, trials, pairs, draws);
                                  const auto worse = measured_error(normal_errors(), ratio, trials, pairs, draws);
                                  return called_better(better, worse, level) == -1;
                              });
                }
            }
        }
    }
    return table;
}

}  // namespace

std::vector<RateTable> measure_comparison_checks(const Repetitions& repetitions, std::uint64_t times) {
    const std::uint64_t repeated = std::max<std::uint64_t>(times / 10, 1);
    return {measure_false_winners(repetitions, repeated), measure_found_winners(repetitions, repeated)};
}

}  // namespace ff::studies::gates
