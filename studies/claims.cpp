#include "studies/claims.hpp"

#include "stats/multiplicity.hpp"
#include "stats/quantiles.hpp"
#include "stats/variance_test.hpp"
#include "studies/claim_evidence.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

namespace ff::studies {
namespace {

struct Judgement {
    ClaimVerdict verdict = ClaimVerdict::inconclusive;
    std::string evidence;
};

Judgement not_in_study() {
    return {ClaimVerdict::inconclusive, "The study has no trials of the methods and sizes that the claim is about."};
}

std::string percent(const MeanWithError& value) {
    if (value.half_width == 0) return fmt::format("{:.3g} %", value.mean);
    const int decimals = std::max(0, 1 - static_cast<int>(std::floor(std::log10(value.half_width))));
    return fmt::format("{:.{}f} ± {:.{}f} %", value.mean, decimals, value.half_width, decimals);
}

std::string percent(const Share& share) {
    return fmt::format("{:.1f} % [{:.1f}, {:.1f}] of {} trials", 100 * share.value(), 100 * share.interval.low,
                       100 * share.interval.high, share.of);
}

/// Whether a sequence of errors falls, as far as its intervals tell.
ClaimVerdict falling(const std::vector<MeanWithError>& errors) {
    ClaimVerdict verdict = ClaimVerdict::supported;
    for (std::size_t i = 1; i < errors.size(); ++i) {
        if (errors[i].low() > errors[i - 1].high()) return ClaimVerdict::refuted;
        if (errors[i].high() >= errors[i - 1].low()) verdict = ClaimVerdict::inconclusive;
    }
    return verdict;
}

std::vector<MeanWithError> mean_sum_errors(const ClaimEvidence& evidence, const std::vector<std::size_t>& cells) {
    std::vector<MeanWithError> errors;
    for (const std::size_t cell : cells)
        errors.push_back(mean_with_error(evidence.sum_errors(cell), evidence.findings().plan.spec.level));
    return errors;
}

std::string ladder(const ClaimEvidence& evidence, const std::vector<std::size_t>& cells,
                   const std::vector<MeanWithError>& errors) {
    std::vector<std::string> rungs;
    for (std::size_t i = 0; i < cells.size(); ++i) {
        const Cell& cell = evidence.findings().plan.cells[cells[i]];
        const std::string samples = cell.deterministic ? "" : fmt::format(" × {} rays", cell.samples);
        rungs.push_back(
            fmt::format("{} at {} patches a face{}", percent(errors[i]), cell.subdivision.per_surface(), samples));
    }
    return fmt::format("Mean Σ r.e.: {}.", fmt::join(rungs, ", "));
}

Judgement judge_falling(const ClaimEvidence& evidence, const PublishedClaim& claim) {
    const auto cells = evidence.cells(claim, 0);
    if (cells.size() < 2) return not_in_study();
    const auto errors = mean_sum_errors(evidence, cells);
    return {falling(errors), ladder(evidence, cells, errors)};
}

/// True of single runs where a finer size often shows the larger error by chance, whatever the mean does.
Judgement judge_not_always_falling(const ClaimEvidence& evidence, const PublishedClaim& claim) {
    const auto cells = evidence.cells(claim, 0);
    if (cells.size() < 2) return not_in_study();
    std::string text;
    double least = 1;
    double most = 0;
    for (std::size_t i = 1; i < cells.size(); ++i) {
        const auto coarse = evidence.sum_errors(cells[i - 1]);
        const auto fine = evidence.sum_errors(cells[i]);
        const std::size_t trials = std::min(coarse.size(), fine.size());
        std::size_t worse = 0;
        for (std::size_t t = 0; t < trials; ++t) {
            if (fine[t] > coarse[t]) ++worse;
        }
        const Share share = share_of(worse, trials, evidence.findings().plan.spec.level);
        least = std::min(least, share.interval.low);
        most = std::max(most, share.interval.high);
        text += fmt::format("From {} to {} patches a face a single run gets worse in {}. ",
                            evidence.findings().plan.cells[cells[i - 1]].subdivision.per_surface(),
                            evidence.findings().plan.cells[cells[i]].subdivision.per_surface(), percent(share));
    }
    const auto errors = mean_sum_errors(evidence, cells);
    text += ladder(evidence, cells, errors);
    if (falling(errors) == ClaimVerdict::supported)
        text += " So it is chance: the mean error falls with every subdivision.";
    // "Not always" wants an event that really happens: more than one run in twenty.
    const auto verdict = least > 0.05  ? ClaimVerdict::supported
                         : most < 0.05 ? ClaimVerdict::refuted
                                       : ClaimVerdict::inconclusive;
    return {verdict, text};
}

/// Mean over pairs of the relative error, by trial.
std::vector<double> class_errors(const ClaimEvidence& evidence, std::size_t cell, const std::vector<Quantity>& pairs) {
    std::vector<double> errors;
    for (std::size_t t = 0; t < evidence.estimates(cell).trials(); ++t) {
        const auto each = evidence.pair_errors(cell, t, pairs);
        errors.push_back(std::accumulate(each.begin(), each.end(), 0.0) / static_cast<double>(each.size()));
    }
    return errors;
}

/// Whether the errors of `a` are smaller than those of `b`; a lone value stands for every trial.
Judgement compare_errors(const std::string& what, const std::string& name_a, const std::vector<double>& a,
                         const std::string& name_b, const std::vector<double>& b, double level) {
    const MeanWithError mean_a = mean_with_error(a, level);
    const MeanWithError mean_b = mean_with_error(b, level);
    const std::size_t trials = std::max(a.size(), b.size());
    std::size_t smaller = 0;
    for (std::size_t t = 0; t < trials; ++t) {
        if (a[a.size() == 1 ? 0 : t] < b[b.size() == 1 ? 0 : t]) ++smaller;
    }
    const auto verdict = mean_a.high() < mean_b.low()   ? ClaimVerdict::supported
                         : mean_a.low() > mean_b.high() ? ClaimVerdict::refuted
                                                        : ClaimVerdict::inconclusive;
    return {verdict, fmt::format("{}: {} {}, {} {}; {} is closer in {}.", what, name_a, percent(mean_a), name_b,
                                 percent(mean_b), name_a, percent(share_of(smaller, trials, level)))};
}

Judgement judge_smaller_sum_error(const ClaimEvidence& evidence, const PublishedClaim& claim) {
    const auto a = evidence.cells(claim, 0);
    const auto b = evidence.cells(claim, 1);
    if (a.empty() || b.empty()) return not_in_study();
    return compare_errors("Mean Σ r.e. of the row sums", claim.methods[0], evidence.sum_errors(a.front()),
                          claim.methods[1], evidence.sum_errors(b.front()), evidence.findings().plan.spec.level);
}

Judgement judge_class(const ClaimEvidence& evidence, const PublishedClaim& claim, std::size_t first, std::size_t second,
                      const std::string& pair_class) {
    const auto a = evidence.cells(claim, first);
    const auto b = evidence.cells(claim, second);
    if (a.empty() || b.empty()) return not_in_study();
    const auto pairs = evidence.pairs(pair_class);
    return compare_errors(fmt::format("Mean r.e. of {} pairs", pair_class), claim.methods[first],
                          class_errors(evidence, a.front(), pairs), claim.methods[second],
                          class_errors(evidence, b.front(), pairs), evidence.findings().plan.spec.level);
}

Judgement judge_smaller_error(const ClaimEvidence& evidence, const PublishedClaim& claim) {
    return judge_class(evidence, claim, 0, 1, claim.pair_class);
}

/// In each trial, on how many pairs the first method errs more than the bounds.
std::vector<double> counts_above(const ClaimEvidence& evidence, std::size_t cell, const std::vector<Quantity>& pairs,
                                 const std::vector<double>& bounds) {
    std::vector<double> counts;
    for (std::size_t t = 0; t < evidence.estimates(cell).trials(); ++t) {
        const auto errors = evidence.pair_errors(cell, t, pairs);
        double count = 0;
        for (std::size_t i = 0; i < pairs.size(); ++i) count += errors[i] > bounds[i] ? 1 : 0;
        counts.push_back(count);
    }
    return counts;
}

struct Opponent {
    std::string name;
    std::vector<double> errors;  ///< percent, by pair
};

/// The second method's errors as printed, which the claim is about, and as this study finds them.
std::vector<Opponent> opponents(const ClaimEvidence& evidence, const PublishedClaim& claim,
                                const std::vector<Quantity>& pairs) {
    std::vector<Opponent> list;
    if (auto printed = evidence.printed_errors(claim, 1, pairs); !printed.empty()) {
        list.push_back({fmt::format("the printed {} errors", claim.methods[1]), std::move(printed)});
    }
    const auto cells = evidence.cells(claim, 1);
    if (!cells.empty())
        list.push_back(
            {fmt::format("{} as computed here", claim.methods[1]), evidence.pair_errors(cells.front(), 0, pairs)});
    return list;
}

Judgement judge_count(const ClaimEvidence& evidence, const PublishedClaim& claim) {
    const auto cells = evidence.cells(claim, 0);
    const auto pairs = evidence.pairs(claim.pair_class);
    const auto rivals = opponents(evidence, claim, pairs);
    if (cells.empty() || rivals.empty() || !claim.number) return not_in_study();
    Judgement judgement;
    for (const Opponent& rival : rivals) {
        const auto counts = counts_above(evidence, cells.front(), pairs, rival.errors);
        const auto range = stats::central_range(counts, evidence.findings().plan.spec.level);
        const auto mean = mean_with_error(counts, evidence.findings().plan.spec.level);
        const bool inside = range->low <= *claim.number && *claim.number <= range->high;
        if (judgement.evidence.empty()) judgement.verdict = inside ? ClaimVerdict::supported : ClaimVerdict::refuted;
        judgement.evidence += fmt::format(
            "Against {}: {:.2f} ± {:.2f} of {} pairs in the mean, {:g} to {:g} in 95 % of single runs; the claim says "
            "{:g}. ",
            rival.name, mean.mean, mean.half_width, pairs.size(), range->low, range->high, *claim.number);
    }
    return judgement;
}

Judgement judge_not_always_smaller(const ClaimEvidence& evidence, const PublishedClaim& claim) {
    const auto cells = evidence.cells(claim, 0);
    const auto pairs = evidence.pairs(claim.pair_class);
    const auto rivals = opponents(evidence, claim, pairs);
    if (cells.empty() || rivals.empty()) return not_in_study();
    Judgement judgement;
    for (const Opponent& rival : rivals) {
        const auto counts = counts_above(evidence, cells.front(), pairs, rival.errors);
        const auto some = static_cast<std::size_t>(
            std::count_if(counts.begin(), counts.end(), [](double count) { return count > 0; }));
        const Share share = share_of(some, counts.size(), evidence.findings().plan.spec.level);
        const auto verdict = share.interval.low > 0.05    ? ClaimVerdict::supported
                             : share.interval.high < 0.05 ? ClaimVerdict::refuted
                                                          : ClaimVerdict::inconclusive;
        if (judgement.evidence.empty()) judgement.verdict = verdict;
        judgement.evidence +=
            fmt::format("Against {}: {} errs more on some pair in {}. ", rival.name, claim.methods[0], percent(share));
    }
    return judgement;
}

Judgement judge_uniform(const ClaimEvidence& evidence, const PublishedClaim& claim) {
    const auto cells = evidence.cells(claim, 0);
    if (cells.empty()) return not_in_study();
    Judgement judgement{ClaimVerdict::supported, ""};
    for (const std::string_view pair_class : {"parallel", "adjacent"}) {
        const auto pairs = evidence.pairs(pair_class);
        if (pairs.empty()) continue;
        const auto errors = evidence.pair_errors(cells.front(), 0, pairs);
        const auto [least, most] = std::minmax_element(errors.begin(), errors.end());
        // Equal but for rounding of the form factors (1e-14 of 0.2, in percent of it).
        if (*most - *least > 1e-6 * *most + 1e-11) judgement.verdict = ClaimVerdict::refuted;
        judgement.evidence += fmt::format("r.e. on {} pairs from {:.4g} % to {:.4g} %. ", pair_class, *least, *most);
    }
    judgement.evidence += "Uniform, then, over congruent pairs; not from one class of pairs to the other.";
    return judgement;
}

Judgement judge_nonuniform(const ClaimEvidence& evidence, const PublishedClaim& claim) {
    const auto cells = evidence.cells(claim, 0);
    const auto pairs = evidence.pairs("adjacent");
    if (cells.empty() || pairs.size() < 2) return not_in_study();
    std::vector<double> ratios;
    for (std::size_t t = 0; t < evidence.estimates(cells.front()).trials(); ++t) {
        const auto errors = evidence.pair_errors(cells.front(), t, pairs);
        ratios.push_back(*std::max_element(errors.begin(), errors.end()) /
                         std::accumulate(errors.begin(), errors.end(), 0.0) * static_cast<double>(errors.size()));
    }
    const auto range = stats::central_range(ratios, evidence.findings().plan.spec.level);
    std::vector<Quantity> by_std = pairs;
    const CellFindings& findings = evidence.findings().cells[cells.front()];
    std::sort(by_std.begin(), by_std.end(),
              [&](Quantity a, Quantity b) { return findings.summary(a).std < findings.summary(b).std; });
    const auto& least = evidence.estimates(cells.front()).values(by_std.front());
    const auto& most = evidence.estimates(cells.front()).values(by_std.back());
    const auto test = stats::test_variances_brown_forsythe(most, least);
    Judgement judgement;
    judgement.verdict = range->low > 1.5    ? ClaimVerdict::supported
                        : range->high < 1.5 ? ClaimVerdict::refuted
                                            : ClaimVerdict::inconclusive;
    judgement.evidence = fmt::format(
        "Within one run the largest r.e. of the {} adjacent pairs is {:.2f} to {:.2f} times their mean (95 % of "
        "runs). ",
        pairs.size(), range->low, range->high);
    if (test) {
        const double comparisons = static_cast<double>(pairs.size() * (pairs.size() - 1)) / 2;
        const double p = std::min(1.0, test->p * comparisons);
        judgement.evidence += fmt::format(
            "Over all runs their standard deviations, {:.3e} to {:.3e}, {} (Brown-Forsythe, Bonferroni p = {:.2g}): "
            "{}.",
            *findings.summary(by_std.front()).std, *findings.summary(by_std.back()).std,
            p < 0.05 ? "differ" : "do not differ detectably", p,
            p < 0.05 ? "some pairs are harder" : "which pair comes out worst is chance, not geometry");
    }
    return judgement;
}

/// The method of the study with the smallest mean error on a class, among those at the claim's size.
std::string best_of_study(const ClaimEvidence& evidence, const PublishedClaim& claim, const std::string& pair_class) {
    const auto pairs = evidence.pairs(pair_class);
    std::string best;
    double smallest = INFINITY;
    for (std::size_t i = 0; i < evidence.findings().plan.cells.size(); ++i) {
        const Cell& cell = evidence.findings().plan.cells[i];
        const Method& method = evidence.findings().plan.spec.methods[cell.method];
        const auto& sizes = claim.patches_per_face;
        const bool same_size = std::find(sizes.begin(), sizes.end(), cell.subdivision.per_surface()) != sizes.end() &&
                               (cell.deterministic || claim.samples_per_patch.empty() ||
                                std::find(claim.samples_per_patch.begin(), claim.samples_per_patch.end(),
                                          cell.samples) != claim.samples_per_patch.end());
        if (!same_size || method.estimator == Estimator::closed_form || evidence.findings().cells[i].trials == 0)
            continue;
        const double error =
            mean_with_error(class_errors(evidence, i, pairs), evidence.findings().plan.spec.level).mean;
        if (error >= smallest) continue;
        smallest = error;
        best = fmt::format("{} ({:.2g} %)", method.name, error);
    }
    return best;
}

/// First method better on parallel pairs and second on adjacent ones.
Judgement judge_division(const ClaimEvidence& evidence, const PublishedClaim& claim) {
    const Judgement parallel = judge_class(evidence, claim, 0, 1, "parallel");
    const Judgement adjacent = judge_class(evidence, claim, 1, 0, "adjacent");
    Judgement judgement{ClaimVerdict::inconclusive, parallel.evidence + " " + adjacent.evidence};
    if (parallel.verdict == ClaimVerdict::supported && adjacent.verdict == ClaimVerdict::supported)
        judgement.verdict = ClaimVerdict::supported;
    if (parallel.verdict == ClaimVerdict::refuted || adjacent.verdict == ClaimVerdict::refuted)
        judgement.verdict = ClaimVerdict::refuted;
    judgement.evidence += fmt::format(
        " Of all sampled and quadrature methods of this study at this size, {} is best on parallel pairs and {} on "
        "adjacent ones.",
        best_of_study(evidence, claim, "parallel"), best_of_study(evidence, claim, "adjacent"));
    return judgement;
}

struct Kind {
    std::string_view name;
    Judgement (*judge)(const ClaimEvidence&, const PublishedClaim&);
};

constexpr std::array kinds{
    Kind{"error_falls_with_subdivision", judge_falling},
    Kind{"error_falls_with_subdivision_not_always", judge_not_always_falling},
    Kind{"error_falls_with_samples", judge_falling},
    Kind{"smaller_sum_error", judge_smaller_sum_error},
    Kind{"smaller_error", judge_smaller_error},
    Kind{"smaller_error_not_always", judge_not_always_smaller},
    Kind{"count_larger_error", judge_count},
    Kind{"uniform_error", judge_uniform},
    Kind{"nonuniform_error", judge_nonuniform},
    Kind{"no_single_best", judge_division},
    Kind{"best_per_class", judge_division},
};

}  // namespace

std::string_view name(ClaimVerdict verdict) {
    switch (verdict) {
        case ClaimVerdict::supported:
            return "supported";
        case ClaimVerdict::refuted:
            return "refuted";
        case ClaimVerdict::inconclusive:
            break;
    }
    return "inconclusive";
}

std::vector<JudgedClaim> judge_claims(const Store& store, const Findings& findings, const PublishedTables& tables) {
    const ClaimEvidence evidence(store, findings, tables);
    std::vector<JudgedClaim> judged;
    for (const PublishedClaim& claim : tables.claims) {
        const auto kind = std::find_if(kinds.begin(), kinds.end(), [&](const Kind& k) { return k.name == claim.kind; });
        Judgement judgement{ClaimVerdict::inconclusive,
                            "A claim of this kind cannot be judged by numbers of the study."};
        if (kind != kinds.end()) judgement = kind->judge(evidence, claim);
        judged.push_back({claim, judgement.verdict, judgement.evidence});
    }
    return judged;
}

}  // namespace ff::studies
