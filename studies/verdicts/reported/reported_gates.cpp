#include "studies/verdicts/reported/reported_gates.hpp"

#include "studies/verdicts/measurement.hpp"
#include "studies/verdicts/reported/distribution_gates.hpp"
#include "studies/verdicts/reported/estimate_gates.hpp"
#include "studies/verdicts/reported/reported_bins.hpp"
#include "studies/verdicts/reported/reported_effects.hpp"
#include "studies/verdicts/reported/shares_and_spreads.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace ff::studies::gates {
namespace {

std::string label(const BinComparison& comparing, std::size_t bin) {
    const auto name = comparing.bins.name(bin);
    return name.empty() ? comparing.gate.quantity : fmt::format("{}[{}]", comparing.gate.quantity, name);
}

void add_words(BinComparison& comparing, const BinsVerdict& verdict, GateResult& result) {
    const auto& bins = comparing.effects.bins;
    std::string words;
    if (bins.size() > 1) {
        words =
            fmt::format("{} bins: {} outside (Holm), {} undecided", bins.size(), verdict.rejected, verdict.undecided);
        if (comparing.gate.combine != Combination::holm)
            add_note(words, fmt::format("together p = {:.2g} ({})", verdict.p, name(comparing.gate.combine)));
        if (comparing.effects.are_differences()) {
            const double rms = rms_score(bins);
            add_note(words, fmt::format("standardised differences have root mean square {:.3g}", rms));
            constexpr std::size_t enough = 20;
            if (bins.size() >= enough && rms < 0.5)
                add_note(words,
                         "far below 1, so the errors are too large: of single samples or of sums rather than of "
                         "means? Or both files share random numbers");
        }
        std::vector<std::string> worst;
        for (const std::size_t i : verdict.worst) {
            constexpr std::size_t most_in_words = 3;
            if (worst.size() == most_in_words) break;
            const BinEffect& bin = bins[i];
            worst.push_back(
                comparing.effects.are_differences()
                    ? fmt::format("{} ({:+.3g} errors)", comparing.bins.name(bin.name), bin.value / bin.error)
                    : fmt::format("{} ({:.3g})", comparing.bins.name(bin.name), bin.value));
        }
        add_note(words, fmt::format("worst {}", fmt::join(worst, ", ")));
    }
    if (comparing.empty > 0)
        add_note(words, fmt::format(
                            "{} not judged: merge {}, leave {} out, or give shares by the columns hits and n",
                            comparing.empty == 1 ? "1 bin that no sample fell into is"
                                                 : fmt::format("{} bins that no sample fell into are", comparing.empty),
                            comparing.empty == 1 ? "it with another" : "them", comparing.empty == 1 ? "it" : "them"));
    add_note(words, comparing.note);
    result.note = words;
}

GateResult judge_effects(const Spec& spec, BinComparison& comparing, const Bins* against) {
    const auto& bins = comparing.effects.bins;
    if (bins.empty())
        refuse_gate(comparing.gate,
                    fmt::format("no bin of '{}' in {} holds anything{} (nothing would be compared). Run longer.",
                                comparing.gate.quantity, comparing.bins.file->origin,
                                against != nullptr ? fmt::format(" that is also in {}", against->file->origin) : ""));
    const Levels of_gate = levels_at_one_look(spec, 1);
    const Levels of_bin = levels_at_one_look(spec, bins.size());
    const BinsVerdict verdict =
        judge_bins(comparing.effects, comparing.gate.combine, of_gate.fail_alpha, of_gate.pass_alpha);
    GateResult result;
    result.gate = comparing.gate.name;
    result.kind = comparing.gate.kind;
    const bool has_gaps = verdict.verdict == Verdict::pass && comparing.empty > 0;
    result.verdict = has_gaps || comparing.contradicted ? Verdict::inconclusive : verdict.verdict;
    result.compared = bins.size();
    for (std::size_t rank = 0; rank < verdict.worst.size(); ++rank) {
        const BinEffect& bin = bins[verdict.worst[rank]];
        Comparison row;
        row.quantity = label(comparing, bin.name);
        row.band = bin.band;
        row.levels = of_bin;
        row.trials = comparing.bins.runs;
        row.unit = "run";
        row.measurement = measure_bin(comparing.effects, verdict.worst[rank], of_bin);
        row.verdict = rank < verdict.rejected ? Verdict::fail : judge(row.measurement, row.band);
        result.comparisons.push_back(std::move(row));
    }
    if (comparing.effects.are_differences()) result.scores = count_scores(bins);
    add_words(comparing, verdict, result);
    return result;
}

/// Histograms are compared as distributions, hits as shares, and nothing else is.
void expect_kind_of_values(const Gate& gate, const ReportedFile& file, const ReportedFile* against) {
    const bool of_counts = gate.kind == GateKind::distribution;
    if (of_counts && gate.law)
        refuse_gate(gate,
                    fmt::format("reference = a distribution is for trials ({} has none). Give the shares of the bins "
                                "by --against.",
                                file.origin));
    if (file.holds == Holds::shares)
        refuse_gate(
            gate, fmt::format("{} holds shares (without counts nothing is known of their errors). Give counts, or the "
                              "columns quantity,bin,hits,n; shares are what --against has.",
                              file.origin));
    if (of_counts != (file.holds == Holds::counts))
        refuse_gate(gate,
                    fmt::format("kind = \"{}\" is not for {} (counts of bins, or trials, have a distribution; means "
                                "with errors, and hits, do not). Choose another kind, or give the other columns.",
                                name(gate.kind), file.origin));
    const bool of_shares = file.holds == Holds::hits;
    if (of_shares && gate.kind != GateKind::bias && gate.kind != GateKind::equal)
        refuse_gate(gate, fmt::format("kind = \"{}\" is not for {} (the spread of hits follows from their share). Take "
                                      "\"bias\" or \"equal\".",
                                      name(gate.kind), file.origin));
    if (against == nullptr || gate.against != Against::file) return;
    const bool comparable = of_counts   ? against->holds == Holds::counts || against->holds == Holds::shares
                            : of_shares ? against->holds == Holds::hits || against->holds == Holds::means
                                        : against->holds == Holds::means;
    if (!comparable)
        refuse_gate(gate,
                    fmt::format("{} and {} hold different things (counts are compared with counts or shares, hits with "
                                "hits or means, means with means). Give two files of one kind.",
                                file.origin, against->origin));
}

/// Runs with a single value each are trials, and are examined as such: for repeats, correlation, skewness and heavy
/// tails.
EstimatesFile as_trials(const Gate& gate, const Bins& bins) {
    EstimateSeries series{.quantity = gate.quantity, .values = {}, .lines = {}};
    for (const ReportedRow& run : bins.rows) {
        series.values.push_back(run.mean);
        series.lines.push_back(run.line);
    }
    return {.origin = bins.file->origin, .series = {std::move(series)}};
}

bool are_trials(const Gate& gate, const Bins& bins) {
    return bins.file->holds == Holds::means && bins.count() == 1 && bins.runs >= enough_runs &&
           gate.kind == GateKind::bias && gate.against == Against::number;
}

/// The bins of the second file, empty where the gate takes none. @throws UserError where it lacks what the kind needs
std::optional<Bins> bins_beside(const Gate& gate, const Bins& bins, const ReportedFile* against) {
    const ReportedFile& file = *bins.file;
    if (gate.anytime != Anytime::no)
        refuse_gate(gate, fmt::format("anytime is for trials ({} has means of {} run{}). Give a file with the columns "
                                      "trial,quantity,estimate.",
                                      file.origin, bins.runs, bins.runs == 1 ? "" : "s"));
    expect_kind_of_values(gate, file, against);
    if (gate.against != Against::file || gate.kind == GateKind::std_error) return std::nullopt;
    if (against == nullptr)
        refuse_gate(gate, fmt::format("kind = \"{}\" has nothing to compare with. {}", name(gate.kind),
                                      gate.kind == GateKind::bias ? "Add reference = a number, or --against FILE.csv."
                                                                  : "Add --against FILE.csv."));
    Bins other = bins_of(gate, *against);
    expect_comparable(gate, bins, other);
    const bool exact = !against->has_errors && against->holds == Holds::means;
    if (exact && gate.kind != GateKind::bias && gate.kind != GateKind::distribution)
        refuse_gate(gate,
                    fmt::format("kind = \"{}\" needs the column 'standard_error' of {} (both sides are uncertain). "
                                "Add it, or take kind = \"bias\" where these values are exact.",
                                name(gate.kind), against->origin));
    return other;
}

/// Runs with which the mean of one bin would lie in its band.
std::optional<std::uint64_t> runs_for_bin(const BinComparison& comparing, const Bins* against, std::size_t index,
                                          const Levels& levels) {
    const BinEffect& bin = comparing.effects.bins[index];
    const double error = mean_of(comparing.bins.runs_of(bin.name)).standard_error;
    const double reference_se = against != nullptr ? mean_of(against->runs_of(bin.name)).standard_error
                                                   : comparing.gate.reference_se.value_or(0);
    return runs_for_mean(bin.band.high, error * std::sqrt(static_cast<double>(comparing.bins.runs)), reference_se,
                         levels, comparing.effects.bins.size());
}

}  // namespace

GateResult judge_reported(const Spec& spec, const Gate& gate, const ReportedFile& file, const ReportedFile* against) {
    const Bins bins = bins_of(gate, file);
    if (are_trials(gate, bins)) return judge_estimates(spec, gate, as_trials(gate, bins));
    const auto other = bins_beside(gate, bins, against);
    if (gate.kind == GateKind::distribution) return judge_counts(spec, gate, bins, *other);
    BinComparison comparing = effects_of(gate, bins, other ? &*other : nullptr);
    return judge_effects(spec, comparing, other ? &*other : nullptr);
}

EstimatesPlan plan_reported(const Spec& spec, const Gate& gate, const ReportedFile& file, const ReportedFile* against) {
    const Bins bins = bins_of(gate, file);
    if (are_trials(gate, bins)) return plan_estimates(spec, gate, as_trials(gate, bins));
    const auto other = bins_beside(gate, bins, against);
    if (gate.kind != GateKind::bias && gate.kind != GateKind::equal)
        refuse_gate(gate,
                    fmt::format("kind = \"{}\" has no --dry-run for {} (how its effect varies is not known). Leave "
                                "the option out.",
                                name(gate.kind), file.origin));
    const Bins* const beside = other ? &*other : nullptr;
    const BinComparison comparing = effects_of(gate, bins, beside);
    const Levels levels = levels_at_one_look(spec, 1);
    EstimatesPlan plan{.gate = gate.name,
                       .kind = gate.kind,
                       .comparisons = comparing.effects.bins.size(),
                       .needed = 1,
                       .at_hand = bins.runs,
                       .in_runs = true};
    for (std::size_t i = 0; i < plan.comparisons; ++i) {
        const auto runs = comparing.effects.scale == EffectScale::difference_of_shares
                              ? runs_for_share(comparing.effects.shares[i], comparing.effects.bins[i].band, bins.runs,
                                               levels, plan.comparisons)
                              : runs_for_bin(comparing, beside, i, levels);
        if (!runs) refuse_undecidable(gate, "runs");
        plan.needed = std::max(plan.needed, *runs);
    }
    return plan;
}

}  // namespace ff::studies::gates
