#pragma once

#include "core/exact/exchange_method.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace ff::studies::form_factors {

/// Randomisations of every estimate: enough that Student's interval with 15 degrees of freedom is hardly wider than
/// with many, and its coverage hardly suffers from skewed means.
inline constexpr std::size_t randomisations = 16;

/// Upper bound of the part of a mean that points may have missed, where p is the share of points that a set of places
/// may be entitled to and still get none: max(rough * p, smooth * p^power). For a quantity in [0, 1] that may jump
/// anywhere it is p.
struct UnmetBound {
    double rough = 1;
    double smooth = 0;
    double power = 1.5;

    [[nodiscard]] double at(double p) const;
};

/// The mean of a quantity over a surface, by independent randomisations of one point set.
struct SampledShare {
    std::vector<double> means;  ///< one for each randomisation
    std::uint64_t points = 0;   ///< number of points in all randomisations together
    UnmetBound unmet;
    bool hits = false;      ///< values are 0 or 1
    std::uint64_t met = 0;  ///< number of hits
};

/// Sums of shares with factors, as an estimate with an interval.
struct EstimatedSum {
    double value = 0;
    double down = 0;  ///< the interval is [value - down, value + up]
    double up = 0;
    double unmet = 0;  ///< part of both that no spread reveals

    [[nodiscard]] double half_width() const { return down > up ? down : up; }
};

/// offset + sum of scale * share; scales may be negative.
struct SampledSum {
    struct Term {
        double scale = 1;
        SampledShare share;
    };
    double offset = 0;
    std::vector<Term> terms;
    double offset_error = 0;  ///< bound of the error of `offset`
};

/// Clopper and Pearson's upper bound of a probability after this many points without a hit.
double none_of(std::uint64_t points, double level);

/// How much of a term all points may have missed.
double unmet_of(double scale, const SampledShare& share, double level);

/// A known sum with the mean of independent values added, with Student's interval, and with what may be missed.
EstimatedSum with_means(EstimatedSum known, const std::vector<double>& means, double unmet, double level);

/// A sum with its interval. Its terms add up, randomisation by randomisation, to independent values: Student's
/// interval. What no point has hit is added, as large as it may be in any one term (docs/statistics.md).
/// @pre all terms have the same number of randomisations
EstimatedSum estimate_of(const SampledSum& sum, double level);

/// The result of sampling for a pair of faces.
struct PairEstimate {
    std::optional<SampledSum> sum;  ///< the exchange area; empty where no round was completed, or none was needed
    ExchangeMethod method = ExchangeMethod::rays;  ///< cells, points or rays
    double level = 0;                              ///< confidence level of its interval
    std::uint64_t samples = 0;                     ///< rays or points behind it
    bool contradicted = false;
    EstimatedSum other;  ///< estimate from the independent randomisation that contradicts
};

/// The results for the pairs that are estimated from a row, the smaller of their faces. It does not
/// depend on other rows, so that processes can share rows out, and a run can be resumed.
struct SampledRow {
    std::uint32_t row = 0;                                          ///< its face
    std::vector<std::pair<std::uint32_t, PairEstimate>> estimates;  ///< each with the pair's place in FacePairs::pairs
    std::uint64_t samples = 0;
    std::uint64_t rays = 0;
    std::uint64_t lost = 0;  ///< rays that met nothing
};

/// The row as 64-bit words, for a file or another process of the same program.
std::vector<std::uint64_t> to_words(const SampledRow& row);

/// The row from which `to_words` made these; empty where they are not from it.
std::optional<SampledRow> sampled_row(std::span<const std::uint64_t> words);

}  // namespace ff::studies::form_factors
