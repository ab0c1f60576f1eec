#include "stats/goodness_of_fit/chi_squared.hpp"

#include "core/support/contract.hpp"
#include "stats/basics/distributions.hpp"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <vector>

namespace ff::stats {
namespace {

ChiSquared judged(double statistic, std::size_t freedom) {
    return {.statistic = statistic, .freedom = freedom, .p = chi_squared_tail(statistic, static_cast<double>(freedom))};
}

struct Cell {
    double expected = 0;
    double observed = 0;
};

/// Merges ascending cells until each expects enough.
std::vector<Cell> pool_smallest(std::vector<Cell> cells) {
    constexpr double enough = 5;
    std::sort(cells.begin(), cells.end(), [](const Cell& a, const Cell& b) { return a.expected < b.expected; });
    std::vector<Cell> pooled;
    Cell open;
    for (const Cell& cell : cells) {
        open.expected += cell.expected;
        open.observed += cell.observed;
        if (open.expected >= enough) {
            pooled.push_back(open);
            open = {};
        }
    }
    if (open.expected > 0 && !pooled.empty()) {
        pooled.back().expected += open.expected;
        pooled.back().observed += open.observed;
    }
    return pooled;
}

}  // namespace

std::optional<QuadraticForm> combine_deviations(std::span<const double> deviations, const Eigen::MatrixXd& covariance,
                                                double tolerance) {
    const auto n = static_cast<Eigen::Index>(deviations.size());
    FF_EXPECT(covariance.rows() == n && covariance.cols() == n);

    std::vector<Eigen::Index> random;
    double outside = 0;
    for (Eigen::Index i = 0; i < n; ++i) {
        if (covariance(i, i) > 0) {
            random.push_back(i);
        } else {
            outside = std::max(outside, std::abs(deviations[static_cast<std::size_t>(i)]));
        }
    }
    if (random.empty()) return std::nullopt;

    const Eigen::VectorXd sd = covariance.diagonal()(random).cwiseSqrt();
    const Eigen::VectorXd all = Eigen::Map<const Eigen::VectorXd>(deviations.data(), n);
    const Eigen::VectorXd scores = all(random).cwiseQuotient(sd);
    const Eigen::MatrixXd scale = sd.cwiseInverse().asDiagonal();
    const Eigen::MatrixXd correlation = scale * covariance(random, random) * scale;
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(correlation);

    double statistic = 0;
    std::size_t rank = 0;
    Eigen::VectorXd unexplained = Eigen::VectorXd::Zero(scores.size());
    Eigen::MatrixXd inverse = Eigen::MatrixXd::Zero(scores.size(), scores.size());
    for (Eigen::Index i = 0; i < scores.size(); ++i) {
        const Eigen::VectorXd direction = eigen.eigenvectors().col(i);
        const double component = direction.dot(scores);
        if (eigen.eigenvalues()(i) > tolerance) {
            statistic += component * component / eigen.eigenvalues()(i);
            inverse += direction * direction.transpose() / eigen.eigenvalues()(i);
            ++rank;
        } else {
            unexplained += component * direction;
        }
    }
    outside = std::max(outside, unexplained.cwiseProduct(sd).cwiseAbs().maxCoeff());
    QuadraticForm form{
        .chi_squared = judged(statistic, rank), .outside = outside, .inverse = Eigen::MatrixXd::Zero(n, n)};
    form.inverse(random, random) = scale * inverse * scale;
    return form;
}

std::optional<GoodnessOfFit> test_goodness_of_fit(std::span<const std::uint64_t> counts,
                                                  std::span<const double> probabilities) {
    FF_EXPECT(counts.size() == probabilities.size());
    FF_EXPECT(std::abs(std::accumulate(probabilities.begin(), probabilities.end(), -1.0)) < 1e-9);
    const double total = static_cast<double>(std::accumulate(counts.begin(), counts.end(), std::uint64_t{0}));

    GoodnessOfFit test;
    std::vector<Cell> cells;
    for (std::size_t i = 0; i < counts.size(); ++i) {
        if (probabilities[i] > 0) cells.push_back({total * probabilities[i], static_cast<double>(counts[i])});
        test.impossible = test.impossible || (probabilities[i] == 0 && counts[i] > 0);
    }
    cells = pool_smallest(std::move(cells));
    test.cells = cells.size();
    if (test.impossible) {
        test.chi_squared = {.statistic = std::numeric_limits<double>::infinity(),
                            .freedom = std::max<std::size_t>(cells.size(), 1) - 1,
                            .p = 0};
        return test;
    }
    if (cells.size() < 2) return std::nullopt;
    double statistic = 0;
    for (const Cell& cell : cells) {
        const double difference = cell.observed - cell.expected;
        statistic += difference * difference / cell.expected;
    }
    test.chi_squared = judged(statistic, cells.size() - 1);
    return test;
}

}  // namespace ff::stats
