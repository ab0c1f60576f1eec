#include "studies/analysis/bias.hpp"
#include "studies/trials/estimates.hpp"

#include <cmath>

namespace ff::studies {

double p_of_constant(double bias, std::optional<double> lattice, std::size_t trials) {
    const double error = std::abs(bias);
    if (error <= lattice.value_or(0.0) + rounding_error) return 1;
    const double steps = lattice ? std::floor(error / *lattice) : 1;
    return std::pow(1 / (steps + 1), static_cast<double>(trials - 1));
}

double p_of_any_constant(double value, double reference, double largest, std::size_t trials) {
    if (!std::isfinite(largest) || value == reference) return 1;
    const double others = value < reference ? (reference - value) / (largest - value) : (value - reference) / value;
    return std::pow(1 - others, static_cast<double>(trials - 1));
}

BiasFinding bias_finding(const BiasFamily& family, double level) {
    if (family.constant_and_wrong) return BiasFinding::biased;
    if (family.few_trials) return BiasFinding::untestable;
    const double alpha = 1.0 - level;
    if (family.adjusted_p < alpha) return BiasFinding::biased;
    if (family.student_p < alpha) return BiasFinding::inconclusive;
    return family.untestable == family.pairs ? BiasFinding::untestable : BiasFinding::no_bias_found;
}

EquivalenceFinding equivalence_finding(const BiasFamily& family, bool refuted) {
    if (!family.margin) return EquivalenceFinding::not_asked;
    if (refuted && !family.few_trials) return EquivalenceFinding::refuted;
    return family.untestable == 0 && family.shown_below < *family.margin ? EquivalenceFinding::shown
                                                                         : EquivalenceFinding::inconclusive;
}

}  // namespace ff::studies
