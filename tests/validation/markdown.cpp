#include "reports/markdown/selftest_markdown.hpp"

#include "reports/text/numbers.hpp"

#include <fmt/format.h>

namespace ff::reports {
namespace {

std::string claim_text(const studies::MeasuredRate& rate) {
    switch (rate.claim) {
        case studies::RateClaim::equal:
            return brief(rate.claimed);
        case studies::RateClaim::at_most:
            return "≤ " + brief(rate.claimed);
        case studies::RateClaim::at_least:
            return "≥ " + brief(rate.claimed);
        case studies::RateClaim::none:
            break;
    }
    return "–";
}

std::string_view holds_text(const studies::MeasuredRate& rate, double level) {
    if (rate.claim == studies::RateClaim::none) return "–";
    return studies::holds(rate, level) ? "yes" : "**no**";
}

std::string p_values_text(const studies::Selftest& selftest) {
    std::string out =
        "### p-values\n\nOne-sided p-values of gates whose effect lies exactly at the end of the band, against uniform "
        "ones (Kolmogorov and Smirnov).\n\n| what | values | distance | p | holds |\n|---|--:|--:|--:|---|\n";
    for (const studies::PValues& values : selftest.calibration.p_values) {
        out += fmt::format("| {} | {} | {} | {} | {} |\n", values.what, values.n, brief(values.distance),
                           p_value(values.p), values.p >= 1 - selftest.level ? "yes" : "**no**");
    }
    return out + "\n";
}

}  // namespace

std::string rate_table_markdown(const studies::RateTable& table, double level) {
    std::string out = fmt::format(
        "### {}\n\n{}\n\n| what | times | of | rate | interval | claimed | holds |\n|---|--:|--:|--:|---|--:|---|\n",
        table.title, table.text);
    for (const studies::MeasuredRate& rate : table.rates) {
        const auto interval = studies::interval_of(rate, level);
        out +=
            fmt::format("| {} | {} | {} | {} | {} … {} | {} | {} |\n", rate.what, rate.counts.hits, rate.counts.trials,
                        brief(static_cast<double>(rate.counts.hits) / static_cast<double>(rate.counts.trials)),
                        brief(interval.low), brief(interval.high), claim_text(rate), holds_text(rate, level));
    }
    return out + "\n";
}

std::string selftest_markdown(const studies::Selftest& selftest) {
    const auto& options = selftest.options;
    const std::size_t contradictions = selftest.contradictions();
    std::string out = fmt::format(
        "`ffstudy gates_selftest --seed {} --seeds {} --repetitions {}` printed what follows. Intervals are those of "
        "Clopper and Pearson at level {:.5f}, so that with probability 0.99 all rows hold together if all claims are "
        "right. **{}**\n\n",
        options.seed.value, options.seeds, options.repetitions, selftest.level,
        contradictions == 0 ? std::string("All claims hold.")
                            : fmt::format("{} claim(s) do not hold.", contradictions));
    for (const studies::RateTable& table : selftest.tables()) {
        out += rate_table_markdown(table, selftest.level);
        if (table.title == selftest.calibration.false_alarms.title) out += p_values_text(selftest);
    }
    if (!selftest.detection.refused.empty()) {
        out += "### Refused before anything is run\n\n";
        for (const std::string& message : selftest.detection.refused) out += fmt::format("- {}\n", message);
    }
    return out;
}

std::string form_factor_coverage_markdown(const studies::FormFactorCoverage& coverage) {
    const auto& options = coverage.options;
    const std::size_t contradictions = coverage.contradictions();
    std::string text = fmt::format(
        "`ffstudy form_factors_selftest --seed {} --seeds {} --tolerance {}` printed what follows. "
        "Intervals are those of Clopper and Pearson at level {:.5f} (Šidák), so that all rows hold together "
        "with probability 0.95 if all claims are right. Of {} values that are computed with a bound of the error, in "
        "all runs, {} lay outside it. {} runs missed the tolerance. **{}**\n\n",
        options.seed.value, options.seeds, brief(options.tolerance), coverage.level, coverage.exact_pairs,
        coverage.exact_missed, coverage.out_of_tolerance,
        contradictions == 0 ? std::string("All claims hold.")
                            : fmt::format("{} claim(s) do not hold.", contradictions));
    for (const studies::RateTable* table : coverage.tables()) text += rate_table_markdown(*table, coverage.level);
    return text;
}

std::string flow_coverage_markdown(const studies::FlowCoverage& coverage) {
    const auto& options = coverage.options;
    const std::size_t contradictions = coverage.contradictions();
    return fmt::format(
               "`ffstudy heat_selftest --seed {} --seeds {} --tolerance {}` printed what follows. Intervals "
               "are those of Clopper and Pearson at level {:.5f} (Šidák), so that all rows hold together with "
               "probability 0.95 if all claims are right. **{}**\n\n",
               options.seed.value, options.seeds, brief(options.tolerance), coverage.level,
               contradictions == 0 ? std::string("All claims hold.")
                                   : fmt::format("{} claim(s) do not hold.", contradictions)) +
           rate_table_markdown(coverage.flows, coverage.level) + rate_table_markdown(coverage.narrower, coverage.level);
}

}  // namespace ff::reports
