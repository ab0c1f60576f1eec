#include "tests/validation/gates/made_up_files.hpp"

#include "tests/validation/rates/repetitions.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

namespace ff::studies::gates {
namespace {

/// Gaps of a Poisson process, counted up to `mean`.
double draw_poisson(double mean, stats::Draws& draws) {
    double count = 0;
    double at = draw_exponential(draws);
    while (at <= mean) {
        at += draw_exponential(draws);
        ++count;
    }
    return count;
}

}  // namespace

Law gamma_law() {
    return {"gamma, skewness 1", 4, [](stats::Draws& draws) {
                return draw_exponential(draws) + draw_exponential(draws) + draw_exponential(draws) +
                       draw_exponential(draws);
            }};
}

Law exponential_law() {
    return {"exponential", 1, draw_exponential};
}

Law poisson_law(double mean) {
    return {fmt::format("Poisson counts of mean {:g}", mean), mean,
            [mean](stats::Draws& draws) { return draw_poisson(mean, draws); }};
}

Law log_normal_law(double sigma) {
    return {fmt::format("log-normal, sigma {:g}", sigma), std::exp(sigma * sigma / 2),
            [sigma](stats::Draws& draws) { return std::exp(sigma * draw_normal(draws)); }};
}

Law zero_inflated_law() {
    return {"zero in 7 of 10, else exponential", 0.3,
            [](stats::Draws& draws) { return draws.uniform() < 0.7 ? 0 : draw_exponential(draws); }};
}

Law clustered_counts_law(double mean) {
    return {fmt::format("negative binomial counts of mean {:g}", mean), mean, [mean](stats::Draws& draws) {
                const double z = draw_normal(draws);
                return draw_poisson(mean * z * z, draws);
            }};
}

Law pareto_law(double index) {
    return {fmt::format("tail index {:g}", index), index / (index - 1),
            [index](stats::Draws& draws) { return std::pow(1 - draws.uniform(), -1 / index); }};
}

Law cauchy_law() {
    return {"Cauchy", 0,
            [](stats::Draws& draws) { return std::tan(std::numbers::pi * (draws.uniform() + 0x1p-54 - 0.5)); }};
}

Law normal_law() {
    return {"normal", 0, draw_normal};
}

Law printed(const Law& law) {
    return {law.name + ", three digits", law.mean,
            [draw = law.draw](stats::Draws& draws) { return std::stod(fmt::format("{:.2e}", draw(draws))); }};
}

std::vector<double> draw_file(const Law& law, std::size_t n, stats::Draws& draws) {
    std::vector<double> values(n);
    for (double& value : values) value = law.draw(draws);
    return values;
}

std::vector<double> draw_chain(double correlation, std::size_t n, double mean, stats::Draws& draws) {
    std::vector<double> values;
    const double news = correlation < 1 ? std::sqrt(1 - correlation * correlation) : 1;
    double x = correlation < 1 ? draw_normal(draws) : 0;
    for (std::size_t i = 0; i < n; ++i) {
        values.push_back(mean + x);
        x = correlation * x + news * draw_normal(draws);
    }
    return values;
}

}  // namespace ff::studies::gates
