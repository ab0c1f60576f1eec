#pragma once

#include <cstddef>
#include <optional>
#include <span>

namespace ff::stats {

/// P-value of "these variables are independent of each other", against any correlation between them, however many they
/// are: by the sum of all squared correlation coefficients [schott2005], whose distribution is taken to be that of a
/// multiple of chi-squared with the same mean and variance. For normal values; no variance needs to be known. Takes
/// time proportional to the number of values times that of repetitions.
/// @param values  all repetitions of the first variable, then those of the next
/// @return empty with fewer than 4 repetitions, or fewer than 2 variables that vary
std::optional<double> p_of_independence(std::span<const double> values, std::size_t repetitions);

}  // namespace ff::stats
