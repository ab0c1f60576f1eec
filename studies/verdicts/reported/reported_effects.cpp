#include "studies/verdicts/reported/reported_effects.hpp"

#include "stats/basics/distributions.hpp"
#include "stats/basics/moments.hpp"
#include "stats/dependence/correlation.hpp"
#include "stats/means/mean_test.hpp"
#include "studies/verdicts/reported/bin_covariance.hpp"
#include "studies/verdicts/reported/reported_faults.hpp"
#include "studies/verdicts/reported/reported_gates.hpp"
#include "studies/verdicts/reported/shares_and_spreads.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace ff::studies::gates {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

[[noreturn]] void refuse_repeated_runs(const Gate& gate, const Bins& bins, std::size_t bin) {
    refuse_gate(gate, fmt::format("bin '{}' of {} has the same mean in every run (repeated runs are not runs). Give "
                                  "every run a seed of its own.",
                                  bins.name(bin), bins.file->origin));
}

/// A mean of runs with what they show of their skewness; means with stated errors are taken for normal.
/// @param mean  of these runs
stats::MeanEvidence evidence_of(Rows runs, const MeanReference& mean) {
    std::vector<double> values;
    for (const ReportedRow& run : runs) values.push_back(run.mean);
    if (runs.size() >= enough_runs) {
        if (const auto evidence = stats::mean_evidence(values, 0)) return *evidence;
    }
    return {.difference = mean.value,
            .standard_error = mean.standard_error,
            .freedom = mean.freedom,
            .skewness = {.most = stats::no_part},
            .method = {},
            .n = runs.size()};
}

/// Degrees of freedom of a sum of the squares of stated errors [welch1947]; infinite where nobody says of how many
/// values they are.
double freedom_of_stated(Rows runs) {
    double sum = 0;
    double parts = 0;
    for (const ReportedRow& run : runs) {
        if (run.n <= 0) return infinity;
        const double square = run.standard_error * run.standard_error;
        sum += square;
        if (square > 0) parts += square * square / (run.n - 1);
    }
    return parts > 0 ? sum * sum / parts : infinity;
}

/// The effect a - b, with its standard error and degrees of freedom by Welch and Satterthwaite.
BinEffect difference(const MeanReference& a, const MeanReference& b) {
    BinEffect effect;
    effect.value = a.value - b.value;
    effect.error = std::hypot(a.standard_error, b.standard_error);
    const auto part = [&](const MeanReference& mean) {
        return std::pow(mean.standard_error / effect.error, 4) / mean.freedom;
    };
    effect.freedom = 1 / (part(a) + part(b));
    return effect;
}

/// Whether verdicts rest on errors that the code states.
bool trusts(const Bins& bins) {
    return bins.file->has_errors && bins.runs < enough_runs;
}

/// Stated errors are trusted where runs are few, unless these few contradict them: variances given as errors make runs
/// scatter far too much. By F of the spread between runs over what they state, averaged over bins, with the freedom of
/// one bin, since bins may be correlated.
void expect_scatter_as_stated(BinComparison& comparing, const Bins& bins) {
    if (!trusts(bins) || bins.runs < 2) return;
    double ratios = 0;
    double errors = 0;
    double judged = 0;
    double freedom = infinity;
    for (std::size_t bin = 0; bin < bins.count(); ++bin) {
        const Rows runs = bins.runs_of(bin);
        double mean = 0;
        double stated = 0;
        for (const ReportedRow& run : runs) {
            mean += run.mean / static_cast<double>(runs.size());
            stated += run.standard_error * run.standard_error / static_cast<double>(runs.size());
        }
        if (stated == 0) continue;
        freedom = std::min(freedom, freedom_of_stated(runs));
        double squares = 0;
        for (const ReportedRow& run : runs) squares += (run.mean - mean) * (run.mean - mean);
        ratios += squares / static_cast<double>(runs.size() - 1) / stated;
        errors += std::log(stated) / 2;
        ++judged;
    }
    if (judged == 0) return;
    const double p = stats::fisher_tail(ratios / judged, static_cast<double>(bins.runs) - 1, freedom);
    if (p >= false_alarm_of_scatter) return;
    comparing.contradicted = true;
    const double ratio = std::sqrt(ratios / judged);
    add_note(comparing.note,
             fmt::format("the {} runs of {} scatter {:.3g} times as much as the errors that they state (p = {:.2g}): "
                         "no verdict rests on such errors.{} Fix them, or give {} runs",
                         bins.runs, bins.file->origin, ratio, p,
                         fault_of_errors(ratio, std::exp(errors / judged), bins.rows[0].n), enough_runs));
}

void compare_means(BinComparison& comparing, const Bins* against) {
    const Gate& gate = comparing.gate;
    const MeanReference number{gate.reference.value_or(0), gate.reference_se.value_or(0), infinity};
    // Sums of squares over many bins are for normal means, which expect_normal_runs examines.
    const bool has_runs = comparing.bins.runs >= enough_runs || (against != nullptr && against->runs >= enough_runs);
    const bool by_runs = has_runs && gate.combine != Combination::chi_squared;
    for (std::size_t bin = 0; bin < comparing.bins.count(); ++bin) {
        const MeanReference own = mean_of(comparing.bins.runs_of(bin));
        const MeanReference reference = against != nullptr ? mean_of(against->runs_of(bin)) : number;
        if (is_empty(gate, comparing.bins, bin) || (against != nullptr && is_empty(gate, *against, bin))) {
            ++comparing.empty;
            continue;
        }
        BinEffect effect = difference(own, reference);
        effect.name = static_cast<std::uint32_t>(bin);
        effect.band = band_beside(comparing, bin, reference.value);
        comparing.effects.bins.push_back(effect);
        if (!by_runs) continue;
        stats::MeanEvidence evidence = evidence_of(comparing.bins.runs_of(bin), own);
        evidence.difference -= reference.value;
        const auto other = against != nullptr ? evidence_of(against->runs_of(bin), reference) : stats::MeanEvidence{};
        comparing.effects.means.push_back(
            against != nullptr
                ? stats::with_uncertain_reference(evidence, other.standard_error, other.freedom, other.skewness)
                : stats::with_uncertain_reference(evidence, number.standard_error, number.freedom));
    }
    if (!gate.covariance.empty() && !comparing.effects.bins.empty())
        comparing.effects.together = p_by_covariance(gate, comparing.bins, comparing.effects.bins);
    ReportedRow as_row;
    as_row.mean = number.value;
    std::string fault = fault_of_means(comparing.bins.rows, against != nullptr ? against->rows : Rows(&as_row, 1));
    if (against != nullptr) fault += fault_between_errors(comparing.bins.rows, against->rows);
    expect_scatter_as_stated(comparing, comparing.bins);
    if (against != nullptr) expect_scatter_as_stated(comparing, *against);
    if (!comparing.contradicted && (trusts(comparing.bins) || (against != nullptr && trusts(*against))))
        add_note(comparing.note,
                 "trusts the standard errors that are stated; several runs would show whether they are "
                 "right (kind = \"std_error\")");
    if (!fault.empty()) add_note(comparing.note, fault.substr(1));
}

/// How the runs of one bin lie about their mean, in the errors that they state.
struct Standardised {
    double ratio = 0;            ///< spread between runs over the root mean square of the stated errors
    double freedom = 0;          ///< runs - 1, reduced for kurtosis [box1953]
    double freedom_stated = 0;   ///< freedom of the mean of the stated variances, which are estimates themselves
    std::size_t within_two = 0;  ///< runs nearer than 1.96 errors, with what the mean's own error takes
};

Standardised standardise(Rows runs) {
    const auto n = static_cast<double>(runs.size());
    const double mean = mean_of(runs).value;
    double stated = 0;
    for (const ReportedRow& run : runs) stated += run.standard_error * run.standard_error / n;
    Standardised result;
    double squares = 0;  // in mean stated variances
    double fourth = 0;
    double variation = 0;  // of the stated variances, relative
    double values = 0;     // behind all errors, less one for each
    for (const ReportedRow& run : runs) {
        const double variance = run.standard_error * run.standard_error / stated;
        const double square = (run.mean - mean) * (run.mean - mean) / stated;
        squares += square;
        fourth += square * square;
        variation += std::pow(variance - 1, 2) / (n - 1);
        values = run.n > 0 ? values + std::max(1.0, run.n - 1) : infinity;
        result.within_two += std::sqrt(square) <= 1.959964 * std::sqrt(variance * (1 - 2 / n) + 1 / n) ? 1u : 0u;
    }
    const double kurtosis = squares > 0 ? n * fourth / (squares * squares) - 3 : 0;
    result.ratio = std::sqrt(squares / (n - 1));
    result.freedom = (n - 1) / (1 + std::max(0.0, kurtosis) / 2);
    result.freedom_stated = variation > 0 ? std::min(values, 2 * n / variation) : values;
    return result;
}

void compare_errors(BinComparison& comparing) {
    const Bins& bins = comparing.bins;
    if (bins.runs < fewest_runs)
        refuse_gate(comparing.gate,
                    fmt::format("kind = \"std_error\" needs at least {} runs ({} has {} of '{}': one run cannot "
                                "show whether its own error is right). Add rows with a column 'run'.",
                                fewest_runs, bins.file->origin, bins.runs, comparing.gate.quantity));
    comparing.effects.scale = EffectScale::ratio_of_deviations;
    std::size_t within = 0;
    std::size_t all = 0;
    double ratios = 0;
    double errors = 0;
    for (std::size_t bin = 0; bin < bins.count(); ++bin) {
        const Rows runs = bins.runs_of(bin);
        if (std::any_of(runs.begin(), runs.end(), [](const ReportedRow& run) { return run.standard_error == 0; })) {
            ++comparing.empty;
            continue;
        }
        const Standardised found = standardise(runs);
        if (found.ratio == 0) refuse_repeated_runs(comparing.gate, bins, bin);
        within += found.within_two;
        all += bins.runs;
        ratios += std::log(found.ratio);
        errors += std::log(runs[0].standard_error);
        comparing.add_ratio(bin, found.ratio, found.freedom, found.freedom_stated);
    }
    if (comparing.effects.bins.empty()) return;
    const auto judged = static_cast<double>(comparing.effects.bins.size());
    add_note(comparing.note,
             fmt::format("{} of {} means of runs ({:.3g} %) lie within 1.96 stated errors of the mean of "
                         "all, where 95 % should",
                         within, all, 100.0 * static_cast<double>(within) / static_cast<double>(all)));
    comparing.note +=
        fmt::format(".{}", fault_of_errors(std::exp(ratios / judged), std::exp(errors / judged), bins.rows[0].n));
}

/// Whether runs are skewed or have light tails: by the means over bins of skewness, its square, and kurtosis. Of 20 000
/// files of normal runs at most 1.5 % were called so; of those of 200 gamma(2) runs 99 %, and of 100 only 80 %.
void expect_normal_runs(BinComparison& comparing, const Bins& bins) {
    if (bins.runs < enough_runs || bins.file->holds != Holds::means) return;
    constexpr double fewest_values = 200;
    double sum = 0;
    double squares = 0;
    double tails = 0;
    double examined = 0;
    for (std::size_t bin = 0; bin < bins.count(); ++bin) {
        std::vector<double> values;
        for (const ReportedRow& run : bins.runs_of(bin)) values.push_back(run.mean);
        const auto moments = stats::moments_of(values, values.front());
        if (!moments.skewness()) continue;
        const double skewness = *moments.skewness() / *stats::skewness_standard_error(bins.runs);
        sum += skewness;
        squares += skewness * skewness - 1;
        tails += *moments.excess_kurtosis() / *stats::excess_kurtosis_standard_error(bins.runs);
        ++examined;
    }
    if (examined == 0) return;
    const double far = 3 * std::sqrt(examined);
    const bool are_few = examined * static_cast<double>(bins.runs) < fewest_values;
    if (!are_few && std::abs(sum) <= far && squares <= 2 * far && tails >= -far) return;
    comparing.contradicted = true;
    add_note(comparing.note,
             fmt::format("the runs of {} are {}: no verdict rests on a sum of squares, which is for normal means. Take "
                         "combine = \"holm\"",
                         bins.file->origin, are_few ? "too few to show whether they are normal" : "not normal"));
}

/// Bins that are said to be independent are examined where there are several runs, including runs of hits.
void expect_independent_bins(BinComparison& comparing, const Bins& bins) {
    constexpr std::size_t most_runs = 50;  // more would take long, and show little more
    const std::size_t runs = std::min(bins.runs, most_runs);
    std::vector<double> values;
    values.reserve(runs * bins.count());
    for (std::size_t bin = 0; bin < bins.count(); ++bin) {
        for (const ReportedRow& row : bins.runs_of(bin).first(runs))
            values.push_back(bins.file->holds == Holds::hits ? row.mean / std::max(1.0, row.n) : row.mean);
    }
    const auto p = stats::p_of_independence(values, runs);
    if (!p || runs < enough_runs)  // since few runs show it only where it is strong
        add_note(comparing.note, fmt::format("takes the bins of {} for independent", bins.file->origin));
    if (!p || *p >= false_alarm_of_scatter) return;
    comparing.contradicted = true;
    add_note(comparing.note,
             fmt::format("the bins of {} vary together from run to run (p = {:.2g}): no verdict rests on their "
                         "independence. Take combine = \"cauchy\", or give their covariance",
                         bins.file->origin, *p));
}

}  // namespace

MeanReference mean_of(Rows runs) {
    const auto n = static_cast<double>(runs.size());
    if (runs.size() == 1) return {runs[0].mean, runs[0].standard_error, runs[0].n > 0 ? runs[0].n - 1 : infinity};
    MeanReference mean{.value = runs[0].mean};  // so that equal runs have no spread by rounding
    for (const ReportedRow& run : runs) mean.value += (run.mean - runs[0].mean) / n;
    double squares = 0;
    if (runs.size() >= enough_runs) {
        for (const ReportedRow& run : runs) squares += (run.mean - mean.value) * (run.mean - mean.value) / (n - 1);
        mean.standard_error = std::sqrt(squares / n);
        mean.freedom = n - 1;
        return mean;
    }
    for (const ReportedRow& run : runs) squares += run.standard_error * run.standard_error;
    mean.standard_error = std::sqrt(squares) / n;
    mean.freedom = freedom_of_stated(runs);
    return mean;
}

bool is_empty(const Gate& gate, const Bins& bins, std::size_t bin) {
    const MeanReference mean = mean_of(bins.runs_of(bin));
    const bool is_exact = !bins.file->has_errors && bins.runs < enough_runs;
    if (mean.standard_error > 0 || is_exact) return false;
    if (mean.value != 0) refuse_repeated_runs(gate, bins, bin);
    return true;
}

Band band_beside(const BinComparison& comparing, std::size_t bin, double reference) {
    const Gate& gate = comparing.gate;
    if (!gate.relative) return gate.band;
    if (reference == 0)
        refuse_gate(gate, fmt::format("relative = true, and the reference of bin '{}' is 0 (a share of nothing). Leave "
                                      "the bin out, or give an absolute band.",
                                      comparing.bins.name(bin)));
    return {gate.band.low * std::abs(reference), gate.band.high * std::abs(reference)};
}

void add_note(std::string& note, std::string_view text) {
    if (text.empty()) return;
    if (!note.empty()) note += "; ";
    note += text;
}

BinComparison effects_of(const Gate& gate, const Bins& bins, const Bins* against) {
    BinComparison comparing{.gate = gate, .bins = bins, .effects = {}, .empty = 0, .note = {}};
    switch (gate.kind) {
        case GateKind::std:
            compare_spreads(comparing);
            break;
        case GateKind::std_error:
            compare_errors(comparing);
            break;
        case GateKind::efficiency:
            compare_efficiencies(comparing, *against);
            break;
        default:
            if (bins.file->holds == Holds::hits)
                compare_shares(comparing, against);
            else
                compare_means(comparing, against);
            break;
    }
    if (gate.combine == Combination::chi_squared) {
        for (const Bins* each : {&bins, against}) {
            if (each == nullptr) continue;
            expect_normal_runs(comparing, *each);
            if (gate.covariance.empty()) expect_independent_bins(comparing, *each);
        }
    }
    return comparing;
}

}  // namespace ff::studies::gates
