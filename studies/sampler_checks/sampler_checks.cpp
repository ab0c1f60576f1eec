#include "studies/sampler_checks/sampler_checks.hpp"

#include "core/support/error.hpp"
#include "samplers/point_sets/draw_set.hpp"
#include "samplers/point_sets/net_parameter.hpp"
#include "stats/basics/moments.hpp"
#include "stats/dependence/correlation.hpp"
#include "stats/error_rates/multiplicity.hpp"
#include "stats/error_rates/power.hpp"
#include "stats/goodness_of_fit/chi_squared.hpp"
#include "stats/means/mean_test.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <functional>
#include <memory>

namespace ff::studies {
namespace {

using samplers::SamplerInfo;

// Effects that must not be missed.
constexpr double worst_deviation = 0.1;    // relative deviation of cells' probabilities, root mean square
constexpr double worst_bias = 0.03;        // bias of an integral
constexpr double worst_correlation = 0.5;  // correlation of successive trials

constexpr double rounding_of_means = 1e-9;  // rounding of coordinates to 32 bits, and of sums

SamplerCheck same_bits(const samplers::CatalogueEntry& sampler, const samplers::PointSetSpec& spec, StreamKey key) {
    const auto once = sampler.make(spec);
    const auto again = sampler.make(spec);
    for (std::uint32_t trial = 0; trial < 3; ++trial) {
        const Stream stream{.key = key, .trial = trial};
        const auto whole = samplers::coordinates_of_set(*once, spec.dimension, stream);
        for (const std::size_t part : {std::size_t{1000}, std::size_t{37}, std::size_t{1}}) {
            if (whole.size() > 1u << 16 && part == 1) continue;
            const auto other = samplers::coordinates_of_set(*again, spec.dimension, stream, part);
            const auto [a, b] = std::mismatch(whole.begin(), whole.end(), other.begin());
            if (a == whole.end()) continue;
            const auto at = static_cast<std::uint64_t>(a - whole.begin());
            return {"same bits for the same seed", SamplerVerdict::fail,
                    fmt::format("trial {}, point {}, coordinate {}: {} and, asked again {} at a time, {}", trial,
                                at % spec.points, at / spec.points, *a * 0x1p-32, part, *b * 0x1p-32)};
        }
    }
    return {"same bits for the same seed", SamplerVerdict::pass,
            "3 trials, asked for in parts of 1024, 1000, 37 and 1"};
}

/// Checks the promise of `Sizes`: points stratified on every axis, or in the cells of a grid.
std::optional<SamplerCheck> keeps_sizes(const samplers::CatalogueEntry& sampler, const samplers::PointSetSpec& spec,
                                        StreamKey key) {
    const SamplerInfo& info = sampler.info;
    const bool powers = info.sizes == samplers::Sizes::powers && info.multiple == 1;
    if (!powers || !samplers::check_size(info, spec.points, spec.dimension).message.empty()) return std::nullopt;
    const auto source = sampler.make(spec);
    samplers::PointSet set{spec.points, 1, 1, {}};
    for (std::uint32_t trial = 0; trial < 10; ++trial) {
        const auto rows = samplers::coordinates_of_set(*source, spec.dimension, {.key = key, .trial = trial});
        for (std::size_t d = 0; d < spec.dimension; ++d) {
            const auto begin = rows.begin() + static_cast<std::ptrdiff_t>(d * spec.points);
            set.coordinate.assign(begin, begin + static_cast<std::ptrdiff_t>(spec.points));
            if (samplers::net_parameter(set, 0, info.base) == 0u) continue;
            return SamplerCheck{"what its sizes promise", SamplerVerdict::fail,
                                fmt::format("trial {}: coordinate {} has not one point in each of {} intervals", trial,
                                            d, spec.points)};
        }
    }
    return SamplerCheck{"what its sizes promise", SamplerVerdict::pass,
                        fmt::format("one point in each of {} intervals of every axis, in 10 trials", spec.points)};
}

/// A test with its p-value, and the effect that it finds with the power asked for.
struct Tested {
    std::string name;
    double p = 1;
    double detectable = 0;
    double worst = 0;  ///< effect that must not be missed
    std::string what;
    std::string sharper = "take more trials";  ///< how to detect less
    std::optional<double> effect = {};         ///< effect that was measured, where it is one number
};

Tested equally_likely(std::string name, const std::vector<std::uint64_t>& counts, std::uint64_t draws,
                      stats::Risks risks) {
    const std::vector<double> probabilities(counts.size(), 1.0 / static_cast<double>(counts.size()));
    const auto fit = stats::test_goodness_of_fit(counts, probabilities);
    return {std::move(name), fit ? fit->chi_squared.p : 1.0,
            fit && fit->cells == counts.size() ? stats::detectable_deviation(counts.size(), draws, risks) : 1.0,
            worst_deviation, "uneven by"};
}

/// Whether means differ by no more than the rounding of coordinates to 32 bits leaves of one value.
bool is_constant(const std::vector<double>& means) {
    const auto [least, most] = std::ranges::minmax_element(means);
    return *most - *least <= rounding_of_means;
}

/// Means of values in [0, largest] that should be 1, and are all v. If their expectation is 1, each is v with a
/// probability of at most (largest - 1) / (largest - v), or 1 / v; all are one such value with at most its power of
/// trials - 1, the first being free. Where they are right, a share s of trials may differ from them, which none has met
/// with probability (1 - s)^trials, and be a bias of at most s or s (largest - 1).
Tested constant_mean(std::string name, const std::vector<double>& means, double largest, stats::Risks risks) {
    const double v = means.front();
    const auto trials = static_cast<double>(means.size());
    Tested test{std::move(name), 1, 1, worst_bias, "biased by", "take more trials or points"};
    if (std::abs(v - 1) > rounding_of_means) {
        test.effect = v - 1;
        test.p = std::pow(v < 1 ? (largest - 1) / (largest - v) : 1 / v, trials - 1);
    } else {
        test.detectable = std::max(1.0, largest - 1) * (1 - std::pow(1 - risks.power, 1 / trials));
    }
    return test;
}

Tested unbiased_mean(std::string name, const std::vector<double>& means, double largest, stats::Risks risks) {
    if (is_constant(means)) return constant_mean(std::move(name), means, largest, risks);
    const double sigma = stats::moments_of(means, 1.0).standard_deviation().value_or(0);
    const auto mean = stats::mean_evidence(means, 1.0);
    return {std::move(name),
            mean ? stats::test_mean(*mean).p : 1.0,
            mean ? stats::minimum_detectable_bias(sigma, means.size(), risks) : 1.0,
            worst_bias,
            "biased by",
            "take more trials or points",
            mean ? std::optional(mean->difference) : std::nullopt};
}

Tested independent_trials(std::string name, const std::vector<double>& means, stats::Risks risks) {
    const auto serial = stats::test_serial_correlation(means);
    // The p-value is from two tests, each with half of alpha. The standard error of a correlation is 1 / sqrt(n).
    const stats::Risks half{risks.alpha / 2, risks.power};
    return {std::move(name), serial ? serial->p : 1.0,
            serial ? stats::minimum_detectable_bias(1, means.size(), half) : 1.0, worst_correlation, "correlated by"};
}

/// @param not_asked  receives the checks that have no data
std::vector<Tested> test_all(const DrawnTrials& drawn, std::size_t dimension, stats::Risks risks,
                             std::vector<std::string>& not_asked) {
    std::vector<Tested> tests;
    const std::uint64_t draws = drawn.picked.size();
    for (std::size_t a = 0; a < dimension; ++a) {
        std::vector<std::uint64_t> counts(16, 0);
        for (const auto& point : drawn.picked) ++counts[point[a] >> 28];
        tests.push_back(equally_likely(fmt::format("coordinate {} uniform", a), counts, draws, risks));
    }
    for (std::size_t a = 0; a < dimension; ++a) {
        for (std::size_t b = a + 1; b < dimension; ++b) {
            std::vector<std::uint64_t> counts(16, 0);
            for (const auto& point : drawn.picked) ++counts[(point[a] >> 30) * 4 + (point[b] >> 30)];
            tests.push_back(equally_likely(fmt::format("coordinates {} and {} uniform", a, b), counts, draws, risks));
        }
    }
    bool any_varies = false;
    for (std::size_t f = 0; f < integrand_names.size(); ++f) {
        const auto& means = drawn.means[f];
        tests.push_back(unbiased_mean(fmt::format("mean of {}", integrand_names[f]), means, drawn.largest[f], risks));
        std::string independent = fmt::format("trials independent, {}", integrand_names[f]);
        if (is_constant(means)) {
            not_asked.push_back(std::move(independent) + ": its mean is the same in all of them");
        } else {
            tests.push_back(independent_trials(std::move(independent), means, risks));
            any_varies = true;
        }
    }
    if (!any_varies)
        tests.push_back({"trials independent", 1, 1, worst_correlation, "correlated by",
                         "take more trials or points, so that means differ"});
    return tests;
}

std::uint32_t base_of(const SamplerInfo& info, std::uint64_t points) {
    return base_of_structure(points, info.sizes == samplers::Sizes::powers ? info.base : 0);
}

void expect_possible(const SamplerCheckRequest& request, std::uint32_t base) {
    for (const Promise& promise : request.promises) {
        const std::string why = why_impossible(promise, request.points, request.dimension, base);
        if (!why.empty()) throw UserError("--promises {} ({}). Change --n.", name_of(promise), why);
    }
}

SamplerCheck keeps_promise(const Promise& promise, const StructureEvidence& evidence) {
    const std::string name = "promise: " + name_of(promise);
    for (std::uint64_t set = 0; set < evidence.drawn.sets; ++set) {
        if (const auto where = broken_by(promise, evidence.drawn, set, evidence.base))
            return {name, SamplerVerdict::fail, fmt::format("trial {}, {}", set, *where)};
    }
    return {name, SamplerVerdict::pass,
            fmt::format("{} set{} keep{} it", evidence.drawn.sets, evidence.drawn.sets == 1 ? "" : "s",
                        evidence.drawn.sets == 1 ? "s" : "")};
}

/// Checks promises, or describes what the sets look like.
void add_structure(const SamplerCheckRequest& request, const StructureEvidence& evidence, SamplerChecks& result) {
    result.sets = evidence.drawn.sets;
    const auto add = [&](std::vector<SamplerCheck> checks) {
        std::move(checks.begin(), checks.end(), std::back_inserter(result.checks));
    };
    std::vector<Promise> kept;
    for (const Promise& promise : request.promises) {
        result.checks.push_back(keeps_promise(promise, evidence));
        if (result.checks.back().verdict == SamplerVerdict::pass) kept.push_back(promise);
    }
    add(doubt_values(evidence, kept));
    if (!request.promises.empty()) return;
    add(doubt_structure(evidence));
    add(describe(evidence));
}

/// Trials that take about a second, limited to those available.
std::uint64_t usual_trials(const SamplerInfo& info, std::uint64_t points) {
    const std::uint64_t affordable = std::clamp<std::uint64_t>((std::uint64_t{1} << 25) / points, 1000, 20000);
    return info.most_trials == 0 ? affordable : std::min(affordable, info.most_trials);
}

}  // namespace

SamplerChecks check_sampler(const samplers::CatalogueEntry& sampler, const SamplerCheckRequest& request) {
    const SamplerInfo& info = sampler.info;
    if (!info.equal_weights)
        throw UserError("{} (its points have weights: a rule, not a sampler). Run a study with it.", info.name);
    const StreamKey key =
        derive_key(Seed{request.seed}, fmt::format("check-sampler|{}|n={}", info.name, request.points));
    const samplers::PointSetSpec spec{.points = request.points, .dimension = request.dimension, .key = key};
    const auto source = sampler.make(spec);
    SamplerChecks result;
    result.trials = request.trials == 0 ? usual_trials(info, request.points) : request.trials;
    if (info.most_trials != 0 && result.trials > info.most_trials)
        throw UserError("--trials {} ({} has {}). Take fewer.", result.trials, info.name, info.most_trials);
    const std::uint32_t base = base_of(info, request.points);
    expect_possible(request, base);
    result.checks.push_back(same_bits(sampler, spec, key));
    if (auto check = keeps_sizes(sampler, spec, key)) {
        result.checks.push_back(std::move(*check));
    } else {
        result.not_asked.emplace_back("what its sizes promise: this size promises nothing");
    }
    StructureEvidence structure = draw_structure(*source, request.dimension, key, result.trials, base);
    if (!source->randomised()) {
        add_structure(request, structure, result);
        result.not_asked.emplace_back("uniform points, unbiased means, independent trials: it is not randomised");
        return result;
    }
    const DrawnTrials drawn = draw_trials(*source, request.dimension, key, result.trials);
    result.checks.push_back(check_repeated_sets(drawn.fingerprints));
    const std::size_t family = request.dimension * (request.dimension + 1) / 2 + 2 * integrand_names.size();
    const stats::Risks risks{stats::bonferroni_level(request.alpha, family), request.power};
    const auto tests = test_all(drawn, request.dimension, risks, result.not_asked);
    std::vector<double> p;
    std::transform(tests.begin(), tests.end(), std::back_inserter(p), [](const Tested& test) { return test.p; });
    const auto adjusted = stats::holm(p);
    for (std::size_t i = 0; i < tests.size(); ++i) {
        const Tested& test = tests[i];
        const bool failed = adjusted[i] <= request.alpha;
        const bool sharp = test.detectable <= test.worst;
        result.checks.push_back(
            {test.name,
             failed  ? SamplerVerdict::fail
             : sharp ? SamplerVerdict::pass
                     : SamplerVerdict::inconclusive,
             failed ? fmt::format("{}p = {:.2g} after Holm",
                                  test.effect ? fmt::format("{} {:.2g}, ", test.what, *test.effect) : "", adjusted[i])
                    : fmt::format("would be detected if {} {:.2g}{}", test.what, test.detectable,
                                  sharp ? "" : fmt::format("; {} is required, {}", test.worst, test.sharper))});
    }
    structure.slices = drawn.slices;
    add_structure(request, structure, result);
    return result;
}

}  // namespace ff::studies
