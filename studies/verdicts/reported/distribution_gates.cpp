#include "studies/verdicts/reported/distribution_gates.hpp"

#include "stats/basics/quantiles.hpp"
#include "stats/goodness_of_fit/anderson_darling.hpp"
#include "stats/shares/count_distance.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>
#include <vector>

namespace ff::studies::gates {
namespace {

/// The largest distance up to `found` at which "no further than this" is rejected at `alpha`; 0 where none is.
template <class Statistic>
double lower_limit(const Statistic& statistic, double found, double alpha) {
    const auto rejects = [&](double tolerance) { return stats::anderson_darling_tail(statistic(tolerance)) < alpha; };
    if (!rejects(0)) return 0;
    double low = 0;
    double high = found;
    constexpr int halvings = 30;
    for (int i = 0; i < halvings; ++i) {
        const double middle = (low + high) / 2;
        (rejects(middle) ? low : high) = middle;
    }
    return low;
}

/// @param reach  how far empirical distributions are from the true ones, together, with a probability of 1 - alpha
template <class Statistic, class Reach>
Measurement measure(double distance, std::size_t n, const Statistic& statistic, const Reach& reach,
                    const Levels& levels) {
    const auto interval_at = [&](double alpha) {
        return stats::Interval{.low = lower_limit(statistic, distance, alpha),
                               .high = std::min(1.0, distance + reach(alpha)),
                               .level = 1 - 2 * alpha,
                               .method = "anderson_darling",
                               .n = n};
    };
    return {.value = distance,
            .passing = interval_at(levels.pass_alpha),
            .failing = interval_at(levels.fail_alpha / 2),
            .minimum_detectable = std::numeric_limits<double>::infinity()};
}

/// Half of the risk for each of two samples.
double dkw_reach(std::size_t n, double alpha, std::size_t samples) {
    return stats::dkw_half_width(n, 1 - alpha / static_cast<double>(samples));
}

std::vector<double> numbers_of_bins(const Gate& gate, const Bins& bins) {
    if (bins.runs != 1)
        refuse_gate(gate,
                    fmt::format("counts of {} runs (of several runs their sum is judged). Add them up for each bin.",
                                bins.runs));
    std::vector<double> numbers;
    numbers.reserve(bins.count());
    for (const ReportedRow& row : bins.rows) numbers.push_back(row.mean);
    return numbers;
}

double sum_of(const std::vector<double>& values) {
    return std::accumulate(values.begin(), values.end(), 0.0);
}

/// The bins that differ most, in standard errors; in words. Bins that were pooled are left out: a single event may be
/// many errors there. Empty where all were.
std::string worst_bins(const Bins& bins, const std::vector<double>& counts, const std::vector<double>& others,
                       bool are_shares) {
    const double n = sum_of(counts);
    const double m = sum_of(others);
    std::vector<std::pair<double, std::size_t>> scores;
    for (std::size_t i = 0; i < counts.size(); ++i) {
        const double share = are_shares ? others[i] : (counts[i] + others[i]) / (n + m);
        const double variance = share * (1 - share) * (are_shares ? 1 / n : 1 / n + 1 / m);
        const double difference = counts[i] / n - others[i] / m;
        const double expected = share * (are_shares ? n : std::min(n, m));
        if (variance > 0 && expected >= stats::least_expected) scores.emplace_back(difference / std::sqrt(variance), i);
    }
    constexpr std::size_t most = 3;
    const std::size_t shown = std::min(most, scores.size());
    std::partial_sort(scores.begin(), scores.begin() + static_cast<std::ptrdiff_t>(shown), scores.end(),
                      [](const auto& a, const auto& b) { return std::abs(a.first) > std::abs(b.first); });
    std::vector<std::string> words;
    for (std::size_t i = 0; i < shown; ++i)
        words.push_back(fmt::format("{} ({:+.3g} errors)", bins.name(scores[i].second), scores[i].first));
    return words.empty() ? "" : fmt::format("worst {}; ", fmt::join(words, ", "));
}

Measurement measure_counts(const stats::CountDistance& found, const Band& band, const Levels& levels) {
    const double noise = std::max(0.0, found.statistic - found.freedom);
    return measured_at(
        std::sqrt(noise / found.draws), levels, [&](double level) { return stats::distance_interval(found, level); },
        stats::detectable_distance(found, band.high, levels.fail_alpha, levels.power));
}

}  // namespace

Measurement measure_distribution(std::span<const double> values, const KnownLaw& law, const Levels& levels) {
    std::vector<double> uniform;
    uniform.reserve(values.size());
    for (const double value : values) uniform.push_back(cumulative(law, value));
    std::sort(uniform.begin(), uniform.end());
    return measure(
        stats::kolmogorov_distance(uniform), values.size(),
        [&](double tolerance) { return stats::anderson_darling(uniform, tolerance); },
        [&](double alpha) { return dkw_reach(values.size(), alpha, 1); }, levels);
}

Measurement measure_distributions(std::span<const double> first, std::span<const double> second, const Levels& levels) {
    const auto a = stats::sorted(first);
    const auto b = stats::sorted(second);
    return measure(
        stats::kolmogorov_distance(a, b), std::min(a.size(), b.size()),
        [&](double tolerance) { return stats::anderson_darling(a, b, tolerance); },
        [&](double alpha) { return dkw_reach(a.size(), alpha, 2) + dkw_reach(b.size(), alpha, 2); }, levels);
}

std::uint64_t values_for_distance(double band, const Levels& levels, std::size_t samples) {
    const double risk = 1 - levels.power;
    const double reach =
        static_cast<double>(samples) * (dkw_reach(1, levels.pass_alpha, samples) + dkw_reach(1, risk, samples));
    return static_cast<std::uint64_t>(std::ceil(reach * reach / (band * band)));
}

GateResult judge_counts(const Spec& spec, const Gate& gate, const Bins& bins, const Bins& against) {
    const bool are_shares = against.file->holds == Holds::shares;
    const auto counts = numbers_of_bins(gate, bins);
    auto others = numbers_of_bins(gate, against);
    if (sum_of(counts) == 0 || sum_of(others) == 0)
        refuse_gate(gate, fmt::format("no counts of '{}' (nothing would be compared). Run longer.", gate.quantity));
    if (are_shares) {
        const double whole = sum_of(others);
        constexpr double rounding = 1e-3;
        if (std::abs(whole - 1) > rounding)
            refuse_gate(gate,
                        fmt::format("the shares of '{}' in {} add up to {:.6g} (those of all bins are 1). Add the "
                                    "missing bins.",
                                    gate.quantity, against.file->origin, whole));
        for (double& share : others) share /= whole;
    }
    Comparison row;
    row.quantity = gate.quantity;
    row.band = gate.band;
    row.levels = levels_at_one_look(spec, 1);
    row.trials = static_cast<std::uint64_t>(sum_of(counts));
    row.unit = "event";
    const auto found =
        are_shares ? stats::count_distance(counts, others) : stats::count_distance_of_two(counts, others);
    // The interval fails by its lower end alone, at half of alpha, which its approximations do not always keep; a tenth
    // is enough for single bins.
    constexpr double of_bins = 0.1;
    const auto refuting =
        are_shares ? stats::refuting_bin(counts, others, row.band.high, row.levels.fail_alpha * of_bins) : std::nullopt;
    if (refuting && others[*refuting] == 0) {
        row.verdict = Verdict::fail;
        row.note = "there are counts in bins whose share is 0";
    } else if (refuting) {
        row.verdict = Verdict::fail;
        row.note = fmt::format("bin {} has a count of {:g} where {:.3g} are expected", bins.name(*refuting),
                               counts[*refuting], others[*refuting] * sum_of(counts));
    } else if (!found) {
        row.note = "fewer than two cells in which 5 are expected: run longer";
    } else {
        row.measurement = measure_counts(*found, row.band, row.levels);
        row.verdict = judge(row.measurement, row.band);
        row.note = fmt::format(
            "{} bins pooled to {:g} cells of 5 or more, G = {:.4g}, p = {:.2g} for no difference; {}takes counts for "
            "those of independent events",
            counts.size(), found->freedom + 1, found->statistic, stats::p_above(*found, 0),
            worst_bins(bins, counts, others, are_shares));
    }
    return result_of(gate, row);
}

}  // namespace ff::studies::gates
