#include "studies/verdicts/reported/reported_faults.hpp"

#include <fmt/format.h>

#include <cmath>
#include <cstddef>

namespace ff::studies::gates {
namespace {

/// Wide enough for the chance of a hundred runs, narrow enough to name a single factor.
bool is_near(double a, double b) {
    return a > 0 && b > 0 && std::abs(std::log(a / b)) < 0.15;
}

/// Below this n the factors n and sqrt(n) are within reach of ordinary faults.
constexpr double least_n = 10;

double sum_of_sizes(Rows rows) {
    double sum = 0;
    for (const ReportedRow& row : rows) sum += std::abs(row.mean);
    return sum;
}

}  // namespace

std::string fault_of_errors(double ratio, double error, double n) {
    if (ratio > 0.5 && ratio < 2) return {};
    if (n >= least_n && is_near(ratio, 1 / std::sqrt(n)))
        return fmt::format(
            " They are about sqrt(n) = {:.3g} times too large: standard deviations of single samples, "
            "probably.",
            std::sqrt(n));
    if (n >= least_n && is_near(ratio, std::sqrt(n)))
        return fmt::format(" They are about sqrt(n) = {:.3g} times too small: divided by sqrt(n) twice, probably.",
                           std::sqrt(n));
    if (n >= least_n && is_near(ratio, 1 / n))
        return fmt::format(" They are about n = {:.3g} times too large: errors of sums rather than of means, probably.",
                           n);
    if (is_near(error, error * ratio * (error * ratio)))
        return " They are about the squares of what they should be: variances, probably.";
    return ratio > 1 ? " Correlated batches are a common cause." : "";
}

std::string fault_of_means(Rows rows, Rows against) {
    if (rows.empty() || rows.front().n < least_n) return {};
    const double n = rows.front().n;
    const double part = static_cast<double>(against.size()) / static_cast<double>(rows.size());
    const double ratio = sum_of_sizes(rows) / sum_of_sizes(against) * part;
    constexpr double close = 0.05;
    if (std::abs(ratio / n - 1) < close)
        return fmt::format(" The values are n = {:g} times the reference: sums instead of means, probably.", n);
    if (std::abs(ratio * n - 1) < close)
        return fmt::format(
            " The values are the reference over n = {:g}: divided by n twice, or a reference that is a "
            "sum, probably.",
            n);
    return {};
}

std::string fault_between_errors(Rows rows, Rows against) {
    if (rows.size() != against.size()) return {};
    const auto are_squares = [](Rows small, Rows large) {
        std::size_t squares = 0;
        std::size_t alike = 0;
        std::size_t all = 0;
        for (std::size_t i = 0; i < small.size(); ++i) {
            if (small[i].standard_error == 0 || large[i].standard_error == 0) continue;
            ++all;
            alike += std::abs(std::log(small[i].standard_error / large[i].standard_error)) < 1 ? 1u : 0u;
            squares +=
                std::abs(std::log(small[i].standard_error) - 2 * std::log(large[i].standard_error)) < 0.5 ? 1u : 0u;
        }
        return all > 0 && squares == all && alike == 0;
    };
    if (are_squares(rows, against) || are_squares(against, rows))
        return " The errors of one file are the squares of the other's: variances given as standard errors, probably.";
    return {};
}

}  // namespace ff::studies::gates
