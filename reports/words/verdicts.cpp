#include "reports/words/verdicts.hpp"

#include "reports/text/numbers.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>
#include <vector>

namespace ff::reports {
namespace {

/// Why some pairs, or all, are not tested.
std::string why_untested(const studies::BiasFamily& family) {
    if (family.few_trials) return "too few trials";
    if (family.undefined > 0) return "infinity or no number in some trials";
    std::vector<std::string_view> reasons;
    if (family.unknown > 0) reasons.emplace_back("no exact value");
    if (family.infinite > 0) reasons.emplace_back("infinite variance");
    if (reasons.empty() && family.sparse > 0) reasons.emplace_back("too few hits");
    return reasons.empty() ? "no spread" : fmt::format("{}", fmt::join(reasons, " or "));
}

bool has_exact_value(const studies::CellFindings& found) {
    return std::any_of(found.summaries.begin(), found.summaries.end(), [](const studies::Summary& summary) {
        return summary.quantity.kind == studies::QuantityKind::form_factor && summary.reference;
    });
}

}  // namespace

std::string bias_in_words(const studies::CellFindings& found) {
    if (found.trials == 0) return "no trials yet";
    if (!found.bias) return "deterministic: the error is the bias";
    switch (found.bias_finding) {
        case studies::BiasFinding::untestable:
            return fmt::format("no test: {}", has_exact_value(found) ? why_untested(*found.bias) : "no exact value");
        case studies::BiasFinding::biased:
            if (found.bias->constant_and_wrong) return "BIASED (one wrong value in every trial)";
            return fmt::format(
                "BIASED (t up to ±{:.1f}, {}){}", found.bias->largest_t, p_text(found.bias->adjusted_p),
                found.bias->undefined > 0 ? "; infinity or no number in some trials of other pairs" : "");
        case studies::BiasFinding::no_bias_found:
            break;
    }
    const std::string untested =
        found.bias->untestable == 0
            ? std::string()
            : fmt::format(" on {} of {} pairs, {} on the others", found.bias->pairs - found.bias->untestable,
                          found.bias->pairs, why_untested(*found.bias));
    return fmt::format("none found{} (would detect {})", untested, brief(found.bias->minimum_detectable_bias, 2));
}

std::string equivalence_in_words(const studies::CellFindings& found) {
    if (!found.bias || !found.bias->margin) return "";
    const std::string margin = brief(*found.bias->margin, 2);
    const std::string reach = brief(found.bias->shown_below, 2);
    switch (found.equivalence) {
        case studies::EquivalenceFinding::shown:
            return fmt::format("bias within ±{} shown (even ±{})", margin, reach);
        case studies::EquivalenceFinding::refuted:
            return fmt::format("bias within ±{} refuted", margin);
        case studies::EquivalenceFinding::inconclusive:
            return found.bias->untestable > 0 ? fmt::format("inconclusive: {}", why_untested(*found.bias))
                                              : fmt::format("bias within ±{} not shown (only ±{})", margin, reach);
        case studies::EquivalenceFinding::not_asked:
            break;
    }
    return "";
}

Mark bias_mark(const studies::CellFindings& found) {
    if (!found.bias) return Mark::none;
    switch (found.bias_finding) {
        case studies::BiasFinding::biased:
            return Mark::bad;
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

}  // namespace ff::reports
