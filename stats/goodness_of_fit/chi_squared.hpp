#pragma once

#include <Eigen/Core>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

namespace ff::stats {

struct ChiSquared {
    double statistic = 0;
    std::size_t freedom = 0;
    double p = 0;  ///< P(X >= statistic)
};

/// d' C^+ d for correlated deviations d with known covariance C. Degrees of freedom are C's rank, counted over
/// eigenvalues of its correlation matrix above `tolerance`; entries of zero variance are left out.
struct QuadraticForm {
    ChiSquared chi_squared;
    /// Largest |deviation| along directions in which C has no variance, in units of the deviations' own (0 where a
    /// linear relation such as closure holds). Anything above rounding contradicts C, whatever p says.
    double outside = 0;
    Eigen::MatrixXd inverse;  ///< C^+, 0 for entries of zero variance
};

/// Empty where C has rank 0. @pre C is square, symmetric and as large as `deviations`
std::optional<QuadraticForm> combine_deviations(std::span<const double> deviations, const Eigen::MatrixXd& covariance,
                                                double tolerance = 1e-9);

/// Pearson's goodness of fit of counts to probabilities. Cells are pooled, smallest expectation first, until every
/// expectation is at least 5. For the hits of one face it is the multinomial test of all its pairs.
struct GoodnessOfFit {
    ChiSquared chi_squared;
    std::size_t cells = 0;    ///< number of cells after pooling
    bool impossible = false;  ///< a count where the probability is 0; p is then 0
};

/// Empty where fewer than two cells remain. @pre as many counts as probabilities; these add up to 1
std::optional<GoodnessOfFit> test_goodness_of_fit(std::span<const std::uint64_t> counts,
                                                  std::span<const double> probabilities);

}  // namespace ff::stats
