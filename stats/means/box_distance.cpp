#include "stats/means/box_distance.hpp"

#include "core/support/contract.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace ff::stats {
namespace {

/// A square matrix of rows.
using Matrix = std::vector<std::vector<double>>;

Matrix zeros(std::size_t size) {
    return Matrix(size, std::vector<double>(size));
}

/// Writes L of C = L Lᵀ over the lower half of C, which alone is read; false where C is not positive definite.
bool factorise(Matrix& correlation) {
    constexpr double rounding = 1e-12;  // rounding of the ones on the diagonal
    for (std::size_t i = 0; i < correlation.size(); ++i) {
        std::vector<double>& row = correlation[i];
        for (std::size_t j = 0; j <= i; ++j) {
            const std::vector<double>& other = correlation[j];
            double sum = row[j];
            for (std::size_t k = 0; k < j; ++k) sum -= row[k] * other[k];
            if (j < i) {
                row[j] = sum / other[j];
            } else {
                if (!(sum > rounding)) return false;
                row[i] = std::sqrt(sum);
            }
        }
    }
    return true;
}

/// C⁻¹ = L⁻ᵀ L⁻¹.
Matrix inverse_of(const Matrix& factor) {
    const std::size_t size = factor.size();
    Matrix columns = zeros(size);  // row j is column j of L⁻¹
    for (std::size_t j = 0; j < size; ++j) {
        std::vector<double>& column = columns[j];
        for (std::size_t i = j; i < size; ++i) {
            double sum = i == j ? 1 : 0;
            for (std::size_t k = j; k < i; ++k) sum -= factor[i][k] * column[k];
            column[i] = sum / factor[i][i];
        }
    }
    Matrix inverse = zeros(size);
    for (std::size_t i = 0; i < size; ++i) {
        for (std::size_t j = 0; j <= i; ++j) {
            double sum = 0;
            for (std::size_t k = i; k < size; ++k) sum += columns[i][k] * columns[j][k];
            inverse[i][j] = inverse[j][i] = sum;
        }
    }
    return inverse;
}

}  // namespace

bool is_positive_definite(std::span<const double> matrix, std::size_t size) {
    FF_EXPECT(matrix.size() == size * size);
    Matrix factor = zeros(size);
    for (std::size_t i = 0; i < size; ++i) {
        for (std::size_t j = 0; j < size; ++j) factor[i][j] = matrix[i * size + j];
    }
    return factorise(factor);
}

/// Coordinate descent in the box. The distance is convex, so that from any point it falls by no more than the largest
/// descent of its tangent within the box.
std::optional<double> distance_to_box(std::span<const double> x, std::span<const double> low,
                                      std::span<const double> high, std::span<const double> covariance) {
    const std::size_t size = x.size();
    FF_EXPECT(low.size() == size && high.size() == size && covariance.size() == size * size);
    std::vector<double> scale(size);
    for (std::size_t i = 0; i < size; ++i) {
        if (!(covariance[i * size + i] > 0)) return std::nullopt;
        scale[i] = std::sqrt(covariance[i * size + i]);
    }
    Matrix correlation = zeros(size);
    for (std::size_t i = 0; i < size; ++i) {
        for (std::size_t j = 0; j < size; ++j) correlation[i][j] = covariance[i * size + j] / scale[i] / scale[j];
    }
    if (!factorise(correlation)) return std::nullopt;
    const Matrix precision = inverse_of(correlation);

    // Everything in units of standard deviations, relative to x.
    std::vector<double> least(size);
    std::vector<double> most(size);
    std::vector<double> step(size);
    std::vector<double> slope(size);  // half of the gradient
    for (std::size_t i = 0; i < size; ++i) {
        least[i] = (low[i] - x[i]) / scale[i];
        most[i] = (high[i] - x[i]) / scale[i];
    }
    const auto move = [&](std::size_t i, double by) {
        step[i] += by;
        for (std::size_t j = 0; j < size; ++j) slope[j] += by * precision[i][j];
    };
    for (std::size_t i = 0; i < size; ++i) move(i, std::clamp(0.0, least[i], most[i]));
    constexpr int most_sweeps = 1000;
    constexpr double still = 1e-9;
    for (int sweep = 0; sweep < most_sweeps; ++sweep) {
        double largest = 0;
        for (std::size_t i = 0; i < size; ++i) {
            const double by = std::clamp(step[i] - slope[i] / precision[i][i], least[i], most[i]) - step[i];
            largest = std::max(largest, std::abs(by));
            if (by != 0) move(i, by);
        }
        if (largest < still) break;
    }
    double distance = 0;
    for (std::size_t i = 0; i < size; ++i) {
        distance += step[i] * slope[i];
        distance += 2 * slope[i] * ((slope[i] > 0 ? least[i] : most[i]) - step[i]);
    }
    return std::max(0.0, distance);
}

}  // namespace ff::stats
