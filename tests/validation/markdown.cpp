#include "tests/validation/markdown.hpp"

#include "reports/text/numbers.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>

namespace ff::studies {
namespace {

using reports::brief;

std::string claim_text(const MeasuredRate& rate) {
    switch (rate.claim) {
        case RateClaim::equal:
            return brief(rate.claimed);
        case RateClaim::at_most:
            return "≤ " + brief(rate.claimed);
        case RateClaim::at_least:
            return "≥ " + brief(rate.claimed);
        case RateClaim::none:
            break;
    }
    return "–";
}

constexpr std::string_view holds_text(bool holds) {
    return holds ? "yes" : "**no**";
}

/// The cells "rate", "interval" and "claimed".
std::string rate_cells(const MeasuredRate& rate, double level) {
    const stats::Interval interval = interval_of(rate, level);
    return fmt::format("{} | {} … {} | {}",
                       brief(static_cast<double>(rate.counts.hits) / static_cast<double>(rate.counts.trials)),
                       brief(interval.low), brief(interval.high), claim_text(rate));
}

constexpr std::string_view header_of_sections =
    "| section | claims | hold | nearest to its limit | rate | interval | claimed |\n"
    "|---|--:|--:|---|--:|---|--:|\n";

Pages begin_pages(const std::string& how_measured, std::size_t contradictions,
                  std::string_view header = header_of_sections) {
    const std::string claims =
        contradictions == 0 ? "**All claims hold.**" : fmt::format("**{} claim(s) do not hold.**", contradictions);
    const std::string beginning = fmt::format("{} {}\n\n", how_measured, claims);
    return {.summary = beginning + std::string(header), .tables = beginning};
}

void add_rates(const RateTable& table, double level, Pages& pages) {
    pages.tables += fmt::format(
        "### {}\n\n{}\n\n| what | times | of | rate | interval | claimed | holds |\n|---|--:|--:|--:|---|--:|---|\n",
        table.title, table.text);
    for (const MeasuredRate& rate : table.rates) {
        pages.tables +=
            fmt::format("| {} | {} | {} | {} | {} |\n", rate.what, rate.counts.hits, rate.counts.trials,
                        rate_cells(rate, level), rate.claim == RateClaim::none ? "–" : holds_text(holds(rate, level)));
    }
    pages.tables += "\n";
}

/// A table without a claim is not in the summary.
void add_table(const RateTable& table, double level, Pages& pages) {
    add_rates(table, level, pages);
    const std::size_t claims = table.claims();
    if (claims == 0) return;
    const MeasuredRate& nearest = *std::ranges::min_element(table.rates, {}, tail_of);
    pages.summary += fmt::format("| {} | {} | {} | {} | {} |\n", table.title, claims,
                                 claims - table.contradictions(level), nearest.what, rate_cells(nearest, level));
}

void add_p_values(const gates::Selftest& selftest, Pages& pages) {
    const std::vector<gates::PValues>& all = selftest.calibration.p_values;
    pages.tables +=
        "### p-values\n\nOne-sided p-values of gates whose effect lies exactly at the end of the band, against uniform "
        "ones (Kolmogorov and Smirnov).\n\n| what | values | distance | p | holds |\n|---|--:|--:|--:|---|\n";
    const auto holds = [&](const gates::PValues& values) { return values.p >= 1 - selftest.level; };
    for (const gates::PValues& values : all) {
        pages.tables += fmt::format("| {} | {} | {} | {} | {} |\n", values.what, values.n, brief(values.distance),
                                    reports::p_value(values.p), holds_text(holds(values)));
    }
    pages.tables += "\n";
    const gates::PValues& nearest = *std::ranges::min_element(all, {}, &gates::PValues::p);
    pages.summary += fmt::format("| p-values | {} | {} | {} | p = {} | – | uniform |\n", all.size(),
                                 std::ranges::count_if(all, holds), nearest.what, reports::p_value(nearest.p));
}

std::string share_text(const stats::Proportion& share) {
    return share.trials == 0 ? "–" : brief(static_cast<double>(share.hits) / static_cast<double>(share.trials), 6);
}

std::string_view verdict_text(const MeasuredRate& rate, double level) {
    switch (form_factors::verdict_of(rate, level)) {
        case form_factors::ClaimVerdict::holds:
            return "holds";
        case form_factors::ClaimVerdict::fails:
            return "**does not hold**";
        case form_factors::ClaimVerdict::open:
            break;
    }
    return "too little to say";
}

/// The share and its interval, and what they say about the claim.
std::string claim_cells(const MeasuredRate& rate, double level) {
    const stats::Interval interval = interval_of(rate, level);
    return fmt::format("{} | {} … {} | {}", share_text(rate.counts), brief(interval.low, 4), brief(interval.high, 4),
                       verdict_text(rate, level));
}

}  // namespace

Pages markdown(const gates::Selftest& selftest) {
    const gates::SelftestOptions& options = selftest.options;
    Pages result = begin_pages(
        fmt::format("`ffstudy-validate gates --seed {} --seeds {} --repetitions {}` printed what follows. Intervals "
                    "are those of Clopper and Pearson at level {:.5f}, so that with probability 0.99 all rows hold "
                    "together if all claims are right.",
                    options.seed.value, options.seeds, options.repetitions, selftest.level),
        selftest.contradictions());
    for (const RateTable& table : selftest.tables()) {
        add_table(table, selftest.level, result);
        if (table.title == selftest.calibration.false_alarms.title) add_p_values(selftest, result);
    }
    if (!selftest.detection.refused.empty()) {
        result.tables += "### Refused before anything is run\n\n";
        for (const std::string& message : selftest.detection.refused) result.tables += fmt::format("- {}\n", message);
    }
    return result;
}

Pages markdown(const form_factors::FormFactorCoverage& coverage) {
    const form_factors::FormFactorCoverageOptions& options = coverage.options;
    Pages result = begin_pages(
        fmt::format("`ffstudy-validate form_factors --seed {} --seeds {} --tolerance {}` printed what follows. "
                    "Intervals are those of Clopper and Pearson at level {:.5f} (Šidák), so that all rows hold "
                    "together with probability 0.95 if all claims are right. Of {} values that are computed with a "
                    "bound of the error, in all runs, {} lay outside it. {} runs missed the tolerance.",
                    options.seed.value, options.seeds, brief(options.tolerance), coverage.level, coverage.exact_pairs,
                    coverage.exact_missed, coverage.out_of_tolerance),
        coverage.contradictions());
    for (const RateTable* table : coverage.tables()) add_table(*table, coverage.level, result);
    return result;
}

Pages markdown(const form_factors::FacetCoverage& coverage) {
    const form_factors::FacetCoverageOptions& options = coverage.options;
    std::size_t claims = 0;
    std::size_t shown = 0;
    for (const form_factors::FacetKind& kind : coverage.kinds) {
        claims += kind.rates.claims();
        shown += static_cast<std::size_t>(std::ranges::count_if(kind.rates.rates, [&](const MeasuredRate& rate) {
            return rate.claim != RateClaim::none &&
                   form_factors::verdict_of(rate, coverage.level) == form_factors::ClaimVerdict::holds;
        }));
    }
    Pages result = begin_pages(
        fmt::format("`ffstudy-validate facets --seed {} --seeds {} --pairs {}` printed what follows of {}. Intervals "
                    "are those of Clopper and Pearson at level {:.5f} (Šidák), so that all claims hold together with "
                    "probability 0.95 if all are right. {} of {} references are wider than a hundredth of the "
                    "tolerance of 1e-4. {} of {} claims hold by the whole of their intervals.",
                    options.seed.value, options.seeds, options.pairs, coverage.scenes, coverage.level,
                    coverage.wide_references, coverage.references, shown, claims),
        coverage.contradictions(),
        "| method | claims | pairs | inside | interval | at least 0.95 | beyond | interval | at most 0.001 "
        "| all entries | inside | inside, fine reference | beyond | worst excess |\n"
        "|---|--:|--:|--:|---|---|--:|---|---|--:|--:|--:|--:|--:|\n");
    for (const form_factors::FacetKind& kind : coverage.kinds) {
        const MeasuredRate& inside = kind.rates.rates[0];
        const MeasuredRate& beyond = kind.rates.rates[1];
        result.summary += fmt::format(
            "| {} | {} | {} | {} | {} | {} | {} | {} | {} | {} |\n", kind.name, kind.rates.claims(),
            inside.counts.trials, claim_cells(inside, coverage.level), claim_cells(beyond, coverage.level),
            reports::thousands_apart(kind.inside.trials), share_text(kind.inside),
            kind.fine.trials == 0
                ? "–"
                : fmt::format("{} of {}", share_text(kind.fine), reports::thousands_apart(kind.fine.trials)),
            share_text(kind.beyond), kind.worst > 0 ? brief(kind.worst) : "0");
        add_rates(kind.rates, coverage.level, result);
        if (kind.outside.empty()) continue;
        result.tables += "Farthest outside, with what both intervals leave between them:\n\n";
        for (const std::string& entry : kind.outside) result.tables += fmt::format("- {}\n", entry);
        result.tables += "\n";
    }
    return result;
}

Pages markdown(const heat::FlowCoverage& coverage) {
    const form_factors::FormFactorCoverageOptions& options = coverage.options;
    Pages result = begin_pages(
        fmt::format("`ffstudy-validate heat --seed {} --seeds {} --tolerance {}` printed what follows. Intervals are "
                    "those of Clopper and Pearson at level {:.5f} (Šidák), so that all rows hold together with "
                    "probability 0.95 if all claims are right.",
                    options.seed.value, options.seeds, brief(options.tolerance), coverage.level),
        coverage.contradictions());
    for (const RateTable* table :
         {&coverage.flows, &coverage.narrower, &coverage.statistical, &coverage.statistical_narrower})
        add_table(*table, coverage.level, result);
    return result;
}

}  // namespace ff::studies
