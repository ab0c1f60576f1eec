#include "studies/claim_judgements.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

namespace ff::studies {
namespace {

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

/// The method of the study with the smallest mean error on a class, among those at the claim's size; all of them where
/// nothing is left but rounding, which makes no winner.
std::string best_of_study(const ClaimEvidence& evidence, const PublishedClaim& claim, const std::string& pair_class) {
    const auto pairs = evidence.pairs(pair_class);
    std::vector<std::string> exact;
    std::string best;
    double smallest = INFINITY;
    for (std::size_t i = 0; i < evidence.findings().plan.cells.size(); ++i) {
        const Cell& cell = evidence.findings().plan.cells[i];
        const Method& method = evidence.findings().plan.spec.methods[cell.method];
        if (cell.scene != evidence.scene()) continue;
        const bool same_size = names(claim.patches_per_face, cell.subdivision.per_surface()) &&
                               (cell.deterministic || names(claim.samples_per_patch, cell.samples));
        if (!same_size || method.estimator == Estimator::closed_form || evidence.findings().cells[i].trials == 0)
            continue;
        const double error =
            mean_with_error(class_errors(evidence, i, pairs), evidence.findings().plan.spec.level).mean;
        if (error < rounding_percent && std::find(exact.begin(), exact.end(), method.name) == exact.end())
            exact.push_back(method.name);
        if (error >= smallest) continue;
        smallest = error;
        best = fmt::format("{} ({:.2g} %)", method.name, error);
    }
    return exact.empty() ? best : fmt::format("{} (exact to rounding)", fmt::join(exact, ", "));
}

}  // namespace

Judgement judge_smaller_sum_error(const ClaimEvidence& evidence, const PublishedClaim& claim) {
    const auto a = evidence.cells(claim, 0);
    const auto b = evidence.cells(claim, 1);
    if (a.empty() || b.empty()) return not_in_study();
    return compare_errors("Mean Σ r.e. of the row sums", claim.methods[0], evidence.sum_errors(a.front()),
                          claim.methods[1], evidence.sum_errors(b.front()), evidence.findings().plan.spec.level);
}

Judgement judge_smaller_error(const ClaimEvidence& evidence, const PublishedClaim& claim) {
    return judge_class(evidence, claim, 0, 1, claim.pair_class);
}

Judgement judge_division(const ClaimEvidence& evidence, const PublishedClaim& claim) {
    const Judgement parallel = judge_class(evidence, claim, 0, 1, "parallel");
    const Judgement adjacent = judge_class(evidence, claim, 1, 0, "adjacent");
    Judgement judgement{ClaimVerdict::inconclusive, parallel.evidence + " " + adjacent.evidence};
    if (parallel.verdict == ClaimVerdict::supported && adjacent.verdict == ClaimVerdict::supported)
        judgement.verdict = ClaimVerdict::supported;
    if (parallel.verdict == ClaimVerdict::refuted || adjacent.verdict == ClaimVerdict::refuted)
        judgement.verdict = ClaimVerdict::refuted;
    judgement.evidence += fmt::format(
        " Of all sampled and quadrature methods of this study at this size, best on parallel pairs: {}; on "
        "adjacent ones: {}.",
        best_of_study(evidence, claim, "parallel"), best_of_study(evidence, claim, "adjacent"));
    return judgement;
}

}  // namespace ff::studies
