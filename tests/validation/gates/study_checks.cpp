#include "tests/validation/gates/study_checks.hpp"

#include "stats/error_rates/multiplicity.hpp"
#include "stats/means/mean_test.hpp"
#include "stats/variances/tails.hpp"
#include "tests/validation/gates/made_up_files.hpp"
#include "tests/validation/rates/bench.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace ff::studies::gates {
namespace {

constexpr std::size_t means = 30;
constexpr double study_alpha = 0.05;

/// Whether the interval of a pair's bias leaves 0 out.
bool seems_biased(const std::vector<double>& trials, double truth, double largest_part) {
    const auto mean = stats::mean_evidence(trials, truth, {.largest_part = largest_part, .unmet = {}});
    return mean && !stats::interval_of(*mean, 1 - stats::sidak_level(study_alpha, means)).contains(0);
}

/// Whether some pair of a study is called biased: it seems so, and its tails are not in doubt.
bool some_is_called_biased(const Law& law, std::size_t trials, double largest_part, stats::Draws& draws) {
    stats::PooledTails pooled;
    bool some = false;
    const bool bounded = std::isfinite(largest_part);
    for (std::size_t pair = 0; pair < means; ++pair) {
        const auto values = draw_file(law, trials, draws);
        if (!bounded) pooled.add(values);
        some = some || (seems_biased(values, law.mean, largest_part) && (bounded || !stats::doubt_tails(values)));
    }
    return some && !pooled.doubt();
}

/// Normal, and larger by `size` standard deviations once in `rarity` trials.
Law jumping_law(double size, double rarity) {
    return {fmt::format("normal, {:g} σ larger once in {:g} trials", size, rarity), size / rarity,
            [size, rarity](stats::Draws& draws) {
                const double jump = draws.uniform() * rarity < 1 ? size : 0;
                return draw_normal(draws) + jump;
            }};
}

/// Shares of 64 rays that hit with this probability.
Law hits_law(double probability) {
    return {fmt::format("hits of 64 rays, probability {:g}", probability), probability,
            [probability](stats::Draws& draws) {
                double hits = 0;
                for (int ray = 0; ray < 64; ++ray) hits += draws.uniform() < probability ? 1 : 0;
                return hits / 64;
            }};
}

RateTable measure_false_findings(const Repetitions& repetitions, std::uint64_t times) {
    RateTable table{.title = "Studies of skewed trials",
                    .text =
                        "Studies of 30 means without bias, at a family-wise 5 %: in how many some mean is called "
                        "biased. The last laws are outside what is promised: their large values are rarer than one in "
                        "so few trials, or have no variance. *Student* is what Student's t would do.",
                    .rates = {}};
    const Bench bench{repetitions, times, table};
    const auto add = [&](const Law& law, std::size_t trials, RateClaim claim, double part, const char* rule) {
        bench.add(
            fmt::format("{}: {}, {} trials", rule, law.name, trials), claim, study_alpha,
            [&law, trials, part](stats::Draws& draws) { return some_is_called_biased(law, trials, part, draws); });
    };
    const std::vector<std::size_t> numbers{10, 20, 30, 50, 100, 200, 400};
    for (const Law& law : {normal_law(), gamma_law(), exponential_law(), log_normal_law(0.3), log_normal_law(0.7),
                           log_normal_law(1), pareto_law(5), pareto_law(3)}) {
        for (const std::size_t trials : numbers) add(law, trials, RateClaim::at_most, stats::unknown_parts, "biased");
    }
    for (const double probability : {0.2, 0.02}) {
        for (const std::size_t trials : {50u, 200u})
            add(hits_law(probability), trials, RateClaim::at_most, 1.0 / 64, "biased, bounds known");
    }
    for (const std::size_t trials : {10u, 50u, 200u})
        add(log_normal_law(0.7), trials, RateClaim::none, stats::no_part, "Student");
    for (const Law& law : {jumping_law(10, 33), pareto_law(1.5), jumping_law(1000, 1000)}) {
        for (const std::size_t trials : {30u, 100u, 400u})
            add(law, trials, RateClaim::none, stats::unknown_parts, "biased");
    }
    return table;
}

RateTable measure_power_of_studies(const Repetitions& repetitions, std::uint64_t times) {
    RateTable table{.title = "Power of studies",
                    .text =
                        "A bias of so many standard errors of the mean on one of 30 pairs, in normal trials: how often "
                        "that pair is called biased. *Student* is what Student's t would do.",
                    .rates = {}};
    const Bench bench{repetitions, times, table};
    for (const std::size_t trials : {20u, 30u, 50u, 100u, 400u}) {
        for (const double errors : {1.0, 2.0, 5.0, 8.0}) {
            const double bias = errors / std::sqrt(static_cast<double>(trials));
            for (const double part : {stats::unknown_parts, stats::no_part}) {
                const bool ours = part == stats::unknown_parts;
                const bool promised = ours && errors == 8 && trials >= 30;
                bench.add(
                    fmt::format("{}: {:g} standard errors, {} trials", ours ? "biased" : "Student", errors, trials),
                    promised ? RateClaim::at_least : RateClaim::none, trials == 30 ? 0.8 : 0.95,
                    [trials, bias, part](stats::Draws& draws) {
                        return seems_biased(draw_file(normal_law(), trials, draws), -bias, part);
                    });
            }
        }
    }
    return table;
}

}  // namespace

std::vector<RateTable> measure_study_checks(const Repetitions& repetitions, std::uint64_t times) {
    return {measure_false_findings(repetitions, std::max<std::uint64_t>(times / 20, 1)),
            measure_power_of_studies(repetitions, std::max<std::uint64_t>(times / 4, 1))};
}

}  // namespace ff::studies::gates
