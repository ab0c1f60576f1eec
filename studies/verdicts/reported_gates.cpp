#include "studies/verdicts/reported_gates.hpp"

#include "studies/verdicts/at_gate.hpp"
#include "studies/verdicts/distribution_gates.hpp"
#include "studies/verdicts/estimate_gates.hpp"
#include "studies/verdicts/reported_bins.hpp"
#include "studies/verdicts/reported_effects.hpp"

#include <fmt/format.h>

#include <optional>
#include <utility>

namespace ff::studies {
namespace {

std::string label(const Comparing& comparing, std::size_t bin) {
    const auto name = comparing.bins.name(bin);
    return name.empty() ? comparing.gate.quantity : fmt::format("{}[{}]", comparing.gate.quantity, name);
}

void add_words(Comparing& comparing, const BinsVerdict& verdict, GateResult& result) {
    const auto& bins = comparing.effects.bins;
    std::string words;
    if (bins.size() > 1) {
        words =
            fmt::format("{} bins: {} outside (Holm), {} undecided", bins.size(), verdict.rejected, verdict.undecided);
        if (comparing.gate.combine != Combination::holm)
            add_note(words, fmt::format("together p = {:.2g} ({})", verdict.p, name(comparing.gate.combine)));
        if (comparing.effects.scale == EffectScale::difference) {
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
                comparing.effects.scale == EffectScale::difference
                    ? fmt::format("{} ({:+.3g} errors)", comparing.bins.name(bin.name), bin.value / bin.error)
                    : fmt::format("{} ({:.3g})", comparing.bins.name(bin.name), bin.value));
        }
        add_note(words, fmt::format("worst {}", fmt::join(worst, ", ")));
    }
    if (comparing.empty > 0)
        add_note(words,
                 fmt::format("{} bin{} that no sample fell into {} not judged: merge them, or leave them out",
                             comparing.empty, comparing.empty == 1 ? "" : "s", comparing.empty == 1 ? "is" : "are"));
    add_note(words, comparing.note);
    result.note = words;
}

GateResult judge_effects(const GatesSpec& spec, Comparing& comparing) {
    const auto& bins = comparing.effects.bins;
    if (bins.empty())
        refuse_gate(comparing.gate,
                    fmt::format("no bin of '{}' in {} holds anything (nothing would be compared). Run longer.",
                                comparing.gate.quantity, comparing.bins.file->origin));
    GatesSpec one_look = spec;  // nothing can be added to a file
    one_look.looks = 1;
    const Levels of_gate = levels_of(one_look, 1);
    Levels of_bin = levels_of(one_look, bins.size());
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
        row.measurement = measure_bin(bin, comparing.effects.scale, of_bin);
        row.verdict = rank < verdict.rejected ? Verdict::fail : judge(row.measurement, row.band);
        result.comparisons.push_back(std::move(row));
    }
    if (comparing.effects.scale == EffectScale::difference) result.scores = count_scores(bins);
    add_words(comparing, verdict, result);
    return result;
}

/// Histograms are compared as distributions, and nothing else is.
void expect_kind_of_values(const Gate& gate, const ReportedFile& file, const ReportedFile* against) {
    const bool counts = file.holds == Holds::counts;
    const bool of_counts = gate.kind == GateKind::distribution;
    if (of_counts && gate.law)
        refuse_gate(gate,
                    fmt::format("reference = a distribution is for trials ({} has none). Give the shares of the bins "
                                "by --against.",
                                file.origin));
    if (file.holds == Holds::shares)
        refuse_gate(
            gate, fmt::format("{} holds shares (without counts nothing is known of their errors). Give counts; shares "
                              "are what --against has.",
                              file.origin));
    if (of_counts != counts)
        refuse_gate(gate,
                    fmt::format("kind = \"{}\" is not for {} (counts of bins, or trials, have a distribution; means "
                                "with errors do not). Choose another kind, or give the other columns.",
                                name(gate.kind), file.origin));
    if (against != nullptr && gate.against == Against::file && (against->holds == Holds::means) == of_counts)
        refuse_gate(gate,
                    fmt::format("{} and {} hold different things (counts are compared with counts or shares, means "
                                "with means). Give two files of one kind.",
                                file.origin, against->origin));
}

/// Runs of a single value are trials, and are examined as such: for repeats, correlation, skewness and heavy tails.
EstimatesFile as_trials(const Gate& gate, const Bins& bins) {
    EstimateSeries series{.quantity = gate.quantity, .values = {}, .lines = {}};
    for (const ReportedRow& run : bins.rows) {
        series.values.push_back(run.mean);
        series.lines.push_back(run.line);
    }
    return {.origin = bins.file->origin, .series = {std::move(series)}};
}

}  // namespace

GateResult judge_reported(const GatesSpec& spec, const Gate& gate, const ReportedFile& file,
                          const ReportedFile* against) {
    const Bins bins = bins_of(gate, file);
    const bool are_trials = bins.count() == 1 && bins.runs >= enough_runs;
    if (are_trials && gate.kind == GateKind::bias && gate.against == Against::number)
        return judge_estimates(spec, gate, as_trials(gate, bins));
    if (gate.anytime != Anytime::no)
        refuse_gate(gate, fmt::format("anytime is for trials ({} has means of {} run{}). Give a file with the columns "
                                      "trial,quantity,estimate.",
                                      file.origin, bins.runs, bins.runs == 1 ? "" : "s"));
    expect_kind_of_values(gate, file, against);
    std::optional<Bins> other;
    if (gate.against == Against::file && gate.kind != GateKind::std_error) {
        if (against == nullptr)
            refuse_gate(gate,
                        fmt::format("kind = \"{}\" has nothing to compare with. {}", name(gate.kind),
                                    gate.kind == GateKind::bias ? "Add reference = a number, or --against FILE.csv."
                                                                : "Add --against FILE.csv."));
        other = bins_of(gate, *against);
        expect_comparable(gate, bins, *other);
        if (gate.kind == GateKind::distribution) return judge_counts(spec, gate, bins, *other);
        if (gate.kind != GateKind::bias && !against->has_errors)
            refuse_gate(gate,
                        fmt::format("kind = \"{}\" needs the column 'standard_error' of {} (both sides are uncertain). "
                                    "Add it, or take kind = \"bias\" where these values are exact.",
                                    name(gate.kind), against->origin));
    }
    Comparing comparing = effects_of(gate, bins, other ? &*other : nullptr);
    return judge_effects(spec, comparing);
}

}  // namespace ff::studies
