#include "reports/words/findings/verdicts.hpp"

#include "reports/text/numbers.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string_view>
#include <vector>

namespace ff::reports {
namespace {

/// Why some pairs, or all, are not tested.
std::string why_untested(const studies::CellAnalysis& found) {
    const studies::BiasFamily& family = *found.bias;
    if (found.repeated_trials > 0)
        return fmt::format("trials repeat each other ({} of {})", found.repeated_trials, found.trials);
    if (family.few_trials) return "too few trials";
    if (family.not_finite > 0) return "infinity or no number in some trials";
    std::vector<std::string_view> reasons;
    if (family.no_exact_value > 0) reasons.emplace_back("no exact value");
    if (family.infinite_variance > 0) reasons.emplace_back("infinite variance");
    if (family.too_few_hits > 0) reasons.emplace_back("too few hits");
    if (family.too_skewed > 0) reasons.emplace_back("too few trials to rule out skewness");
    return reasons.empty() ? "no spread" : fmt::format("{}", fmt::join(reasons, " or "));
}

bool has_exact_value(const studies::CellAnalysis& found) {
    return std::any_of(found.summaries.begin(), found.summaries.end(), [](const studies::Summary& summary) {
        return summary.quantity.kind == studies::QuantityKind::form_factor && summary.reference;
    });
}

/// Fewer trials than this cannot show that they are not skewed.
constexpr std::size_t enough_trials = 30;

std::string_view undefined_in_words(const studies::BiasFamily& family) {
    return family.not_finite > 0 ? "; infinity or no number in some trials of other pairs" : "";
}

/// ", unless a value of 4.2 occurs less often than once in 64 trials"; empty where no value would change a verdict.
std::string unless_unseen(const std::optional<stats::UnseenValue>& unseen) {
    if (!unseen) return {};
    return fmt::format(", unless a value of {} occurs less often than once in {:.0f} trials", brief(unseen->value, 2),
                       std::ceil(unseen->one_in));
}

/// "BIASED (t up to ±9.1, p = ...), unless a value of 4.2 occurs less often than once in 64 trials"
std::string biased_in_words(const studies::CellAnalysis& found) {
    const studies::BiasFamily& family = *found.bias;
    if (family.constant_and_wrong) return "BIASED (one wrong value in every trial)";
    return fmt::format("BIASED (t up to ±{:.1f}, {}){}{}", family.largest_t, p_text(family.adjusted_p),
                       unless_unseen(family.unseen), undefined_in_words(family));
}

/// The words for a difference that a skewed law without bias would show, too.
std::string inconclusive_in_words(const studies::CellAnalysis& found) {
    const studies::BiasFamily& family = *found.bias;
    if (family.constant)
        return fmt::format(
            "inconclusive: one wrong value in every trial, but values too rare to be met may make up for it{}",
            undefined_in_words(family));
    const std::string_view why = family.heavy_tails      ? "the tails are too heavy for a verdict"
                                 : family.may_be_unmet   ? "perhaps no evaluation met what would explain it"
                                 : family.others_explain ? "trials of other pairs are skewed enough to explain it"
                                 : found.trials < enough_trials ? "too few trials to rule out skewness"
                                                                : "the trials are too skewed for a verdict";
    return fmt::format("inconclusive: t up to ±{:.1f}, but {}{}", family.largest_t, why, undefined_in_words(family));
}

}  // namespace

std::string bias_in_words(const studies::CellAnalysis& found) {
    if (found.trials == 0) return "no trials yet";
    if (!found.bias) return "deterministic";
    switch (found.bias_finding) {
        case studies::BiasFinding::untestable:
            return fmt::format("no test: {}", has_exact_value(found) ? why_untested(found) : "no exact value");
        case studies::BiasFinding::biased:
            return biased_in_words(found);
        case studies::BiasFinding::inconclusive:
            return inconclusive_in_words(found);
        case studies::BiasFinding::no_bias_found:
            break;
    }
    const std::string untested = found.bias->untestable == 0 ? std::string()
                                                             : fmt::format(" on {} of {} pairs, {} on the others",
                                                                           found.bias->pairs - found.bias->untestable,
                                                                           found.bias->pairs, why_untested(found));
    return fmt::format("none found{} ({})", untested, brief(found.bias->minimum_detectable_bias.value_or(0), 2));
}

std::string equivalence_in_words(const studies::CellAnalysis& found) {
    if (!found.bias || !found.bias->margin) return "";
    const std::string reach = std::isfinite(found.bias->shown_below)
                                  ? fmt::format("±{}", brief(found.bias->shown_below, 2))
                                  : "the trials are too few, or too skewed, for an interval";
    switch (found.equivalence) {
        case studies::EquivalenceFinding::shown:
            return fmt::format("shown ({}){}", reach, unless_unseen(found.bias->unseen_beyond_margin));
        case studies::EquivalenceFinding::refuted:
            return "refuted";
        case studies::EquivalenceFinding::inconclusive:
            return found.bias->untestable > 0 ? fmt::format("inconclusive: {}", why_untested(found))
                                              : fmt::format("not shown ({})", reach);
        case studies::EquivalenceFinding::not_asked:
            break;
    }
    return "";
}

std::string margin_title(const studies::StudySpec& spec) {
    return fmt::format("bias within ±{}", brief(*spec.equivalence_margin, 2));
}

Mark bias_mark(const studies::CellAnalysis& found) {
    if (!found.bias) return Mark::none;
    switch (found.bias_finding) {
        case studies::BiasFinding::biased:
            return Mark::bad;
        case studies::BiasFinding::inconclusive:
        case studies::BiasFinding::untestable:
            return Mark::open;
        case studies::BiasFinding::no_bias_found:
            break;
    }
    return Mark::good;
}

Mark equivalence_mark(studies::EquivalenceFinding finding) {
    switch (finding) {
        case studies::EquivalenceFinding::shown:
            return Mark::good;
        case studies::EquivalenceFinding::refuted:
            return Mark::bad;
        case studies::EquivalenceFinding::inconclusive:
            return Mark::open;
        case studies::EquivalenceFinding::not_asked:
            break;
    }
    return Mark::none;
}

std::string counted_cells(const studies::StudyPlan& plan) {
    return plan.scenes.size() == 1 ? "sampled methods and sizes" : "sampled methods and sizes of all scenes";
}

BiasTally tally_of(const studies::Analysis& findings) {
    BiasTally tally;
    for (const studies::CellAnalysis& found : findings.cells) {
        const studies::Method& method = findings.plan.spec.methods[findings.plan.cells[found.cell].method];
        if (studies::estimator_info(method).observes == Observes::hits)
            tally.lost_rays = tally.lost_rays.value_or(0) + found.lost_rays;
        if (!found.bias) continue;
        ++tally.sampled;
        ++tally.found[found.bias_finding];
        const bool is_clear = found.bias_finding == studies::BiasFinding::no_bias_found;
        tally.partly += is_clear && found.bias->untestable > 0 ? 1u : 0u;
        tally.shown += found.equivalence == studies::EquivalenceFinding::shown ? 1 : 0;
        if (const auto least = found.bias->minimum_detectable_bias) tally.detectable.push_back(*least);
    }
    std::ranges::sort(tally.detectable);
    return tally;
}

}  // namespace ff::reports
