#include "studies/claims/claim_evidence.hpp"

#include "stats/basics/quantiles.hpp"
#include "studies/analysis/pair_spreads.hpp"
#include "studies/diagnostics/coverage.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

namespace ff::studies {
namespace {

/// The number of pairs, in each trial, on which the first method errs more than the bounds.
std::vector<double> counts_above(const ClaimEvidence& evidence, std::size_t cell, const std::vector<Quantity>& pairs,
                                 const std::vector<double>& bounds) {
    std::vector<double> counts;
    for (std::size_t t = 0; t < evidence.cells().load(cell)->trials(); ++t) {
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

/// The verdict against the first opponent, with a remark where another opponent leads to a different one.
template <typename Judge>
Judgement against_each(const std::vector<Opponent>& rivals, const Judge& judge) {
    Judgement all;
    for (const Opponent& rival : rivals) {
        const Judgement one = judge(rival);
        const bool first = &rival == &rivals.front();
        if (first) all.verdict = one.verdict;
        all.evidence += fmt::format("{}Against {}: {}.", first ? "" : " ", rival.name, one.evidence);
        if (one.verdict != all.verdict) {
            all.as_printed_only = true;
            if (all.verdict == ClaimVerdict::supported) all.verdict = ClaimVerdict::as_printed_only;
            all.evidence += fmt::format(" Against these the claim is {}.", name(one.verdict));
        }
    }
    return all;
}

}  // namespace

Judgement judge_count(const ClaimEvidence& evidence, const PublishedClaim& claim) {
    const auto cells = evidence.cells(claim, 0);
    const auto pairs = evidence.pairs(claim.pair_class);
    const auto rivals = opponents(evidence, claim, pairs);
    if (cells.empty() || rivals.empty() || !claim.number) return not_in_study();
    const double level = evidence.level();
    return against_each(rivals, [&](const Opponent& rival) -> Judgement {
        const auto counts = counts_above(evidence, cells.front(), pairs, rival.errors);
        const auto range = stats::central_range(counts, level);
        const auto mean = mean_with_error(counts, level);
        const bool inside = range->low <= *claim.number && *claim.number <= range->high;
        // The ends of the range want some trials beyond them.
        const bool known = static_cast<double>(counts.size()) * (1 - level) >= 2;
        const auto verdict = !known   ? ClaimVerdict::inconclusive
                             : inside ? ClaimVerdict::supported
                                      : ClaimVerdict::refuted;
        return {
            verdict,
            fmt::format("{:.2f}{} of {} pairs in the mean, {:g} to {:g} in {:g} % of single runs; the claim says {:g}",
                        mean.mean, std::isfinite(mean.half_width) ? fmt::format(" ± {:.2f}", mean.half_width) : "",
                        pairs.size(), range->low, range->high, 100 * level, *claim.number)};
    });
}

Judgement judge_not_always_smaller(const ClaimEvidence& evidence, const PublishedClaim& claim) {
    const auto cells = evidence.cells(claim, 0);
    const auto pairs = evidence.pairs(claim.pair_class);
    const auto rivals = opponents(evidence, claim, pairs);
    if (cells.empty() || rivals.empty()) return not_in_study();
    return against_each(rivals, [&](const Opponent& rival) -> Judgement {
        const auto counts = counts_above(evidence, cells.front(), pairs, rival.errors);
        const auto some = std::ranges::count_if(counts, [](double count) { return count > 0; });
        const Share share = share_of(static_cast<std::size_t>(some), counts.size(), evidence.level());
        // "Not always" wants an event that really happens: more than one run in twenty.
        return {is_above(share.interval.low, share.interval.high, 0.05),
                fmt::format("{} has the larger error on some pair in {}", claim.methods[0], percent(share))};
    });
}

Judgement judge_uniform(const ClaimEvidence& evidence, const PublishedClaim& claim) {
    const auto cells = evidence.cells(claim, 0);
    if (cells.empty()) return not_in_study();
    Judgement judgement{ClaimVerdict::supported, ""};
    for (const std::string_view pair_class : {"parallel", "adjacent"}) {
        const auto pairs = evidence.pairs(pair_class);
        if (pairs.empty()) continue;
        const auto errors = evidence.pair_errors(cells.front(), 0, pairs);
        const auto [least, most] = std::ranges::minmax_element(errors);
        if (*most - *least > 1e-6 * *most + rounding_percent) judgement.verdict = ClaimVerdict::refuted;
        judgement.evidence += *most < rounding_percent ? fmt::format("{} pairs are exact to rounding. ", pair_class)
                                                       : fmt::format("r.e. on {} pairs from {:.4g} % to {:.4g} %. ",
                                                                     pair_class, *least, *most);
    }
    judgement.evidence += "Uniform, then, over congruent pairs; not from one class of pairs to the other.";
    return judgement;
}

/// Says which pairs are hardest and easiest by all runs together; empty where a pair's variance may be infinite.
std::string hardest_and_easiest(const ClaimEvidence& evidence, std::size_t cell, const std::vector<Quantity>& pairs) {
    const StudyPlan& plan = evidence.findings().plan;
    const CellAnalysis& found = evidence.findings().cells[cell];
    const PairSpreads spreads = spreads_of(plan, found, *evidence.cells().load(cell), pairs);
    const auto& logarithms = spreads.logarithms;
    if (!std::ranges::all_of(logarithms, [](const auto& each) { return each.has_value(); })) return {};
    const auto [least, most] =
        std::ranges::minmax_element(logarithms, [](const auto& a, const auto& b) { return a->value < b->value; });
    const auto both = compared_spreads({{*least}, spreads.skewness}, {{*most}, spreads.skewness}, 0);
    // These two were chosen by their values, so that the interval has to hold for all couples.
    const double couples = static_cast<double>(pairs.size() * (pairs.size() - 1)) / 2;
    const auto ratio = ratio_interval((*both)[0], (*both)[1], 1 - (1 - plan.spec.level) / couples);
    if (!ratio || !ratio->is_finite()) return {};
    return fmt::format(
        " Over all runs the largest of their standard deviations is {:.2f} to {:.2f} times the smallest: {}.",
        std::sqrt(std::max(1.0, ratio->low)), std::sqrt(ratio->high),
        ratio->low > 1 ? "some pairs are harder" : "no pair is shown to be harder than another");
}

Judgement judge_nonuniform(const ClaimEvidence& evidence, const PublishedClaim& claim) {
    const auto cells = evidence.cells(claim, 0);
    const auto pairs = evidence.pairs("adjacent");
    if (cells.empty() || pairs.size() < 2) return not_in_study();
    std::vector<double> ratios;
    for (std::size_t t = 0; t < evidence.cells().load(cells.front())->trials(); ++t) {
        const auto errors = evidence.pair_errors(cells.front(), t, pairs);
        ratios.push_back(*std::ranges::max_element(errors) / std::accumulate(errors.begin(), errors.end(), 0.0) *
                         static_cast<double>(errors.size()));
    }
    const double level = evidence.level();
    const auto range = stats::central_range(ratios, level);
    Judgement judgement;
    judgement.verdict = is_above(range->low, range->high, 1.5);
    judgement.evidence = fmt::format(
        "Within one run the largest r.e. of the {} adjacent pairs is {:.2f} to {:.2f} times their mean ({:g} % of "
        "runs).",
        pairs.size(), range->low, range->high, 100 * level);
    judgement.evidence += hardest_and_easiest(evidence, cells.front(), pairs);
    return judgement;
}

Judgement judge_claimed_errors_hold(const ClaimEvidence& evidence, const PublishedClaim& claim) {
    const auto cells = evidence.cells(claim, 0);
    std::uint64_t claims = 0;
    std::uint64_t held = 0;
    double largest = 0;
    for (const ClaimedErrors& found : judge_claimed_errors(evidence.cells())) {
        const bool in_question =
            claim.pair_class.empty() || claim.pair_class == "all" || claim.pair_class == name(found.pair_class);
        if (!in_question || found.claimant == Claimant::one_run || std::ranges::find(cells, found.cell) == cells.end())
            continue;
        claims += found.claims;
        held += found.held;
        largest = std::max(largest, found.largest_ratio);
    }
    if (claims == 0) return not_in_study();
    const std::string evidence_text = fmt::format(
        "{} of {} factors were off by no more than was claimed of them; the largest error was {:.2g} times "
        "as large as claimed.",
        held, claims, largest);
    return {held == claims ? ClaimVerdict::supported : ClaimVerdict::refuted, evidence_text};
}

}  // namespace ff::studies
