#pragma once

#include "stats/basics/resampling.hpp"

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

namespace ff::studies::gates {

/// A distribution that files of estimates are drawn from.
struct Law {
    std::string name;
    double mean = 0;
    std::function<double(stats::Draws&)> draw;
};

/// Laws of skewness 1 (gamma), 2 (exponential), 1 / sqrt(mean) (Poisson) and, for sigma 1.5, 33 (log-normal), and one
/// that is 0 in seven trials of ten.
Law gamma_law();
Law exponential_law();
Law poisson_law(double mean);
Law log_normal_law(double sigma);
Law zero_inflated_law();

/// Counts whose variance is far above their mean: Poisson counts with a squared normal mean.
Law clustered_counts_law(double mean);
/// A law with infinite variance (Pareto with this index), and one without even a mean.
Law pareto_law(double index);
Law cauchy_law();
Law normal_law();

/// The law with three significant digits.
Law printed(const Law& law);

std::vector<double> draw_file(const Law& law, std::size_t n, stats::Draws& draws);

/// Normal and serially correlated; correlation 1 is a random walk that begins at 0.
std::vector<double> draw_chain(double correlation, std::size_t n, double mean, stats::Draws& draws);

}  // namespace ff::studies::gates
