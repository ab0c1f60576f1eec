#pragma once

#include "core/geometry/subdivision.hpp"
#include "stats/means/mean_test.hpp"
#include "studies/spec/spec.hpp"

#include <compare>
#include <cstddef>
#include <cstdint>
#include <optional>

namespace ff::studies {

/// The kind of quantity in a row of results.
enum class QuantityKind { form_factor, row_sum, sum_relative_error };

/// A quantity with one value per trial of a cell. Faces count from 1; 0 for none.
struct Quantity {
    QuantityKind kind = QuantityKind::form_factor;
    int from = 0;
    int to = 0;
    auto operator<=>(const Quantity&) const = default;
};

/// Whether the estimates of a quantity have a variance, known from theory.
enum class VarianceStatus {
    finite,
    infinite,
    none,       ///< deterministic
    sparse,     ///< finite, but with too few hits in all trials together for t or chi-squared to hold
    undefined,  ///< some trial gave infinity or no number at all: there is no statistic
};

/// The theory of a quantity's variance. With the area kernel, a pair of faces has none when any two of its patches
/// touch such that the kernel's tail index is 2 or less (core/estimators/graded_map); a sum has none when one of its
/// terms has none.
VarianceStatus known_variance(const Method& method, const Scene& scene, Quantity quantity);

/// Whether a counted quantity has too few hits, or misses, in all trials together for Student's t to hold.
/// @param lattice  1 / rays of a trial; empty where nothing is counted
bool too_few_hits(std::optional<double> lattice, std::optional<double> reference, std::size_t trials);

/// The limits of a trial's estimate that theory knows, for the rule for means (stats/means/mean_test.hpp). How much one
/// part can move it: the largest value of an evaluation over the number of independent ones; infinite where values have
/// no known bound, and for quantities other than form factors. What the evaluations of all trials may have missed:
/// shadows, edges and peaks, for form factors.
/// @param evaluations  of a trial, for a face or for a pair of faces
stats::KnownLimits known_limits(const Method& method, const Scene& scene, Subdivision subdivision, Quantity quantity,
                                std::uint64_t evaluations, std::size_t trials);

/// How far an unbiased method may differ from a reference because of rounding in both: estimates and factors about 1
/// are right to 1e-15, exchange areas to 1e-18 of the squared extent (core/exact/exact.hpp).
double rounding_of_bias(const Scene& scene, Quantity quantity);

/// Whether a trial's hits are those of independent rays. From one undivided surface they are binomial; from patches
/// they vary less than that, so that binomial tests and intervals hold all the same [hoeffding1956].
bool has_independent_hits(const Method& method, Quantity quantity);
/// Whether the rays of a face start from one undivided surface.
bool starts_anywhere(const Scene& scene, Subdivision subdivision, Quantity quantity);

}  // namespace ff::studies
