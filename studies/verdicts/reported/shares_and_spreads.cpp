#include "studies/verdicts/reported/shares_and_spreads.hpp"

#include "stats/error_rates/multiplicity.hpp"
#include "studies/verdicts/measurement.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace ff::studies::gates {
namespace {

/// The variance of a share, from a probability that is neither 0 nor 1, so that scores can be computed.
double approximate_variance(const stats::Proportion& counts) {
    const auto n = static_cast<double>(counts.trials);
    const double p = (static_cast<double>(counts.hits) + 0.5) / (n + 1);
    return p * (1 - p) / n;
}

void expect_binomial_scatter(BinComparison& comparing, const Bins& bins) {
    if (bins.runs < 2) return;
    std::vector<double> p;
    std::vector<stats::Proportion> runs(bins.runs);
    for (std::size_t bin = 0; bin < bins.count(); ++bin) {
        const Rows rows = bins.runs_of(bin);
        std::transform(rows.begin(), rows.end(), runs.begin(),
                       [](const ReportedRow& row) { return pooled(Rows(&row, 1)); });
        p.push_back(stats::p_of_binomial_scatter(runs));
    }
    const double together = stats::cauchy_combination(p);
    if (together >= false_alarm_of_scatter) return;
    comparing.contradicted = true;
    add_note(comparing.note,
             fmt::format("the hits of the {} runs of {} scatter more than those of independent trials (p = {:.2g}): no "
                         "verdict rests on them. Give each run's share as a mean with its standard error",
                         bins.runs, bins.file->origin, together));
}

/// The reference of a bin's share: the gate's number, or this bin of a second file, which may hold hits, or
/// means with or without errors.
stats::ShareReference share_reference(const Gate& gate, const Bins* against, std::size_t bin) {
    stats::ShareReference reference;
    if (against == nullptr) {
        reference.value = gate.reference.value_or(0);
        reference.standard_error = gate.reference_se.value_or(0);
    } else if (against->file->holds == Holds::hits) {
        reference.counts = pooled(against->runs_of(bin));
        reference.value = reference.counts->trials > 0 ? reference.counts->share() : 0;
    } else {
        const MeanReference mean = mean_of(against->runs_of(bin));
        reference.value = mean.value;
        reference.standard_error = mean.standard_error;
        reference.freedom = mean.freedom;
    }
    return reference;
}

/// Degrees of freedom of a variance of n samples: its own variance is that of normal ones plus what their kurtosis adds
/// [box1953]. A mean with its error does not show the kurtosis: 0 where none is declared.
double freedom_of_variance(const Gate& gate, double n) {
    return gate.kurtosis ? 2 / ((*gate.kurtosis - 3) / n + 2 / (n - 1)) : 0;
}

std::string about_samples(const Gate& gate) {
    if (gate.kurtosis)
        return fmt::format("takes the n samples behind each error for independent, of kurtosis {:g} at most",
                           *gate.kurtosis);
    return "how far a standard deviation may be off depends on the kurtosis of the samples, which no mean with its "
           "error shows: add kurtosis = 3 where they are about normal, as batches are, or the largest that they may "
           "have, or give trials";
}

}  // namespace

stats::Proportion pooled(Rows runs) {
    stats::Proportion all;
    for (const ReportedRow& run : runs) {
        all.hits += static_cast<std::uint64_t>(run.mean);
        all.trials += static_cast<std::uint64_t>(run.n);
    }
    return all;
}

void compare_shares(BinComparison& comparing, const Bins* against) {
    const Gate& gate = comparing.gate;
    comparing.effects.scale = EffectScale::difference_of_shares;
    for (std::size_t bin = 0; bin < comparing.bins.count(); ++bin) {
        const SharePair pair{pooled(comparing.bins.runs_of(bin)), share_reference(gate, against, bin)};
        const bool beside_none = pair.reference.counts ? pair.reference.counts->trials == 0
                                                       : against != nullptr && is_empty(gate, *against, bin);
        if (pair.counts.trials == 0 || beside_none) {
            ++comparing.empty;
            continue;
        }
        const double of_reference = pair.reference.counts
                                        ? approximate_variance(*pair.reference.counts)
                                        : pair.reference.standard_error * pair.reference.standard_error;
        comparing.effects.bins.push_back({.value = pair.counts.share() - pair.reference.value,
                                          .error = std::sqrt(approximate_variance(pair.counts) + of_reference),
                                          .freedom = static_cast<double>(pair.counts.trials),
                                          .band = band_beside(comparing, bin, pair.reference.value),
                                          .name = static_cast<std::uint32_t>(bin)});
        comparing.effects.shares.push_back(pair);
    }
    expect_binomial_scatter(comparing, comparing.bins);
    if (against != nullptr && against->file->holds == Holds::hits) expect_binomial_scatter(comparing, *against);
    if (!comparing.contradicted) add_note(comparing.note, "takes the trials behind each share for independent");
}

std::optional<std::uint64_t> runs_for_share(const SharePair& pair, const Band& band, std::size_t runs,
                                            const Levels& levels, std::size_t comparisons) {
    const double reference = std::clamp(pair.reference.value, 0.0, 1.0);
    Levels of_share = levels;
    double uncertain = 0;
    if (pair.reference.counts || pair.reference.standard_error > 0) {
        of_share.pass_alpha /= 2;
        const stats::Interval other = stats::reference_interval(pair.reference, 1 - 2 * of_share.pass_alpha);
        uncertain = std::max(other.high - reference, reference - other.low);
    }
    const Band left{reference + band.low + uncertain, reference + band.high - uncertain};
    if (!(left.low < reference && reference < left.high)) return std::nullopt;
    const auto trials = trials_for_proportion(left, reference, of_share, comparisons);
    if (!trials) return std::nullopt;
    const double of_run = static_cast<double>(pair.counts.trials) / static_cast<double>(runs);
    return static_cast<std::uint64_t>(std::ceil(static_cast<double>(*trials) / of_run));
}

void compare_spreads(BinComparison& comparing) {
    if (!comparing.bins.file->has_n)
        refuse_gate(comparing.gate,
                    fmt::format("kind = \"std\" needs the column 'n' of {} (the error of a mean of how many "
                                "values?). Add it.",
                                comparing.bins.file->origin));
    comparing.effects.scale = EffectScale::ratio_of_deviations;
    for (std::size_t bin = 0; bin < comparing.bins.count(); ++bin) {
        double squares = 0;
        double weights = 0;
        double freedom = 0;
        for (const ReportedRow& run : comparing.bins.runs_of(bin)) {
            squares += run.standard_error * run.standard_error * run.n * (run.n - 1);
            weights += run.n - 1;
            freedom += freedom_of_variance(comparing.gate, run.n);
        }
        if (squares == 0) {
            ++comparing.empty;
            continue;
        }
        comparing.add_ratio(bin, std::sqrt(squares / weights) / *comparing.gate.reference, freedom,
                            std::numeric_limits<double>::infinity());
    }
    add_note(comparing.note, about_samples(comparing.gate));
}

void compare_efficiencies(BinComparison& comparing, const Bins& against) {
    for (const Bins* bins : {&std::as_const(comparing).bins, &against}) {
        if (!bins->file->has_n || bins->runs != 1)
            refuse_gate(comparing.gate,
                        fmt::format("kind = \"efficiency\" needs one run with the column 'n' in {} (an error of "
                                    "how many values?). Add it.",
                                    bins->file->origin));
    }
    const bool by_cost = comparing.bins.file->has_cost;
    if (by_cost != against.file->has_cost)
        refuse_gate(comparing.gate, fmt::format("kind = \"efficiency\": only {} has the column 'cost'. Give it in both "
                                                "files, or in neither to count values.",
                                                (by_cost ? comparing.bins : against).file->origin));
    comparing.effects.scale = EffectScale::ratio_of_variances;
    const auto inverse = [&](const ReportedRow& row) {
        return row.standard_error * row.standard_error * (by_cost ? row.cost : row.n);
    };
    for (std::size_t bin = 0; bin < comparing.bins.count(); ++bin) {
        const ReportedRow& own = comparing.bins.rows[bin];
        const ReportedRow& other = against.rows[bin];
        if (own.standard_error == 0 || other.standard_error == 0) {
            ++comparing.empty;
            continue;
        }
        comparing.add_ratio(bin, inverse(other) / inverse(own), freedom_of_variance(comparing.gate, other.n),
                            freedom_of_variance(comparing.gate, own.n));
    }
    add_note(
        comparing.note,
        by_cost
            ? "1 / (error² × cost), of the file over --against; costs count as exact, and seconds depend on the machine"
            : "1 / (error² × n), of the file over --against");
    add_note(comparing.note, about_samples(comparing.gate));
}

}  // namespace ff::studies::gates
