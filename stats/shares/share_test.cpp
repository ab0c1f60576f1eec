#include "stats/shares/share_test.hpp"

#include "core/support/contract.hpp"
#include "stats/basics/distributions.hpp"

#include <algorithm>
#include <cmath>

namespace ff::stats {
namespace {

bool is_exact(const ShareReference& reference) {
    return !reference.counts && reference.standard_error == 0;
}

double tail_of_t(double t, double freedom) {
    return std::isinf(freedom) ? normal_tail(t) : student_tail(t, freedom);
}

double critical_t(double tail, double freedom) {
    return std::isinf(freedom) ? normal_critical(tail) : student_critical(freedom, tail);
}

/// P(a reference at most as large as the observed one) if its true value is `truth`. Falls with `truth`; no probability
/// is above 1.
double p_of_reference(const ShareReference& reference, double truth) {
    if (reference.counts) return truth >= 1 ? 0 : binomial_lower_p(*reference.counts, truth);
    return tail_of_t((truth - reference.value) / reference.standard_error, reference.freedom);
}

/// P(at least the hits seen) at a probability that may lie beyond its bounds.
double p_of_hits(Proportion counts, double probability) {
    if (probability < 0) return 0;
    return binomial_upper_p(counts, std::min(probability, 1.0));
}

Proportion misses(Proportion counts) {
    return {counts.trials - counts.hits, counts.trials};
}

/// The same comparison in terms of misses.
ShareReference misses(const ShareReference& reference) {
    ShareReference mirrored = reference;
    mirrored.value = 1 - reference.value;
    if (reference.counts) mirrored.counts = misses(*reference.counts);
    return mirrored;
}

}  // namespace

double p_of_at_most(Proportion counts, const ShareReference& reference, double difference) {
    if (is_exact(reference)) return p_of_hits(counts, reference.value + difference);
    // The tail of the hits grows with the true reference, that of the reference falls: they meet once.
    constexpr double far = 40;  // standard errors, beyond any level
    double low = reference.counts ? 0 : reference.value - far * reference.standard_error;
    double high = reference.counts ? 1 : reference.value + far * reference.standard_error;
    constexpr int halvings = 60;
    for (int i = 0; i < halvings; ++i) {
        const double middle = low + (high - low) / 2;
        const bool hits_lead = p_of_hits(counts, middle + difference) >= p_of_reference(reference, middle);
        (hits_lead ? high : low) = middle;
    }
    return std::min(1.0, 2 * p_of_hits(counts, high + difference));
}

double p_of_at_least(Proportion counts, const ShareReference& reference, double difference) {
    return p_of_at_most(misses(counts), misses(reference), -difference);
}

Interval reference_interval(const ShareReference& reference, double level) {
    if (reference.counts) return clopper_pearson_interval(*reference.counts, level);
    const double half = critical_t((1 - level) / 2, reference.freedom) * reference.standard_error;
    return interval_around(reference.value, half, level, "", 0);
}

Interval share_difference_interval(Proportion counts, const ShareReference& reference, double level) {
    const bool exact = is_exact(reference);
    const double each = exact ? level : 1 - (1 - level) / 2;
    const Interval own = clopper_pearson_interval(counts, each);
    const Interval other = exact ? Interval{.low = reference.value, .high = reference.value, .level = 1, .method = ""}
                                 : reference_interval(reference, each);
    return {.low = own.low - other.high,
            .high = own.high - other.low,
            .level = level,
            .method = exact ? "clopper_pearson" : "clopper_pearson_difference",
            .n = counts.trials};
}

double p_of_binomial_scatter(std::span<const Proportion> runs) {
    FF_EXPECT(!runs.empty());
    Proportion all;
    std::uint64_t fewest = runs.front().trials;
    for (const Proportion& run : runs) {
        all.hits += run.hits;
        all.trials += run.trials;
        fewest = std::min(fewest, run.trials);
    }
    if (all.hits == 0 || all.hits == all.trials) return 1;
    const double p = all.share();
    constexpr double enough = 5;
    if (static_cast<double>(fewest) * std::min(p, 1 - p) >= enough) {
        double dispersion = 0;
        for (const Proportion& run : runs) {
            const auto n = static_cast<double>(run.trials);
            const double excess = static_cast<double>(run.hits) - n * p;
            dispersion += excess * excess / (n * p * (1 - p));
        }
        return chi_squared_tail(dispersion, static_cast<double>(runs.size() - 1));
    }
    // Each hit, or miss where those are rarer, falls into a run with the probability that is the run's share of all
    // trials. They are drawn without replacement, which scatters less.
    double least = 1;
    for (const Proportion& run : runs) {
        if (run.trials == 0) continue;
        const double share = static_cast<double>(run.trials) / static_cast<double>(all.trials);
        const bool hits_are_rare = all.hits <= all.trials - all.hits;
        const Proportion rare =
            hits_are_rare ? Proportion{run.hits, all.hits} : Proportion{run.trials - run.hits, all.trials - all.hits};
        least = std::min(least, binomial_upper_p(rare, share));
    }
    return std::min(1.0, least * static_cast<double>(runs.size()));
}

}  // namespace ff::stats
