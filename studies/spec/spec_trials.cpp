#include "studies/spec/spec_trials.hpp"

#include "core/support/error.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace ff::studies {

void set_trials(StudySpec& spec, std::uint64_t trials) {
    if (trials == 0) throw UserError("--trials 0 (nothing would be run). Try 64.");
    if (trials == 1) throw UserError("--trials 1 (a confidence interval needs at least 2). Try 64.");
    if (trials > max_trials)
        throw UserError(fmt::format("--trials {} (at most {} trials are told apart). Take fewer.", trials, max_trials));
    for (Method& method : spec.methods) {
        for (Size& size : method.sizes) {
            if (!size.trials) continue;
            // ceil(own * trials / all), in two parts that fit 64 bits.
            const std::uint64_t whole = *size.trials / spec.trials * trials;
            const std::uint64_t part = (*size.trials % spec.trials * trials + spec.trials - 1) / spec.trials;
            size.trials = std::clamp<std::uint64_t>(whole + part, 2, max_trials);
        }
    }
    spec.trials = trials;
    const auto largest = std::max_element(spec.coverage.begin(), spec.coverage.end());
    if (largest != spec.coverage.end() && trials / 2 < *largest) {
        throw UserError(
            fmt::format("--trials {} (coverage is measured with groups of {} trials, two at least). Take {} or more.",
                        trials, *largest, 2 * *largest));
    }
    if (!spec.until) return;
    if (trials < fewest_pilot_trials) {
        throw UserError(fmt::format("--trials {} (the pilot of an adaptive study has at least {}). Take more.", trials,
                                    fewest_pilot_trials));
    }
    spec.until->pilot = std::min(spec.until->pilot, trials);
}

}  // namespace ff::studies
