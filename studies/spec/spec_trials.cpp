#include "studies/spec/spec.hpp"

#include "core/support/error.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace ff::studies {
namespace {

constexpr std::uint64_t max_trials = 1ULL << 32;  // a stream addresses trials with 32 bits

}  // namespace

std::string problem_with_trials(std::uint64_t trials) {
    if (trials == 0) return "(nothing would be run). Try 64.";
    if (trials == 1) return "(a confidence interval needs at least 2). Try 64.";
    return trials <= max_trials ? "" : fmt::format("(at most {} trials). Take fewer.", max_trials);
}

void set_trials(StudySpec& spec, std::uint64_t trials) {
    if (const auto problem = problem_with_trials(trials); !problem.empty())
        throw UserError(fmt::format("--trials {} {}", trials, problem));
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
