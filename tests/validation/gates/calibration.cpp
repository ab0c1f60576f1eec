#include "tests/validation/gates/calibration.hpp"

#include "stats/basics/distributions.hpp"
#include "stats/basics/moments.hpp"
#include "stats/error_rates/power.hpp"
#include "stats/means/mean_test.hpp"
#include "studies/verdicts/measurement.hpp"
#include "tests/support/kolmogorov.hpp"
#include "tests/validation/rates/bench.hpp"

#include <fmt/format.h>

#include <cmath>

namespace ff::studies::gates {
namespace {

/// Standard deviation of a trial, so that effects are in units of it.
constexpr double trial_sigma = 1;

/// A band far wider than the noise of a mean: only one of its ends can be crossed.
constexpr double wide_band = 1;

struct GateOnMean {
    std::size_t trials = 0;
    double bias = 0;
    double half_width = 0;
    Levels levels;
};

std::vector<double> draw_trials(const GateOnMean& experiment, stats::Draws& draws) {
    std::vector<double> trials(experiment.trials);
    for (double& trial : trials) trial = experiment.bias + trial_sigma * draw_normal(draws);
    return trials;
}

Verdict judge_drawn_trials(const GateOnMean& experiment, stats::Draws& draws) {
    const Band band{-experiment.half_width, experiment.half_width};
    return judge(measure_mean(draw_trials(experiment, draws), {}, band, experiment.levels, stats::not_skewed), band);
}

Levels levels_at(double fail_alpha) {
    return {.fail_alpha = fail_alpha, .pass_alpha = 0.05, .power = 0.9};
}

struct CalibrationBench {
    const Repetitions& repetitions;
    std::uint64_t times;

    [[nodiscard]] MeasuredRate rate(const std::string& what, const GateOnMean& experiment, Verdict verdict,
                                    double claimed) const {
        const auto counts = repetitions.count(
            times, what, [&](stats::Draws& draws) { return judge_drawn_trials(experiment, draws) == verdict; });
        return {.what = what, .counts = counts, .claim = RateClaim::equal, .claimed = claimed};
    }

    [[nodiscard]] PValues p_values(const std::string& what, const GateOnMean& experiment) const {
        const auto p = repetitions.collect(times, what, [&](stats::Draws& draws) {
            const stats::Moments moments = stats::moments_of(draw_trials(experiment, draws));
            return stats::student_tail((*moments.bias() - experiment.half_width) / *moments.standard_error(),
                                       static_cast<double>(experiment.trials - 1));
        });
        const auto test = test::test_uniformity(p);
        return {.what = what, .n = p.size(), .distance = test->distance, .p = test->p};
    }
};

void measure_false_alarms(const CalibrationBench& bench, Calibration& calibration) {
    RateTable& table = calibration.false_alarms;
    table.title = "False alarms";
    table.text =
        "Gates on the mean of normal trials. Where the band is wide compared with the noise, only one end of the "
        "interval can leave it, so that with an effect at the end of the band a gate of level α fails in α/2 of all "
        "runs, and in fewer with an effect inside; where it is narrow, both ends can, and the rate is α. The last rows "
        "are wrong passes: an effect at the end of the band passes in 5 % of runs.";
    for (const double alpha : {0.05, 0.01, 1e-4}) {
        for (const std::size_t trials : {10u, 100u}) {
            const std::string gate = fmt::format("α = {}, {} trials", alpha, trials);
            const Levels levels = levels_at(alpha);
            table.rates.push_back(bench.rate("fails without bias, point null: " + gate,
                                             {trials, 0, narrowest_band, levels}, Verdict::fail, alpha));
            table.rates.push_back(bench.rate("fails at bias = +band: " + gate, {trials, wide_band, wide_band, levels},
                                             Verdict::fail, alpha / 2));
            table.rates.push_back(bench.rate("fails at bias = -band: " + gate, {trials, -wide_band, wide_band, levels},
                                             Verdict::fail, alpha / 2));
        }
    }
    const Levels levels = levels_at(0.01);
    for (const double bias : {wide_band, -wide_band}) {
        table.rates.push_back(bench.rate(fmt::format("passes at bias = {}band: 100 trials", bias > 0 ? '+' : '-'),
                                         {100, bias, wide_band, levels}, Verdict::pass, levels.pass_alpha));
    }
    for (const std::size_t trials : {10u, 100u}) {
        calibration.p_values.push_back(
            bench.p_values(fmt::format("bias = +band, {} trials", trials), {trials, wide_band, wide_band, levels}));
        calibration.p_values.push_back(
            bench.p_values(fmt::format("point null, {} trials", trials), {trials, 0, narrowest_band, levels}));
    }
}

void measure_power(const CalibrationBench& bench, Calibration& calibration) {
    RateTable& table = calibration.power;
    table.title = "Power";
    table.text =
        "A bias that exceeds the band by exactly the stated detectable amount fails as often as the power says, and a "
        "method without bias passes as often as planned.";
    for (const double power : {0.5, 0.9, 0.99}) {
        constexpr std::size_t trials = 50;
        Levels levels = levels_at(0.01);
        levels.power = power;
        const double beyond = stats::minimum_detectable_bias(trial_sigma, trials, {levels.fail_alpha, power});
        table.rates.push_back(bench.rate(fmt::format("fails at the detectable bias: power {}", power),
                                         {trials, wide_band + beyond, wide_band, levels}, Verdict::fail, power));
        constexpr double band = 0.3;
        const std::size_t planned = stats::trials_for_equivalence(band, trial_sigma, {levels.pass_alpha, power});
        // NOLINTNEXTLINE(readability-suspicious-call-argument)
        const double exact = stats::equivalence_power(band, 0, trial_sigma, planned, levels.pass_alpha);
        table.rates.push_back(
            bench.rate(fmt::format("passes without bias: planned power {} ({} trials: {:.4f})", power, planned, exact),
                       {planned, 0, band, levels}, Verdict::pass, exact));
    }
}

}  // namespace

Calibration measure_calibration(const Repetitions& repetitions, std::uint64_t times) {
    const CalibrationBench bench{repetitions, times};
    Calibration calibration;
    measure_false_alarms(bench, calibration);
    measure_power(bench, calibration);
    return calibration;
}

}  // namespace ff::studies::gates
