#include "studies/gates/reported_gates.hpp"

#include "core/support/error.hpp"
#include "studies/gates/estimate_gates.hpp"
#include "studies/gates/reported_bins.hpp"
#include "studies/gates/reporting_faults.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <utility>

namespace ff::studies {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

using Rows = std::span<const ReportedRow>;

[[noreturn]] void refuse(const Gate& gate, const std::string& problem) {
    throw UserError(fmt::format("{}: {}", gate.place, problem));
}

/// The rows of one quantity in one file, bin by bin.
struct Bins {
    const ReportedFile* file = nullptr;
    Rows rows;
    std::size_t runs = 1;  ///< of each bin

    [[nodiscard]] std::size_t count() const { return rows.size() / runs; }
    [[nodiscard]] Rows runs_of(std::size_t bin) const { return rows.subspan(bin * runs, runs); }
    [[nodiscard]] std::string_view name(std::size_t bin) const { return file->name_of(rows[bin * runs]); }
};

/// @throws UserError where the bins do not have the same runs each
Bins bins_of(const Gate& gate, const ReportedFile& file) {
    Bins bins{&file, find_rows(file, gate.quantity, gate.place), 1};
    const Rows rows = bins.rows;
    while (bins.runs < rows.size() && file.name_of(rows[bins.runs]) == file.name_of(rows[0])) ++bins.runs;
    for (std::size_t i = 0; i < rows.size(); ++i) {
        const std::size_t first = i - i % bins.runs;
        const bool whole = first + bins.runs <= rows.size() && file.name_of(rows[i]) == file.name_of(rows[first]) &&
                           rows[i].run == rows[i % bins.runs].run;
        if (whole) continue;
        throw UserError(
            fmt::format("{}:{}:1: '{}', bin '{}', run {} (every bin needs the same runs; the first has {}). "
                        "Give one row for each bin and run.",
                        file.origin, rows[i].line, gate.quantity, file.name_of(rows[i]), rows[i].run, bins.runs));
    }
    return bins;
}

bool same_numbers(const ReportedRow& a, const ReportedRow& b) {
    return a.mean == b.mean && a.standard_error == b.standard_error;
}

/// Two runs that agree in every bin that is filled were given the same random numbers.
void refuse_equal_runs(const Gate& gate, const Bins& bins) {
    constexpr std::size_t telling = 3;  // counts of a bin or two may agree by chance
    for (std::size_t run = 1; run < bins.runs; ++run) {
        std::size_t filled = 0;
        bool equal = true;
        for (std::size_t bin = 0; equal && bin < bins.count(); ++bin) {
            const Rows runs = bins.runs_of(bin);
            equal = same_numbers(runs[run - 1], runs[run]);
            filled += runs[run].is_empty() ? 0u : 1u;
        }
        if (equal && filled >= telling)
            throw UserError(fmt::format(
                "{}: runs {} and {} of '{}' hold the same numbers in all {} bins (a run repeated "
                "is no second run). Give every run a seed of its own.",
                bins.file->origin, bins.rows[run - 1].run, bins.rows[run].run, gate.quantity, bins.count()));
    }
}

void expect_same_bins(const Gate& gate, const Bins& ours, const Bins& theirs) {
    const auto missing_in = [&](const Bins& all, const Bins& some) {
        for (std::size_t a = 0, b = 0; a < all.count(); ++a, ++b) {
            if (b < some.count() && all.name(a) == some.name(b)) continue;
            throw UserError(
                fmt::format("{}:{}:1: '{}', bin '{}' is not matched in {} ({} bins here, {} there; bins are "
                            "compared by name). Give both files the same binning.",
                            all.file->origin, all.rows[a * all.runs].line, gate.quantity, all.name(a),
                            some.file->origin, all.count(), some.count()));
        }
    };
    missing_in(ours, theirs);
    missing_in(theirs, ours);
}

void refuse_equal_files(const Gate& gate, const Bins& ours, const Bins& theirs) {
    const bool equal = ours.rows.size() == theirs.rows.size() && theirs.file->has_errors &&
                       std::equal(ours.rows.begin(), ours.rows.end(), theirs.rows.begin(), same_numbers);
    if (!equal) return;
    throw UserError(
        fmt::format("{}: '{}' has the same numbers as in {} (one file twice, or two runs with the same random "
                    "numbers: their difference of 0 says nothing). Give the second run a seed of its own; "
                    "where equal bits are wanted, compare them with cmp.",
                    ours.file->origin, gate.quantity, theirs.file->origin));
}

/// A mean over runs with its error.
struct Mean {
    double value = 0;
    double error = 0;
    double freedom = infinity;
};

Mean mean_of(Rows runs) {
    const auto n = static_cast<double>(runs.size());
    if (runs.size() == 1) return {runs[0].mean, runs[0].standard_error, runs[0].n > 0 ? runs[0].n - 1 : infinity};
    Mean mean;
    for (const ReportedRow& run : runs) mean.value += run.mean / n;
    double squares = 0;
    if (runs.size() >= enough_runs) {
        for (const ReportedRow& run : runs) squares += (run.mean - mean.value) * (run.mean - mean.value) / (n - 1);
        mean.error = std::sqrt(squares / n);
        mean.freedom = n - 1;
        return mean;
    }
    for (const ReportedRow& run : runs) squares += run.standard_error * run.standard_error;
    mean.error = std::sqrt(squares) / n;
    if (runs.front().n > 0) mean.freedom = n * (runs.front().n - 1);
    return mean;
}

/// Of a - b, by Welch and Satterthwaite.
BinEffect difference(const Mean& a, const Mean& b) {
    BinEffect effect;
    effect.value = a.value - b.value;
    effect.error = std::hypot(a.error, b.error);
    const auto part = [&](const Mean& mean) { return std::pow(mean.error / effect.error, 4) / mean.freedom; };
    effect.freedom = 1 / (part(a) + part(b));
    return effect;
}

/// Everything that the words of a verdict are made from.
struct Comparing {
    const Gate& gate;
    Bins bins;
    BinEffects effects;
    std::size_t empty = 0;  ///< bins that no sample fell into
    std::string note;
};

void add_note(std::string& note, std::string_view text) {
    if (text.empty()) return;
    if (!note.empty()) note += "; ";
    note += text;
}

/// Whether verdicts rest on errors that the code states.
bool trusts(const Bins& bins) {
    return bins.file->has_errors && bins.runs < enough_runs;
}

void compare_means(Comparing& comparing, const Bins* against) {
    const Gate& gate = comparing.gate;
    const Mean number{gate.reference.value_or(0), gate.reference_se.value_or(0), infinity};
    comparing.effects.bins.reserve(comparing.bins.count());
    for (std::size_t bin = 0; bin < comparing.bins.count(); ++bin) {
        const Rows runs = comparing.bins.runs_of(bin);
        const Mean own = mean_of(runs);
        const Mean reference = against != nullptr ? mean_of(against->runs_of(bin)) : number;
        if (own.error == 0) {
            if (own.value != 0)
                refuse(gate, fmt::format("bin '{}' of {} has the same mean in every run (repeated runs are no runs). "
                                         "Give every run a seed of its own.",
                                         comparing.bins.name(bin), comparing.bins.file->origin));
            ++comparing.empty;
            continue;
        }
        BinEffect effect = difference(own, reference);
        effect.name = static_cast<std::uint32_t>(bin);
        effect.band = gate.band;
        if (gate.relative) {
            if (reference.value == 0)
                refuse(gate,
                       fmt::format("relative = true, and the reference of bin '{}' is 0 (a share of nothing). Leave "
                                   "the bin out, or give an absolute band.",
                                   comparing.bins.name(bin)));
            effect.band = {gate.band.low * std::abs(reference.value), gate.band.high * std::abs(reference.value)};
        }
        comparing.effects.bins.push_back(effect);
    }
    ReportedRow as_row;
    as_row.mean = number.value;
    std::string fault = fault_of_means(comparing.bins.rows, against != nullptr ? against->rows : Rows(&as_row, 1));
    if (against != nullptr) fault += fault_between_errors(comparing.bins.rows, against->rows);
    if (trusts(comparing.bins) || (against != nullptr && trusts(*against)))
        add_note(comparing.note,
                 "trusts the standard errors that are stated; several runs would show whether they are "
                 "right (kind = \"std_error\")");
    if (!fault.empty()) add_note(comparing.note, fault.substr(1));
}

void compare_spreads(Comparing& comparing) {
    if (!comparing.bins.file->has_n)
        refuse(comparing.gate, fmt::format("kind = \"std\" needs the column 'n' of {} (the error of a mean of how many "
                                           "values?). Add it.",
                                           comparing.bins.file->origin));
    comparing.effects.scale = EffectScale::ratio_of_deviations;
    for (std::size_t bin = 0; bin < comparing.bins.count(); ++bin) {
        double squares = 0;
        double freedom = 0;
        for (const ReportedRow& run : comparing.bins.runs_of(bin)) {
            squares += run.standard_error * run.standard_error * run.n * (run.n - 1);
            freedom += run.n - 1;
        }
        if (squares == 0) {
            ++comparing.empty;
            continue;
        }
        comparing.effects.bins.push_back({.value = std::sqrt(squares / freedom) / *comparing.gate.reference,
                                          .error = 0,
                                          .freedom = freedom,
                                          .freedom_below = infinity,
                                          .band = comparing.gate.band,
                                          .name = static_cast<std::uint32_t>(bin)});
    }
    add_note(comparing.note, "takes the n values behind each error for independent and normal");
}

void compare_efficiencies(Comparing& comparing, const Bins& against) {
    for (const Bins* bins : {&std::as_const(comparing).bins, &against}) {
        if (!bins->file->has_n || bins->runs != 1)
            refuse(comparing.gate,
                   fmt::format("kind = \"efficiency\" needs one run with the column 'n' in {} (an error of "
                               "how many values?). Add it.",
                               bins->file->origin));
    }
    const bool by_cost = comparing.bins.file->has_cost && against.file->has_cost;
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
        comparing.effects.bins.push_back({.value = inverse(other) / inverse(own),
                                          .error = 0,
                                          .freedom = other.n - 1,
                                          .freedom_below = own.n - 1,
                                          .band = comparing.gate.band,
                                          .name = static_cast<std::uint32_t>(bin)});
    }
    add_note(comparing.note, by_cost ? "1 / (error² × cost), of the file over --against; seconds depend on the machine"
                                     : "1 / (error² × n), of the file over --against");
    add_note(comparing.note, "takes the n values behind each error for independent and normal");
}

/// How the runs of one bin lie about their mean, in the errors that they state.
struct Standardised {
    double square_sum = 0;
    double freedom = 0;          ///< runs - 1, reduced for kurtosis [box1953]
    std::size_t within_two = 0;  ///< runs nearer than 1.96 errors, with what the mean's own error takes
};

Standardised standardise(Rows runs) {
    double weights = 0;
    double sum = 0;
    for (const ReportedRow& run : runs) {
        const double weight = 1 / (run.standard_error * run.standard_error);
        weights += weight;
        sum += weight * run.mean;
    }
    const double mean = sum / weights;
    Standardised result;
    double fourth = 0;
    for (const ReportedRow& run : runs) {
        const double z = (run.mean - mean) / run.standard_error;
        const double share = 1 - 1 / (run.standard_error * run.standard_error * weights);
        result.square_sum += z * z;
        fourth += z * z * z * z;
        result.within_two += share > 0 && std::abs(z) <= 1.959964 * std::sqrt(share) ? 1u : 0u;
    }
    const auto n = static_cast<double>(runs.size());
    const double kurtosis = n * fourth / (result.square_sum * result.square_sum) - 3;
    result.freedom = (n - 1) / (1 + std::max(0.0, kurtosis) / 2);
    return result;
}

void compare_errors(Comparing& comparing) {
    const Bins& bins = comparing.bins;
    if (bins.runs < fewest_runs)
        refuse(comparing.gate,
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
        if (found.square_sum == 0)
            refuse(comparing.gate,
                   fmt::format("bin '{}' of {} has the same mean in every run (repeated runs are no runs). "
                               "Give every run a seed of its own.",
                               bins.name(bin), bins.file->origin));
        const double ratio = std::sqrt(found.square_sum / static_cast<double>(bins.runs - 1));
        within += found.within_two;
        all += bins.runs;
        ratios += std::log(ratio);
        errors += std::log(runs[0].standard_error);
        comparing.effects.bins.push_back({.value = ratio,
                                          .error = 0,
                                          .freedom = found.freedom,
                                          .freedom_below = infinity,
                                          .band = comparing.gate.band,
                                          .name = static_cast<std::uint32_t>(bin)});
    }
    if (comparing.effects.bins.empty()) return;
    const auto judged = static_cast<double>(comparing.effects.bins.size());
    add_note(comparing.note,
             fmt::format("{} of {} means of runs ({:.3g} %) lie within 1.96 stated errors of the mean of "
                         "all, where 95 % should",
                         within, all, 100.0 * static_cast<double>(within) / static_cast<double>(all)));
    comparing.note += "." + fault_of_errors(std::exp(ratios / judged), std::exp(errors / judged), bins.rows[0].n);
}

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

GateResult judge(const GatesSpec& spec, Comparing& comparing) {
    const auto& bins = comparing.effects.bins;
    if (bins.empty())
        refuse(comparing.gate,
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
    result.verdict = verdict.verdict == Verdict::pass && comparing.empty > 0 ? Verdict::inconclusive : verdict.verdict;
    result.compared = bins.size();
    for (std::size_t rank = 0; rank < verdict.worst.size(); ++rank) {
        const BinEffect& bin = bins[verdict.worst[rank]];
        Comparison row;
        row.quantity = label(comparing, bin.name);
        row.band = bin.band;
        row.levels = of_bin;
        row.trials = comparing.bins.runs;
        row.measurement = measure_bin(bin, comparing.effects.scale, of_bin);
        row.verdict = rank < verdict.rejected ? Verdict::fail : studies::judge(row.measurement, row.band);
        result.comparisons.push_back(std::move(row));
    }
    if (comparing.effects.scale == EffectScale::difference) result.scores = count_scores(bins);
    add_words(comparing, verdict, result);
    return result;
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
    Comparing comparing{.gate = gate, .bins = bins_of(gate, file), .effects = {}, .empty = 0, .note = {}};
    refuse_equal_runs(gate, comparing.bins);
    const bool are_trials = comparing.bins.count() == 1 && comparing.bins.runs >= enough_runs;
    if (are_trials && gate.kind == GateKind::bias && gate.against == Against::number)
        return judge_estimates(spec, gate, as_trials(gate, comparing.bins));
    std::optional<Bins> other;
    if (gate.against == Against::file && gate.kind != GateKind::std_error) {
        if (against == nullptr)
            refuse(gate, fmt::format("kind = \"{}\" has nothing to compare with. {}", name(gate.kind),
                                     gate.kind == GateKind::bias ? "Add reference = a number, or --against FILE.csv."
                                                                 : "Add --against FILE.csv."));
        other = bins_of(gate, *against);
        expect_same_bins(gate, comparing.bins, *other);
        refuse_equal_files(gate, comparing.bins, *other);
        if (gate.kind != GateKind::bias && !against->has_errors)
            refuse(gate,
                   fmt::format("kind = \"{}\" needs the column 'standard_error' of {} (both sides are uncertain). "
                               "Add it, or take kind = \"bias\" where these values are exact.",
                               name(gate.kind), against->origin));
    }
    switch (gate.kind) {
        case GateKind::std:
            compare_spreads(comparing);
            break;
        case GateKind::std_error:
            compare_errors(comparing);
            break;
        case GateKind::efficiency:
            compare_efficiencies(comparing, *other);
            break;
        default:
            compare_means(comparing, other ? &*other : nullptr);
            break;
    }
    return judge(spec, comparing);
}

}  // namespace ff::studies
