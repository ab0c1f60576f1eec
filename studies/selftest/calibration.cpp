#include "studies/selftest/calibration.hpp"

#include "stats/bias_test.hpp"
#include "stats/distributions.hpp"
#include "stats/kolmogorov.hpp"
#include "stats/power.hpp"
#include "studies/gates/estimate_gates.hpp"
#include "studies/gates/measurement.hpp"

#include <fmt/format.h>

#include <cmath>

namespace ff::studies {
namespace {

/// Of one trial, so that effects are in units of it.
constexpr double sigma = 1;
constexpr double wide = 1;        // a band far wider than the noise of a mean: only one of its ends can be crossed
constexpr double narrow = 1e-12;  // one that the noise does not see: a point null hypothesis

struct Experiment {
    std::size_t trials = 0;
    double bias = 0;
    double half_width = 0;
    Levels levels;
};

stats::Moments draw_trials(const Experiment& experiment, stats::Draws& draws) {
    stats::Moments moments(0);
    for (std::size_t i = 0; i < experiment.trials; ++i) moments.add(experiment.bias + sigma * draw_normal(draws));
    return moments;
}

Verdict run_gate(const Experiment& experiment, stats::Draws& draws) {
    const Band band{-experiment.half_width, experiment.half_width};
    return judge(measure_mean(draw_trials(experiment, draws), {}, band, experiment.levels), band);
}

Levels levels_at(double fail_alpha) {
    return {.fail_alpha = fail_alpha, .pass_alpha = 0.05, .power = 0.9};
}

struct Bench {
    const Repetitions& repetitions;
    std::uint64_t times;

    [[nodiscard]] MeasuredRate rate(const std::string& what, const Experiment& experiment, Verdict verdict,
                                    double claimed) const {
        const auto counts =
            repetitions.count(times, what, [&](stats::Draws& draws) { return run_gate(experiment, draws) == verdict; });
        return {.what = what, .counts = counts, .claim = RateClaim::equal, .claimed = claimed};
    }

    [[nodiscard]] PValues p_values(const std::string& what, const Experiment& experiment) const {
        const auto p = repetitions.collect(times, what, [&](stats::Draws& draws) {
            const stats::Moments moments = draw_trials(experiment, draws);
            return stats::student_tail((*moments.bias() - experiment.half_width) / *moments.standard_error(),
                                       static_cast<double>(experiment.trials - 1));
        });
        const auto test = stats::test_uniformity(p);
        return {.what = what, .n = p.size(), .distance = test->distance, .p = test->p};
    }
};

void measure_false_alarms(const Bench& bench, Calibration& calibration) {
    RateTable& table = calibration.false_alarms;
    table.title = "False alarms";
    table.text =
        "Gates on the mean of normal trials. At the end of a band that is wide beside the noise only one end of the "
        "interval can leave it, so that a gate of level α fails in α/2 of all runs there, and in fewer inside; a band "
        "that is narrow beside the noise leaves both ends, and the rate is α. The last rows are wrong passes: an "
        "effect "
        "at the end of the band passes in 5 %.";
    for (const double alpha : {0.05, 0.01, 1e-4}) {
        for (const std::size_t trials : {10u, 100u}) {
            const std::string gate = fmt::format("α = {}, {} trials", alpha, trials);
            const Levels levels = levels_at(alpha);
            table.rates.push_back(bench.rate("fails without bias, point null: " + gate, {trials, 0, narrow, levels},
                                             Verdict::fail, alpha));
            table.rates.push_back(
                bench.rate("fails at bias = +band: " + gate, {trials, wide, wide, levels}, Verdict::fail, alpha / 2));
            table.rates.push_back(
                bench.rate("fails at bias = -band: " + gate, {trials, -wide, wide, levels}, Verdict::fail, alpha / 2));
        }
    }
    const Levels levels = levels_at(0.01);
    for (const double bias : {wide, -wide}) {
        table.rates.push_back(bench.rate(fmt::format("passes at bias = {}band: 100 trials", bias > 0 ? '+' : '-'),
                                         {100, bias, wide, levels}, Verdict::pass, levels.pass_alpha));
    }
    for (const std::size_t trials : {10u, 100u}) {
        calibration.p_values.push_back(
            bench.p_values(fmt::format("bias = +band, {} trials", trials), {trials, wide, wide, levels}));
        calibration.p_values.push_back(
            bench.p_values(fmt::format("point null, {} trials", trials), {trials, 0, narrow, levels}));
    }
}

void measure_power(const Bench& bench, Calibration& calibration) {
    RateTable& table = calibration.power;
    table.title = "Power";
    table.text =
        "A bias beyond the band by exactly what is called detectable fails as often as the power says, and a method "
        "without bias passes as often as it was planned to.";
    for (const double power : {0.5, 0.9, 0.99}) {
        constexpr std::size_t trials = 50;
        Levels levels = levels_at(0.01);
        levels.power = power;
        const double beyond = stats::minimum_detectable_bias(sigma, trials, {levels.fail_alpha, power});
        table.rates.push_back(bench.rate(fmt::format("fails at the detectable bias: power {}", power),
                                         {trials, wide + beyond, wide, levels}, Verdict::fail, power));
        constexpr double band = 0.3;
        const std::size_t planned = stats::trials_for_equivalence(band, sigma, {levels.pass_alpha, power});
        const double exact = stats::equivalence_power(band, 0, sigma, planned, levels.pass_alpha);
        table.rates.push_back(
            bench.rate(fmt::format("passes without bias: planned power {} ({} trials: {:.4f})", power, planned, exact),
                       {planned, 0, band, levels}, Verdict::pass, exact));
    }
}

/// Normal estimates of which each resembles the one before; mean `mean`, variance 1.
EstimateSeries draw_series(double correlation, std::size_t n, double mean, stats::Draws& draws) {
    EstimateSeries series{.quantity = "x", .values = {}, .lines = std::vector<std::size_t>(n, 1)};
    double x = draw_normal(draws);
    for (std::size_t i = 0; i < n; ++i) {
        series.values.push_back(mean + x);
        x = correlation * x + std::sqrt(1 - correlation * correlation) * draw_normal(draws);
    }
    return series;
}

void measure_correlated(const Bench& bench, Calibration& calibration) {
    RateTable& table = calibration.correlated;
    table.title = "Serially correlated estimates";
    table.text =
        "Files of 400 estimates in which each resembles the one before (autoregressive), bias exactly at the end of "
        "the "
        "band, α = 0.05. *Widened* is what `--estimates` does. Too narrow an interval fails too often.";
    GatesSpec spec;
    spec.alpha = 0.05;
    Gate gate;
    gate.name = gate.quantity = "x";
    gate.against = Against::number;
    gate.reference = 0;
    gate.band = {-wide, wide};
    spec.gates = {gate};
    for (const double correlation : {0.0, 0.1, 0.3, 0.6, 0.9}) {
        const auto fails = [&](const std::string& what, bool widened) {
            return bench.repetitions.count(bench.times / 10, what, [&](stats::Draws& draws) {
                const EstimateSeries series = draw_series(correlation, 400, wide, draws);
                if (widened) return judge_estimates(spec, gate, {"x.csv", {series}}).verdict == Verdict::fail;
                const auto moments = stats::moments_of(series.values);
                return judge(measure_mean(moments, {}, gate.band, levels_at(spec.alpha)), gate.band) == Verdict::fail;
            });
        };
        const std::string naive = fmt::format("fails: correlation {}, taken as independent", correlation);
        const std::string widened = fmt::format("fails: correlation {}, widened", correlation);
        const bool independent = correlation == 0;
        table.rates.push_back(
            {naive, fails(naive, false), independent ? RateClaim::equal : RateClaim::none, spec.alpha / 2});
        table.rates.push_back(
            {widened, fails(widened, true), independent ? RateClaim::at_most : RateClaim::none, spec.alpha / 2});
    }
}

/// Of a Pareto distribution: P(x > t) = t^-index from 1 on.
double draw_pareto(double index, stats::Draws& draws) {
    return std::pow(1 - draws.uniform(), -1 / index);
}

void measure_heavy(const Bench& bench, Calibration& calibration) {
    RateTable& table = calibration.heavy;
    table.title = "Estimates of infinite variance";
    table.text =
        "Files of estimates whose tail index is 3/2, as that of the area kernel between faces that touch, under a band "
        "so wide that every interval lies inside: they must not pass. Exponential ones have to.";
    GatesSpec spec;
    Gate gate;
    gate.name = gate.quantity = "x";
    gate.against = Against::number;
    gate.reference = 0;
    gate.band = {-1e9, 1e9};
    spec.gates = {gate};
    const auto passes = [&](const std::string& what, std::size_t n, auto draw) {
        return bench.repetitions.count(std::max<std::uint64_t>(20, bench.times / 40), what, [&](stats::Draws& draws) {
            EstimateSeries series{.quantity = "x", .values = {}, .lines = std::vector<std::size_t>(n, 1)};
            for (std::size_t i = 0; i < n; ++i) series.values.push_back(draw(draws));
            return judge_estimates(spec, gate, {"x.csv", {series}}).verdict == Verdict::pass;
        });
    };
    for (const std::size_t n : {200u, 1000u, 10'000u}) {
        const std::string heavy = fmt::format("passes: tail index 3/2, {} estimates", n);
        const auto pareto = [](stats::Draws& draws) { return draw_pareto(1.5, draws); };
        table.rates.push_back({heavy, passes(heavy, n, pareto), n > 200 ? RateClaim::at_most : RateClaim::none, 0.1});
        const std::string light = fmt::format("passes: exponential, {} estimates", n);
        table.rates.push_back({light, passes(light, n, draw_exponential), RateClaim::at_least, 0.9});
    }
}

}  // namespace

Calibration measure_calibration(const Repetitions& repetitions, std::uint64_t times) {
    const Bench bench{repetitions, times};
    Calibration calibration;
    measure_false_alarms(bench, calibration);
    measure_power(bench, calibration);
    measure_correlated(bench, calibration);
    measure_heavy(bench, calibration);
    return calibration;
}

}  // namespace ff::studies
