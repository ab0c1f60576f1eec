#include "studies/analysis/configuration_estimates.hpp"

#include <cmath>
#include <utility>

namespace ff::studies {
namespace {

/// The statistics of a configuration's pair of faces; for the form factor of a face to itself, those of its factor to
/// another face.
const Summary& summary_of(const CellAnalysis& found, const Configuration& configuration) {
    const int to = configuration.from == configuration.to ? 1 - configuration.to : configuration.to;
    return found.summary({QuantityKind::form_factor, configuration.from + 1, to + 1});
}

std::optional<ConfigurationEstimate> estimate_of(const Scene& scene, const CellAnalysis& found,
                                                 const Configuration& configuration) {
    const Summary& summary = summary_of(found, configuration);
    if (!summary.mean || !summary.reference) return std::nullopt;
    // The form factor of a face to itself is 1 less those to the other faces, which are all equal.
    const int others = other_faces(scene, configuration);
    const double factor = others > 0 ? -others : 1;
    const double offset = others > 0 ? 1 : 0;
    ConfigurationEstimate estimate;
    estimate.configuration = &configuration;
    estimate.found = &found;
    estimate.mean = offset + factor * *summary.mean;
    estimate.exact = offset + factor * *summary.reference;
    estimate.bias = factor * summary.bias.value_or(0);
    estimate.error = std::abs(factor) * summary.bias_se.value_or(std::abs(summary.bias.value_or(0)));
    estimate.variance = summary.variance;
    if (summary.bias_interval) {
        stats::Interval interval = *summary.bias_interval;
        interval.low = estimate.exact + factor * summary.bias_interval->low;
        interval.high = estimate.exact + factor * summary.bias_interval->high;
        if (factor < 0) std::swap(interval.low, interval.high);
        estimate.interval = interval;
    }
    if (summary.bias_se && *summary.bias_se > 0) estimate.standard_errors = estimate.bias / estimate.error;
    return estimate;
}

}  // namespace

std::vector<ConfigurationEstimate> configuration_estimates(const Analysis& findings) {
    std::vector<ConfigurationEstimate> estimates;
    for (const Configuration& configuration : configurations()) {
        for (const CellAnalysis& found : findings.cells) {
            const Scene& scene = findings.plan.scenes[findings.plan.cells[found.cell].scene];
            if (!is_configuration(scene, configuration) || found.trials == 0) continue;
            if (auto estimate = estimate_of(scene, found, configuration)) estimates.push_back(*estimate);
        }
    }
    return estimates;
}

}  // namespace ff::studies
