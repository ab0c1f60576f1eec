#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace ff::studies::gates {

/// A continuous distribution with given parameters.
struct KnownLaw {
    enum class Family { uniform, normal, exponential } family = Family::uniform;
    double first = 0;   ///< low end, mean, mean
    double second = 1;  ///< high end, standard deviation, unused
};

/// P(X <= x).
double cumulative(const KnownLaw& law, double x);

/// Reads "normal(0, 1)", "uniform(0, 1)" or "exponential(1)"; sets `problem`, in the form "(why). Suggestion.", where
/// it is not one of these, or where parameters are missing: if they were fitted to the tested values, critical values
/// would change.
std::optional<KnownLaw> parse_law(std::string_view text, std::string& problem);

}  // namespace ff::studies::gates
