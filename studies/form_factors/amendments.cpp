#include "studies/form_factors/amendments.hpp"

#include "core/geometry/scene.hpp"
#include "core/support/error.hpp"
#include "studies/readers/printable.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <string_view>
#include <utility>
#include <vector>

namespace ff::studies::form_factors {
namespace {

/// Inserts exchanges with new faces, each after the others of its row. @param added  in order
void insert(Matrix& matrix, const std::vector<FaceExchange>& added) {
    std::vector<FaceExchange> exchanges;
    exchanges.reserve(matrix.exchanges.size() + added.size());
    auto next = matrix.exchanges.begin();
    for (const FaceExchange& exchange : added) {
        for (; next != matrix.exchanges.end() && next->from <= exchange.from; ++next) exchanges.push_back(*next);
        exchanges.push_back(exchange);
    }
    exchanges.insert(exchanges.end(), next, matrix.exchanges.end());
    matrix.exchanges = std::move(exchanges);
}

double closure_defect(const Matrix::Sparse& factors) {
    return ((factors * Eigen::VectorXd::Ones(factors.cols())).array() - 1).abs().maxCoeff();
}

}  // namespace

void expect_surroundings(const Scene& scene, const std::string& name) {
    if (const std::string_view problem = problem_with_name(name); !problem.empty())
        throw UserError("--surroundings '{}' {}", name, problem);
    if (scene.closed)
        throw UserError("--surroundings {}: scene '{}' is closed (nothing leaves it). Leave it out.", name, scene.name);
    if (std::find(scene.faces.begin(), scene.faces.end(), name) != scene.faces.end())
        throw UserError("--surroundings {}: scene '{}' has a face of that name. Choose another name.", name,
                        scene.name);
}

Scene with_added_faces(Scene scene, const std::string& surroundings) {
    for (const MaskedPart& mask : scene.masks) scene.faces.push_back(mask.name);
    if (surroundings.empty()) return scene;
    scene.faces.push_back(surroundings);
    scene.closed = true;
    return scene;
}

void add_masks(Matrix& matrix, const Scene& scene) {
    std::vector<FaceExchange> added;
    for (const MaskedPart& mask : scene.masks) {
        const auto base = static_cast<std::size_t>(std::find(scene.faces.begin(), scene.faces.end(), mask.base) -
                                                   scene.faces.begin());
        FaceExchange& exchange = added.emplace_back(no_exchange(base, matrix.faces()));
        exchange.method = ExchangeMethod::closed_form;
        exchange.reason = ExchangeReason::covers;
        exchange.value = exchange.low = exchange.high = mask.area;
        const double whole = matrix.areas[base] + mask.area;
        const double rest = matrix.areas[base] / whole;
        RowSum& row = matrix.rows[base];
        for (double* sum : {&row.value, &row.low, &row.high}) *sum = *sum * rest + mask.area / whole;
        for (double* sum : {&row.dropped.value, &row.dropped.low, &row.dropped.high}) *sum *= rest;
        matrix.areas[base] = whole;
        matrix.areas.push_back(mask.area);
        matrix.rows.push_back({1, 1, 1});
    }
    std::stable_sort(added.begin(), added.end(),
                     [](const FaceExchange& a, const FaceExchange& b) { return a.from < b.from; });
    insert(matrix, added);
}

void add_surroundings(Matrix& matrix) {
    const std::size_t surroundings = matrix.faces();
    std::vector<FaceExchange> added;
    double value = 0, low = 0, high = 0;
    for (std::size_t face = 0; face < surroundings; ++face) {
        RowSum& row = matrix.rows[face];
        const double area = matrix.areas[face];
        FaceExchange rest = no_exchange(face, surroundings);
        rest.method = ExchangeMethod::remainder;
        rest.reason = ExchangeReason::leaves;
        rest.low = area * std::max(0.0, 1 - row.high);
        rest.high = area * std::max(0.0, 1 - row.low);
        rest.value = std::clamp(area * (1 - row.value), rest.low, rest.high);
        value += rest.value;
        low += rest.low;
        high += rest.high;
        if (rest.high > 0) added.push_back(rest);
        row = {1, 1, 1, false, row.dropped};
    }
    insert(matrix, added);
    // Where nothing leaves the scene, any area will do.
    const double area = value > 0 ? value : std::accumulate(matrix.areas.begin(), matrix.areas.end(), 0.0);
    matrix.areas.push_back(area);
    matrix.rows.push_back({value / area, low / area, high / area});
    matrix.lost_rays = 0;  // they met the surroundings
}

RepairedFactors repair(const Matrix& matrix) {
    const Balanced balanced = balance_within(matrix, matrix.factors());
    return compare_repaired(matrix, balanced.factors, balanced.balanced);
}

Balanced balance_within(const Matrix& intervals, const Matrix::Sparse& factors) {
    Matrix::Sparse weights = intervals.half_widths();
    // A width of 0 would be an infinite weight; entries that are known better than this have the weight of this width.
    constexpr double least_relative_width = 1e-8;
    const double floor = std::max(least_relative_width * weights.coeffs().maxCoeff(), 1e-16);
    // Both directions are one estimate, and count once.
    for (Eigen::Index place = 0; place < weights.nonZeros(); ++place) {
        double& width = weights.coeffs()[place];
        const bool is_zero = width == 0 && factors.coeffs()[place] == 0;
        width = is_zero ? 0 : std::pow(floor / std::max(floor, width), 2);
    }
    return balance(factors, weights, Eigen::Map<const Eigen::VectorXd>(intervals.areas.data(), factors.rows()));
}

RepairedFactors compare_repaired(const Matrix& matrix, const Matrix::Sparse& repaired, bool possible) {
    constexpr double rounding = 1e-15;
    const Matrix::Sparse factors = matrix.factors();
    const Matrix::Sparse widths = matrix.half_widths();
    RepairedFactors result;
    result.possible = possible;
    result.closure_before = closure_defect(factors);
    result.closure_after = closure_defect(repaired);
    const Matrix::Sparse changes = repaired - factors;
    result.factors = repaired;
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
    if (rows_add_up(scene)) return;
    if (scene.closed)
        throw UserError(
            "--repair: scene '{}' has surfaces that belong to no face (its rows need not add up to 1). Leave it out.",
            scene.name);
    throw UserError(
        "--repair: scene '{}' is not said to be closed (its rows need not add up to 1). Say so in the "
        "scene file ('# closed', 'closed = true' or 'encl=1'), or leave --repair out.",
        scene.name);
}

}  // namespace ff::studies::form_factors
