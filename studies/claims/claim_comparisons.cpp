#include "studies/claims/claim_evidence.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <string_view>
#include <vector>

namespace ff::studies {
namespace {

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
    for (const std::size_t cell : cells) errors.push_back(mean_with_error(evidence.sum_errors(cell), evidence.level()));
    return errors;
}

std::string ladder(const ClaimEvidence& evidence, const std::vector<std::size_t>& cells,
                   const std::vector<MeanWithError>& errors) {
    std::vector<std::string> rungs;
    for (std::size_t i = 0; i < cells.size(); ++i) {
        const Cell& cell = evidence.findings().plan.cells[cells[i]];
        const std::string samples =
            cell.samples_per_patch == 0
                ? ""
                : fmt::format(" × {} {}", cell.samples_per_patch, cell.deterministic ? "evaluations" : "rays");
        const auto patches = cell.subdivision.per_part();
        rungs.push_back(fmt::format("{} at {} {} per face{}", percent(errors[i]), patches,
                                    patches == 1 ? "patch" : "patches", samples));
    }
    return fmt::format("Mean Σ r.e.: {}.", fmt::join(rungs, ", "));
}

/// Mean over pairs of the relative error, by trial.
std::vector<double> class_errors(const ClaimEvidence& evidence, std::size_t cell, const std::vector<Quantity>& pairs) {
    std::vector<double> errors;
    for (std::size_t t = 0; t < evidence.cells().load(cell)->trials(); ++t) {
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

Judgement judge_class(const ClaimEvidence& evidence, const PublishedClaim& claim, std::size_t first, std::size_t second,
                      const std::string& pair_class) {
    const auto a = evidence.cells(claim, first);
    const auto b = evidence.cells(claim, second);
    if (a.empty() || b.empty()) return not_in_study();
    const auto pairs = evidence.pairs(pair_class);
    return compare_errors(fmt::format("Mean r.e. of {} pairs", pair_class), claim.methods[first],
                          class_errors(evidence, a.front(), pairs), claim.methods[second],
                          class_errors(evidence, b.front(), pairs), evidence.level());
}

/// A method of the study, and its mean error on a class of pairs.
struct Competitor {
    std::string name;
    MeanWithError error;  ///< the intervals of all competitors of a claim hold at once: the best of many is picked
    bool deterministic = false;

    [[nodiscard]] bool is_exact() const { return error.mean < rounding_percent; }
};

/// Sampled and quadrature methods at the claim's size, by mean error on each class of pairs.
struct Competitors {
    std::vector<Competitor> parallel;
    std::vector<Competitor> adjacent;
};

Competitors competitors(const ClaimEvidence& evidence, const PublishedClaim& claim) {
    const StudyPlan& plan = evidence.findings().plan;
    auto cells = evidence.cells(claim);
    std::erase_if(cells, [&](std::size_t i) { return estimator_info(plan.spec.methods[plan.cells[i].method]).exact; });
    const double level = 1 - (1 - plan.spec.level) / (2 * static_cast<double>(std::max<std::size_t>(cells.size(), 1)));
    const auto sorted = [&](const std::string& pair_class) {
        const auto pairs = evidence.pairs(pair_class);
        std::vector<Competitor> result;
        for (const std::size_t cell : cells) {
            result.push_back({plan.spec.methods[plan.cells[cell].method].name,
                              mean_with_error(class_errors(evidence, cell, pairs), level),
                              plan.cells[cell].deterministic});
        }
        std::ranges::stable_sort(result, {}, [](const Competitor& each) { return each.error.mean; });
        return result;
    };
    return {sorted("parallel"), sorted("adjacent")};
}

/// The names of those competitors that pass, each once.
std::vector<std::string> names_where(const std::vector<Competitor>& all, auto passes) {
    std::vector<std::string> names;
    for (const Competitor& each : all) {
        if (passes(each) && std::ranges::find(names, each.name) == names.end()) names.push_back(each.name);
    }
    return names;
}

/// The methods that are not shown to err more than the first, which then is not shown to be the best: "A or B".
std::string unbeaten(const std::vector<Competitor>& sorted) {
    const double high = sorted.front().error.high();
    const auto names = names_where(sorted, [&](const Competitor& each) { return !(each.error.low() > high); });
    return fmt::format("{}", fmt::join(names, " or "));
}

/// The best method; all of them where only rounding is left, so that there is no winner.
std::string best_in_words(const std::vector<Competitor>& sorted) {
    if (sorted.empty()) return "none";
    if (!sorted.front().is_exact()) return fmt::format("{} ({:.2g} %)", unbeaten(sorted), sorted.front().error.mean);
    const auto exact = names_where(sorted, [](const Competitor& each) { return each.is_exact(); });
    return fmt::format("{} (exact to rounding)", fmt::join(exact, ", "));
}

/// The best method of a kind, and the range of its error, whichever of them is the best.
struct BestOfKind {
    std::string words;
    double low = 0;
    double high = 0;
};

std::optional<BestOfKind> best_of_kind(std::vector<Competitor> sorted, bool deterministic) {
    std::erase_if(sorted, [&](const Competitor& each) { return each.deterministic != deterministic; });
    if (sorted.empty()) return std::nullopt;
    const MeanWithError& first = sorted.front().error;
    BestOfKind best{fmt::format("{} ({})", unbeaten(sorted), percent(first)), first.low(), first.high()};
    for (const Competitor& competitor : sorted) {
        best.low = std::min(best.low, competitor.error.low());
        best.high = std::min(best.high, competitor.error.high());
    }
    return best;
}

/// Whether, on a class of pairs, the best method of the kind that is advised has less error than the best of the other.
std::optional<Judgement> judge_rule(const std::vector<Competitor>& sorted, bool deterministic_advised) {
    const auto advised = best_of_kind(sorted, deterministic_advised);
    const auto other = best_of_kind(sorted, !deterministic_advised);
    if (!advised || !other) return std::nullopt;
    const auto verdict = advised->high < other->low   ? ClaimVerdict::supported
                         : advised->low > other->high ? ClaimVerdict::refuted
                                                      : ClaimVerdict::inconclusive;
    return Judgement{verdict, fmt::format("{} against {}", advised->words, other->words)};
}

ClaimVerdict both(ClaimVerdict a, ClaimVerdict b) {
    if (a == ClaimVerdict::refuted || b == ClaimVerdict::refuted) return ClaimVerdict::refuted;
    return a == b ? a : ClaimVerdict::inconclusive;
}

std::string_view right_or_wrong(ClaimVerdict verdict) {
    switch (verdict) {
        case ClaimVerdict::supported:
            return "right";
        case ClaimVerdict::as_printed_only:
            return "right by the printed figures only";
        case ClaimVerdict::refuted:
            return "wrong";
        case ClaimVerdict::inconclusive:
            break;
    }
    return "neither shown to be right nor to be wrong";
}

/// The advice itself: as between the two methods, and as a rule about their kinds where others of the study are better.
std::string advice_in_words(const PublishedClaim& claim, ClaimVerdict verdict, const Competitors& all, double level) {
    std::string words = fmt::format(
        "Between these two methods the advice ({} for parallel faces, {} for perpendicular ones) was {}, with {:g} % "
        "confidence.",
        claim.methods[0], claim.methods[1], right_or_wrong(verdict), 100 * level);
    const auto on_parallel = judge_rule(all.parallel, true);
    const auto on_adjacent = judge_rule(all.adjacent, false);
    if (!on_parallel || !on_adjacent) return words + " ";
    return words +
           fmt::format(
               " As a rule (deterministic for parallel faces, Monte Carlo for perpendicular ones) it was {} among the "
               "methods of this study at this size. The best of each kind, with intervals that hold for all methods at "
               "once: on parallel pairs {}; on perpendicular ones {}. ",
               right_or_wrong(both(on_parallel->verdict, on_adjacent->verdict)), on_parallel->evidence,
               on_adjacent->evidence);
}

/// The comparison of the two methods, and the best one of all.
Judgement judge_division_among(const ClaimEvidence& evidence, const PublishedClaim& claim, const Competitors& all) {
    const Judgement parallel = judge_class(evidence, claim, 0, 1, "parallel");
    const Judgement adjacent = judge_class(evidence, claim, 1, 0, "adjacent");
    return {
        both(parallel.verdict, adjacent.verdict),
        fmt::format("{} {} Of all sampled and quadrature methods of this study at this size, best on parallel "
                    "pairs: {}; on adjacent ones: {}.",
                    parallel.evidence, adjacent.evidence, best_in_words(all.parallel), best_in_words(all.adjacent))};
}

}  // namespace

Judgement judge_falling(const ClaimEvidence& evidence, const PublishedClaim& claim) {
    const auto cells = evidence.cells(claim, 0);
    if (cells.size() < 2) return not_in_study();
    const auto errors = mean_sum_errors(evidence, cells);
    return {falling(errors), ladder(evidence, cells, errors)};
}

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
        const Share share = share_of(worse, trials, evidence.level());
        least = std::min(least, share.interval.low);
        most = std::max(most, share.interval.high);
        text += fmt::format("From {} to {} patches per face a single run gets worse in {}. ",
                            evidence.findings().plan.cells[cells[i - 1]].subdivision.per_part(),
                            evidence.findings().plan.cells[cells[i]].subdivision.per_part(), percent(share));
    }
    const auto errors = mean_sum_errors(evidence, cells);
    text += ladder(evidence, cells, errors);
    if (falling(errors) == ClaimVerdict::supported)
        text += " So it is chance: the mean error falls with every subdivision.";
    // "Not always" wants an event that really happens: more than one run in twenty.
    return {is_above(least, most, 0.05), text};
}

Judgement judge_smaller_sum_error(const ClaimEvidence& evidence, const PublishedClaim& claim) {
    const auto a = evidence.cells(claim, 0);
    const auto b = evidence.cells(claim, 1);
    if (a.empty() || b.empty()) return not_in_study();
    return compare_errors("Mean Σ r.e. of the row sums", claim.methods[0], evidence.sum_errors(a.front()),
                          claim.methods[1], evidence.sum_errors(b.front()), evidence.level());
}

Judgement judge_smaller_error(const ClaimEvidence& evidence, const PublishedClaim& claim) {
    return judge_class(evidence, claim, 0, 1, claim.pair_class);
}

Judgement judge_division(const ClaimEvidence& evidence, const PublishedClaim& claim) {
    return judge_division_among(evidence, claim, competitors(evidence, claim));
}

Judgement judge_advice(const ClaimEvidence& evidence, const PublishedClaim& claim) {
    const Competitors all = competitors(evidence, claim);
    Judgement judgement = judge_division_among(evidence, claim, all);
    if (evidence.cells(claim, 0).empty() || evidence.cells(claim, 1).empty()) return judgement;
    judgement.evidence = advice_in_words(claim, judgement.verdict, all, evidence.level()) + judgement.evidence;
    return judgement;
}

}  // namespace ff::studies
