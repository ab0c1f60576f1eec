#include "studies/form_factors/repair.hpp"

#include "core/radiosity/repair.hpp"
#include "core/support/error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace ff::studies::form_factors {
namespace {

/// A width of 0 would be an infinite weight; entries that are known better than this have the weight of this width.
constexpr double least_relative_width = 1e-8;

double closure_defect(const Matrix::Sparse& factors) {
    return ((factors * Eigen::VectorXd::Ones(factors.cols())).array() - 1).abs().maxCoeff();
}

}  // namespace

RepairedFactors repair(const Matrix& matrix) {
    const Matrix::Sparse factors = matrix.factors();
    Matrix::Sparse weights = matrix.half_widths();
    const double floor = std::max(least_relative_width * weights.coeffs().maxCoeff(), 1e-16);
    // Both directions are one estimate, and count once.
    for (Eigen::Index place = 0; place < weights.nonZeros(); ++place) {
        double& width = weights.coeffs()[place];
        const bool is_zero = width == 0 && factors.coeffs()[place] == 0;
        width = is_zero ? 0 : std::pow(floor / std::max(floor, width), 2);
    }
    Balanced balanced =
        balance(factors, weights, Eigen::Map<const Eigen::VectorXd>(matrix.areas.data(), factors.rows()));
    return compare_repaired(matrix, std::move(balanced.factors), balanced.balanced);
}

RepairedFactors compare_repaired(const Matrix& matrix, Matrix::Sparse repaired, bool possible) {
    constexpr double rounding = 1e-15;
    const Matrix::Sparse factors = matrix.factors();
    const Matrix::Sparse widths = matrix.half_widths();
    RepairedFactors result;
    result.possible = possible;
    result.closure_before = closure_defect(factors);
    result.closure_after = closure_defect(repaired);
    const Matrix::Sparse changes = repaired - factors;
    result.factors = std::move(repaired);
    for (Eigen::Index i = 0; i < changes.outerSize(); ++i) {
        for (Matrix::Sparse::InnerIterator entry(changes, i); entry; ++entry) {
            const double change = std::abs(entry.value());
            if (change > rounding) result.outside += change > widths.coeff(i, entry.col());
            if (change <= result.largest_change) continue;
            result.largest_change = change;
            result.from = static_cast<std::size_t>(i);
            result.to = static_cast<std::size_t>(entry.col());
        }
    }
    return result;
}

void expect_repairable(const Scene& scene) {
    if (scene.closed || scene.empty_box) return;
    throw UserError(
        fmt::format("--repair: scene '{}' is not said to be closed (its rows need not add up to 1). Say so in the "
                    "scene file ('# closed', 'closed = true' or 'encl=1'), or leave --repair out.",
                    scene.name));
}

}  // namespace ff::studies::form_factors
