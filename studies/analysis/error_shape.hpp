#pragma once

#include "studies/trials/estimates.hpp"

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace ff::studies {

/// The distribution of the errors of single runs, beside a normal one with the same mean and standard deviation.
struct ErrorShape {
    /// Runs with low <= error < high; the last bin includes its upper end.
    struct Bin {
        double low = 0;
        double high = 0;
        std::uint64_t runs = 0;
        double normal = 0;  ///< expected number of runs under a normal distribution
    };
    /// A quantile in standard deviations from the mean.
    struct QuantilePair {
        double normal = 0;
        double runs = 0;
    };

    Quantity quantity;
    double mean = 0;   ///< mean error
    double sigma = 0;  ///< their sample standard deviation
    double q25 = 0;
    double q75 = 0;
    std::vector<Bin> bins;
    std::vector<QuantilePair> quantiles;
};

/// Bins of equal width after Freedman and Diaconis, 8 to 40 of them; for values on a lattice, whole multiples of its
/// spacing, with edges halfway between possible values. Quantiles at (k - 1/2) / m, m = 41 or the number of runs if
/// smaller.
/// @param lattice  spacing of possible values
/// @return empty below 20 values, and for values that are all equal
std::optional<ErrorShape> error_shape(std::span<const double> values, double reference, std::optional<double> lattice);

}  // namespace ff::studies
