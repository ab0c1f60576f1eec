#include "studies/heat/sensitivity.hpp"

#include "core/radiosity/linear_map.hpp"
#include "studies/heat/heat.hpp"

#include <Eigen/SparseCore>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

namespace ff::studies::heat {
namespace {

using Eigen::Index;
using Eigen::VectorXd;
using Sparse = form_factors::Matrix::Sparse;

constexpr double fine = 1e-9;
constexpr double as_fine_as_possible = std::numeric_limits<double>::epsilon();

/// The solution of a system of equations for faces; not finite where the iteration did not come near enough, as it may
/// in a duct of hundreds of adiabatic sections.
VectorXd solved(const LinearMap& map, const VectorXd& right, const VectorXd& guess, double tolerance) {
    constexpr double near_enough = 1e-12;
    constexpr Index always_allowed = 500;
    VectorXd x = solve(map, right, guess, tolerance, std::max(always_allowed, 2 * right.size()));
    const double left = (map(x) - right).norm();
    if (!(left <= std::max(near_enough, 10 * tolerance) * right.norm()))
        x.setConstant(std::numeric_limits<double>::quiet_NaN());
    return x;
}

/// Solves x = known + F (reflected x).
VectorXd with_reflections(const Sparse& factors, const FaceLaws& laws, const VectorXd& known, const VectorXd& guess,
                          double tolerance) {
    const auto map = [&](const VectorXd& x) -> VectorXd { return x - factors * laws.reflected.cwiseProduct(x); };
    return solved(map, known, guess, tolerance);
}

}  // namespace

VectorXd irradiation_of(const Sparse& factors, const VectorXd& out, const FaceLaws& laws, const VectorXd& guess) {
    const VectorXd first = factors * laws.emitted + laws.surroundings * out;
    return with_reflections(factors, laws, first, guess, as_fine_as_possible);
}

Sensitivity::Sensitivity(const Scene& scene, const form_factors::Matrix& matrix, const Materials& materials,
                         double scale)
    : matrix_(matrix),
      laws_(laws_of(materials)),
      sees_out_(!form_factors::rows_add_up(scene)),
      factors_(matrix.factors()) {
    const auto n = static_cast<Index>(matrix.faces());
    VectorXd out = VectorXd::Zero(n);
    const VectorXd sums = factors_ * VectorXd::Ones(n);
    if (sees_out_)
        out = (1 - sums.array()).max(0);
    else
        factors_ = sums.cwiseInverse().asDiagonal() * factors_;
    const VectorXd irradiation = responses_to(factors_ * laws_.emitted + laws_.surroundings * out);
    radiosity_ = laws_.emitted + laws_.reflected.cwiseProduct(irradiation);
    areas_ = Eigen::Map<const VectorXd>(matrix.areas.data(), n) * scale * scale;
    power_ = areas_.cwiseProduct(radiosity_ - irradiation);
    absorbing_ = areas_.cwiseProduct((1 - laws_.reflected.array()).matrix());
    find_contrasts();
}

double Sensitivity::throughput() const {
    return power_.cwiseMax(0).sum() + std::max(0.0, -power_.sum());
}

double Sensitivity::largest_difference() const {
    const double among_faces = radiosity_.maxCoeff() - radiosity_.minCoeff();
    if (!sees_out_) return among_faces;
    return std::max(
        {among_faces, radiosity_.maxCoeff() - laws_.surroundings, laws_.surroundings - radiosity_.minCoeff()});
}

VectorXd Sensitivity::widths(const std::vector<double>& half_widths) const {
    VectorXd of_rows = VectorXd::Zero(areas_.size());
    for (std::size_t p = 0; p < half_widths.size(); ++p) {
        const auto [from, to] = ends(p);
        of_rows[from] += half_widths[p] * contrasts_[p].first;
        if (from != to) of_rows[to] += half_widths[p] * contrasts_[p].second;
    }
    return absorbing_.cwiseProduct(responses_to(of_rows));
}

VectorXd Sensitivity::irradiation_widths(const std::vector<double>& bounds, const std::vector<double>& missed) const {
    const auto rows = form_factors::by_face(matrix_.exchanges, matrix_.faces());
    VectorXd of_rows = VectorXd::Zero(areas_.size());
    for (std::size_t face = 0; face < rows.size(); ++face) {
        // What an error takes from one face goes to the surroundings, or by the balance to others.
        double weights = 0;
        double sum = 0;
        for (const std::uint32_t p : rows[face]) {
            const double weight = std::pow(form_factors::half_width(matrix_.exchanges[p]), 2);
            weights += weight;
            sum += weight * radiosity_[other_end(p, face)];
        }
        const double instead = sees_out_ || weights == 0 ? laws_.surroundings : sum / weights;
        double most = 0;
        double all = 0;
        for (const std::uint32_t p : rows[face]) {
            const double contrast = std::abs(radiosity_[other_end(p, face)] - instead) / matrix_.areas[face];
            all += bounds[p] * contrast;
            most = std::max(most, missed[p] * contrast);
        }
        of_rows[static_cast<Index>(face)] = all + most;
    }
    return responses_to(of_rows);
}

std::vector<double> Sensitivity::importance(const VectorXd& weights) const {
    const auto adjoint = [&](const VectorXd& x) -> VectorXd {
        return x - laws_.reflected.cwiseProduct(factors_.transpose() * x);
    };
    const VectorXd wanted = weights.cwiseProduct(absorbing_);
    const VectorXd of_rows = solved(adjoint, wanted, VectorXd::Zero(wanted.size()), fine);
    std::vector<double> result;
    for (std::size_t p = 0; p < contrasts_.size(); ++p) {
        const auto [from, to] = ends(p);
        const double one_way = of_rows[from] * contrasts_[p].first;
        result.push_back(std::max(0.0, from == to ? one_way : one_way + of_rows[to] * contrasts_[p].second));
    }
    return result;
}

VectorXd Sensitivity::responses_to(const VectorXd& known) const {
    return with_reflections(factors_, laws_, known, VectorXd::Zero(known.size()), fine);
}

std::pair<Index, Index> Sensitivity::ends(std::size_t p) const {
    return {matrix_.exchanges[p].from, matrix_.exchanges[p].to};
}

Index Sensitivity::other_end(std::size_t p, std::size_t face) const {
    const form_factors::FaceExchange& pair = matrix_.exchanges[p];
    return pair.from == face ? pair.to : pair.from;
}

/// The value that errors of a row are weighed against: the median of its radiosities, weighted by half widths.
double Sensitivity::median(const std::vector<std::uint32_t>& row, std::size_t face) const {
    std::vector<std::pair<double, double>> values;
    for (const std::uint32_t p : row)
        values.emplace_back(radiosity_[other_end(p, face)], form_factors::half_width(matrix_.exchanges[p]));
    const form_factors::RowSum& sum = matrix_.rows[face];
    if (sees_out_) values.emplace_back(laws_.surroundings, (sum.high - sum.low) / 2 * matrix_.areas[face]);
    std::sort(values.begin(), values.end());
    double all = 0;
    for (const auto& value : values) all += value.second;
    double below = 0;
    for (const auto& value : values) {
        below += value.second;
        if (below >= all / 2) return value.first;
    }
    return 0;
}

void Sensitivity::find_contrasts() {
    if (!is_known()) return;
    const auto rows = form_factors::by_face(matrix_.exchanges, matrix_.faces());
    contrasts_.resize(matrix_.exchanges.size());
    for (std::size_t face = 0; face < rows.size(); ++face) {
        const double middle = median(rows[face], face);
        for (const std::uint32_t p : rows[face]) {
            const form_factors::FaceExchange& pair = matrix_.exchanges[p];
            const auto contrast_to = [&](std::uint32_t other) {
                return std::abs(radiosity_[other] - middle) / matrix_.areas[face];
            };
            if (pair.from == face) contrasts_[p].first = contrast_to(pair.to);
            if (pair.to == face) contrasts_[p].second = contrast_to(pair.from);
        }
    }
}

}  // namespace ff::studies::heat
