#include "studies/form_factors/repair.hpp"

#include "core/radiosity/repair.hpp"
#include "core/support/error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace ff::studies::form_factors {
namespace {

/// A width of 0 would be an infinite weight; what is known better than this moves no less than it.
constexpr double least_relative_width = 1e-8;

double closure_defect(const Eigen::MatrixXd& factors) {
    return (factors.rowwise().sum().array() - 1).abs().maxCoeff();
}

/// @param what  takes the matrix with all its zeros  @throws UserError for more faces than most_dense_faces
void expect_dense(const Scene& scene, std::string_view what) {
    if (scene.faces.size() <= most_dense_faces) return;
    throw UserError(
        fmt::format("{}: scene '{}' has {} faces (it takes a matrix with all zeros, of at most {}). Put "
                    "surfaces into groups.",
                    what, scene.name, scene.faces.size(), most_dense_faces));
}

}  // namespace

RepairedFactors repair(const Matrix& matrix) {
    const Eigen::MatrixXd factors = matrix.factors();
    const Eigen::MatrixXd widths = matrix.half_widths();
    const double floor = std::max(least_relative_width * widths.maxCoeff(), 1e-16);
    Eigen::MatrixXd weights(factors.rows(), factors.cols());
    for (Eigen::Index i = 0; i < weights.rows(); ++i) {
        for (Eigen::Index j = 0; j < weights.cols(); ++j) {
            const bool zero = factors(i, j) == 0 && widths(i, j) == 0;
            // Both directions are one estimate, and count once.
            const double width = std::max(floor, widths(i, j));
            weights(i, j) = zero ? 0 : floor * floor / (width * width);
        }
    }
    const Eigen::VectorXd areas = Eigen::Map<const Eigen::VectorXd>(matrix.areas.data(), factors.rows());
    Balanced balanced = balance(factors, weights, areas);
    return compare_repaired(matrix, std::move(balanced.factors), balanced.balanced);
}

RepairedFactors compare_repaired(const Matrix& matrix, Eigen::MatrixXd repaired, bool possible) {
    const Eigen::MatrixXd factors = matrix.factors();
    const Eigen::MatrixXd widths = matrix.half_widths();
    RepairedFactors result;
    result.factors = std::move(repaired);
    result.possible = possible;
    result.closure_before = closure_defect(factors);
    result.closure_after = closure_defect(result.factors);
    for (Eigen::Index i = 0; i < factors.rows(); ++i) {
        for (Eigen::Index j = 0; j < factors.cols(); ++j) {
            const double change = std::abs(result.factors(i, j) - factors(i, j));
            result.outside += change > std::max(widths(i, j), 1e-15);
            if (change <= result.largest_change) continue;
            result.largest_change = change;
            result.from = static_cast<std::size_t>(i);
            result.to = static_cast<std::size_t>(j);
        }
    }
    return result;
}

void expect_repairable(const Scene& scene) {
    expect_dense(scene, "--repair");
    if (scene.closed || scene.empty_box) return;
    throw UserError(
        fmt::format("--repair: scene '{}' is not said to be closed (its rows need not add up to 1). Say so in the "
                    "scene file ('# closed', 'closed = true' or 'encl=1'), or leave --repair out.",
                    scene.name));
}

}  // namespace ff::studies::form_factors
