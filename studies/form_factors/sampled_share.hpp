#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace ff::studies {

/// Randomisations of every estimate: so many that Student's interval with 15 degrees of freedom is hardly wider than
/// with many, and its coverage hardly suffers from skewed means.
inline constexpr std::size_t randomisations = 16;

/// The mean of a quantity in [0, 1] (a hit or none; a form factor), by independent randomisations of one point set.
struct SampledShare {
    std::vector<double> means;  ///< one for each randomisation
    std::uint64_t points = 0;   ///< of all randomisations together
    std::uint64_t met = 0;      ///< points whose value is not 0
    bool hits = false;          ///< values are 0 or 1
};

/// Sums of shares with factors, as an estimate with an interval.
struct Estimate {
    double value = 0;
    double down = 0;  ///< the interval is [value - down, value + up]
    double up = 0;

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
};

/// A sum with its interval. Randomisation by randomisation its terms add up to independent values: Student's interval.
/// It would be too narrow for terms that have shown themselves at few points (or missed few, or whose means are all
/// equal, which is no evidence of precision): these add the width of Clopper and Pearson's interval of the points that
/// met anything. Points of a net meet small things no less regularly than independent ones.
/// @pre all terms have the same number of randomisations
Estimate estimate_of(const SampledSum& sum, double level);

/// Whether a share is too rare, or shows too little spread, for Student's interval.
bool is_rare(const SampledShare& share);

}  // namespace ff::studies
