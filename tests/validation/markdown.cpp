#include "tests/validation/markdown.hpp"

#include "reports/text/numbers.hpp"

#include <fmt/format.h>

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

std::string_view holds_text(const MeasuredRate& rate, double level) {
    if (rate.claim == RateClaim::none) return "–";
    return holds(rate, level) ? "yes" : "**no**";
}

std::string p_values_text(const Selftest& selftest) {
    std::string out =
        "### p-values\n\nOne-sided p-values of gates whose effect lies exactly at the end of the band, against uniform "
        "ones (Kolmogorov and Smirnov).\n\n| what | values | distance | p | holds |\n|---|--:|--:|--:|---|\n";
    for (const PValues& values : selftest.calibration.p_values) {
        out += fmt::format("| {} | {} | {} | {} | {} |\n", values.what, values.n, brief(values.distance),
                           reports::p_value(values.p), values.p >= 1 - selftest.level ? "yes" : "**no**");
    }
    return out + "\n";
}

std::string table_markdown(const RateTable& table, double level) {
    std::string out = fmt::format(
        "### {}\n\n{}\n\n| what | times | of | rate | interval | claimed | holds |\n|---|--:|--:|--:|---|--:|---|\n",
        table.title, table.text);
    for (const MeasuredRate& rate : table.rates) {
        const auto interval = interval_of(rate, level);
        out +=
            fmt::format("| {} | {} | {} | {} | {} … {} | {} | {} |\n", rate.what, rate.counts.hits, rate.counts.trials,
                        brief(static_cast<double>(rate.counts.hits) / static_cast<double>(rate.counts.trials)),
                        brief(interval.low), brief(interval.high), claim_text(rate), holds_text(rate, level));
    }
    return out + "\n";
}

std::string claims_text(std::size_t contradictions) {
    return contradictions == 0 ? "**All claims hold.**" : fmt::format("**{} claim(s) do not hold.**", contradictions);
}

}  // namespace

std::string markdown(const Selftest& selftest) {
    const SelftestOptions& options = selftest.options;
    std::string page = fmt::format(
        "`ffstudy-validate gates --seed {} --seeds {} --repetitions {}` printed what follows. Intervals are those of "
        "Clopper and Pearson at level {:.5f}, so that with probability 0.99 all rows hold together if all claims are "
        "right. {}\n\n",
        options.seed.value, options.seeds, options.repetitions, selftest.level, claims_text(selftest.contradictions()));
    for (const RateTable& table : selftest.tables()) {
        page += table_markdown(table, selftest.level);
        if (table.title == selftest.calibration.false_alarms.title) page += p_values_text(selftest);
    }
    if (!selftest.detection.refused.empty()) {
        page += "### Refused before anything is run\n\n";
        for (const std::string& message : selftest.detection.refused) page += fmt::format("- {}\n", message);
    }
    return page;
}

std::string markdown(const FormFactorCoverage& coverage) {
    const FormFactorCoverageOptions& options = coverage.options;
    std::string page = fmt::format(
        "`ffstudy-validate form_factors --seed {} --seeds {} --tolerance {}` printed what follows. Intervals are those "
        "of Clopper and Pearson at level {:.5f} (Šidák), so that all rows hold together with probability 0.95 if all "
        "claims are right. Of {} values that are computed with a bound of the error, in all runs, {} lay outside it. "
        "{} runs missed the tolerance. {}\n\n",
        options.seed.value, options.seeds, brief(options.tolerance), coverage.level, coverage.exact_pairs,
        coverage.exact_missed, coverage.out_of_tolerance, claims_text(coverage.contradictions()));
    for (const RateTable* table : coverage.tables()) page += table_markdown(*table, coverage.level);
    return page;
}

std::string markdown(const FlowCoverage& coverage) {
    const FormFactorCoverageOptions& options = coverage.options;
    return fmt::format(
               "`ffstudy-validate heat --seed {} --seeds {} --tolerance {}` printed what follows. Intervals are those "
               "of Clopper and Pearson at level {:.5f} (Šidák), so that all rows hold together with probability 0.95 "
               "if all claims are right. {}\n\n",
               options.seed.value, options.seeds, brief(options.tolerance), coverage.level,
               claims_text(coverage.contradictions())) +
           table_markdown(coverage.flows, coverage.level) + table_markdown(coverage.narrower, coverage.level);
}

}  // namespace ff::studies
