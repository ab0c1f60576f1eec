#include "stats/convergence/power_law.hpp"

#include "core/support/contract.hpp"
#include "stats/convergence/line_fit.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace ff::stats {
namespace {

PowerLaw with_residuals(double coefficient, double exponent, std::span<const double> sizes,
                        std::span<const double> errors) {
    PowerLaw law{.coefficient = coefficient, .exponent = exponent, .largest_residual = 0};
    for (std::size_t i = 0; i < sizes.size(); ++i) {
        const double residual = errors[i] * std::pow(sizes[i], exponent) / coefficient - 1;
        law.largest_residual = std::max(law.largest_residual, std::abs(residual));
    }
    return law;
}

}  // namespace

std::optional<PowerLaw> fit_power_law(std::span<const double> sizes, std::span<const double> errors) {
    FF_EXPECT(sizes.size() == errors.size());
    std::vector<double> x;
    std::vector<double> y;
    for (std::size_t i = 0; i < sizes.size(); ++i) {
        FF_EXPECT(sizes[i] > 0);
        if (errors[i] * errors.front() <= 0) return std::nullopt;
        x.push_back(std::log(sizes[i]));
        y.push_back(std::log(std::abs(errors[i])));
    }
    const std::vector<double> equal(x.size(), 1.0);
    const auto line = fit_line(x, y, equal);
    if (!line) return std::nullopt;
    return with_residuals(std::copysign(std::exp(line->intercept), errors.front()), -line->slope, sizes, errors);
}

std::optional<PowerLaw> fit_power_law(std::span<const double> sizes, std::span<const double> errors, double exponent) {
    FF_EXPECT(sizes.size() == errors.size());
    if (sizes.empty()) return std::nullopt;
    double sum = 0;
    for (std::size_t i = 0; i < sizes.size(); ++i) sum += errors[i] * std::pow(sizes[i], exponent);
    if (sum == 0) return std::nullopt;
    return with_residuals(sum / static_cast<double>(sizes.size()), exponent, sizes, errors);
}

}  // namespace ff::stats
