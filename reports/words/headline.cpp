#include "reports/words/headline.hpp"

#include "reports/text/labels.hpp"
#include "reports/text/numbers.hpp"
#include "reports/words/answer.hpp"
#include "reports/words/findings/occlusion_words.hpp"
#include "reports/words/findings/radiosity_words.hpp"
#include "reports/words/findings/verdicts.hpp"
#include "reports/words/published_words.hpp"
#include "reports/words/sizes.hpp"

#include <fmt/format.h>

namespace ff::reports {
namespace {

using studies::BiasFinding;
using studies::Rivalry;

/// "5.07 to 5.11 with 95 % confidence"
std::string interval_text(const stats::Interval& interval) {
    return fmt::format("{} to {} with {:g} % confidence", brief(interval.low), brief(interval.high),
                       100 * interval.level);
}

KeyNumber contest_number(const studies::Analysis& findings, const Rivalry& rivalry) {
    const studies::StudyPlan& plan = findings.plan;
    const auto method = [&](std::size_t cell) { return plan.spec.methods[plan.cells[cell].method].name; };
    const auto rmse = [&](std::size_t cell) {
        return brief(findings.cells[cell].class_error(rivalry.pair_class)->rmse);
    };
    const std::string better = method(rivalry.better);
    const std::string size = size_label(plan, plan.cells[rivalry.better]);
    KeyNumber number;
    number.label = on_pairs(plan, rivalry.scene, name(rivalry.pair_class));
    if (!rivalry.worse) {
        number.value = rmse(rivalry.better);
        number.detail = fmt::format("RMSE of a run of {} at {}.", better, size);
        return number;
    }
    const std::string other = size_label(plan, plan.cells[*rivalry.worse]);
    const std::string sizes = size == other ? "both at " + other : fmt::format("at {} against {}", size, other);
    const std::string errors =
        fmt::format("RMSE of a run {} against {}, {}.", rmse(rivalry.better), rmse(*rivalry.worse), sizes);
    if (!rivalry.ratio) {
        number.value = fmt::format("{}: exact", better);
        number.detail = "Exact to rounding.";
    } else if (rivalry.decided()) {
        number.value = fmt::format("{}: {} × better than {}", better, brief(*rivalry.ratio), method(*rivalry.worse));
        number.detail = rivalry.interval ? fmt::format("{}. {}", interval_text(*rivalry.interval), errors) : errors;
    } else {
        number.value = "no difference shown";
        number.detail = rivalry.interval
                            ? fmt::format("The ratio of errors is {}. {}", interval_text(*rivalry.interval), errors)
                            : fmt::format("The variance of one is infinite, or its trials are too few. {}", errors);
    }
    return number;
}

/// Who comes first in a ranking of the answer, and in how many cases or by how much.
KeyNumber ranking_number(const studies::StudyResults& results, Subject subject, const Ranking& ranking) {
    const studies::StudyPlan& plan = results.findings.plan;
    KeyNumber number;
    number.label = "on " + ranking.heading;
    if (subject == Subject::choice) {
        number.value = listed(ranking.leaders, 3, "or");
        number.detail = fmt::format("Nothing is shown to err less in {} cases, at equal evaluations.",
                                    ranking.methods.front().group);
    } else {
        number.value = ranking.leaders.empty() ? "no difference shown" : listed(ranking.leaders, 3);
        number.detail = sentence(ranking, plan);
        const std::string common = subject == Subject::rates
                                       ? least_errors_in_common(results, ranking.scene, ranking.pair_class)
                                       : std::string();
        if (!common.empty()) number.detail += " " + common;
    }
    return number;
}

/// The least coverage of a rule.
KeyNumber coverage_number(const Ranking& rule) {
    const RankedMethod& least = *std::ranges::min_element(rule.methods, {}, &RankedMethod::value);
    return {fmt::format("{:.1f} %", 100 * *least.value), "least coverage of " + rule.heading,
            fmt::format("{:.1f} to {:.1f} %, with {}.", 100 * least.interval->low, 100 * least.interval->high,
                        least.label)};
}

/// What stands beside the answer about methods: the rankings that it rests on, or the best two on each class of pairs.
std::vector<KeyNumber> numbers_on_methods(const studies::StudyResults& results, const MainFinding& finding,
                                          std::size_t most) {
    std::vector<KeyNumber> numbers;
    switch (finding.subject) {
        case Subject::configurations:
        case Subject::occlusion:
        case Subject::light:
            break;
        case Subject::coverage:
        case Subject::choice:
        case Subject::rates:
        case Subject::variances:
            for (const Ranking& ranking : finding.rankings) {
                if (ranking.methods.empty()) continue;
                numbers.push_back(finding.subject == Subject::coverage
                                      ? coverage_number(ranking)
                                      : ranking_number(results, finding.subject, ranking));
            }
            break;
        case Subject::publication:
        case Subject::errors:
            for (const Rivalry& rivalry : results.rivals) numbers.push_back(contest_number(results.findings, rivalry));
            break;
    }
    if (numbers.size() > most) numbers.resize(most);
    return numbers;
}

KeyNumber bias_number(const studies::Analysis& findings) {
    BiasTally tally = tally_of(findings);
    if (tally.sampled == 0) return {};
    KeyNumber number;
    number.label = counted_cells(findings.plan) + " are biased";
    number.value = fmt::format("{} of {}", tally.found[BiasFinding::biased], tally.sampled);
    number.detail = fmt::format("Risk of any false alarm: {:g} %", 100 * (1 - findings.plan.spec.level));
    if (!tally.detectable.empty()) {
        const std::string median = brief(tally.detectable[tally.detectable.size() / 2], 2);
        const std::string largest = brief(tally.detectable.back(), 2);
        number.detail +=
            fmt::format("; a bias of {} on one pair would have been found{} (power {:g})", median,
                        median == largest ? "" : fmt::format(" in half of them, one of {} in all", largest),
                        findings.plan.spec.power);
    }
    if (const auto inconclusive = tally.found[BiasFinding::inconclusive]; inconclusive > 0)
        number.detail += fmt::format("; {} may be biased or skewed", inconclusive);
    const auto untestable = tally.found[BiasFinding::untestable];
    number.detail += untestable == 0 ? "." : fmt::format("; {} cannot be tested.", untestable);
    if (const auto margin = findings.plan.spec.equivalence_margin)
        number.detail += fmt::format(" For {} every pair is shown to lie within ±{}.", tally.shown, brief(*margin, 2));
    if (tally.lost_rays) number.detail += fmt::format(" Lost rays: {}.", *tally.lost_rays);
    return number;
}

/// Contradictions first, those with a correction before the rest.
std::vector<std::string> wrong_in_print(const studies::PublishedResults& published) {
    std::vector<std::string> lines;
    for (const bool corrected : {true, false}) {
        for (const studies::audit::Finding& finding : published.audit.findings) {
            if (finding.corrections.empty() != corrected) lines.push_back(finding.statement);
        }
    }
    return lines;
}

}  // namespace

Headline headline(const studies::StudyResults& results) {
    Headline out;
    const Answer said = answer(results);
    out.subject = said.finding.subject;
    out.question = said.question;
    out.verdict = said.text;
    if (const auto light = light_in_brief(results)) {
        out.numbers.push_back({light->value, fmt::format("exitance error at reflectance {}", light->reflectance),
                               "Root mean square over runs and faces, of the mean exitance: with each method as it is "
                               "completed, before repairs."});
    }
    constexpr std::size_t most_on_methods = 3;
    for (KeyNumber& number : numbers_on_methods(results, said.finding, most_on_methods))
        out.numbers.push_back(std::move(number));
    if (const auto slowest = slowest_where_occluded(results)) {
        out.numbers.push_back(
            {fmt::format("{} suffers most: on {} of {} pairs", slowest->method, slowest->slow, slowest->pairs),
             "its error falls more slowly than that of random points, where occluded",
             fmt::format("That is N^{:g} with finite variance. No other method falls short of it on as many pairs.",
                         studies::slope_of_random)});
    }
    if (KeyNumber bias = bias_number(results.findings); !bias.value.empty()) out.numbers.push_back(std::move(bias));
    if (results.published && results.published->audit.figures > 0) {
        const studies::audit::Report& audit = results.published->audit;
        out.published = wrong_in_print(*results.published);
        out.unlikely = published_in_brief(*results.published, 1 - results.findings.plan.spec.level).front();
        out.numbers.push_back({std::to_string(audit.contradictions()), "contradictions in print",
                               fmt::format("among {} printed figures, found from the figures alone.", audit.figures)});
    }
    return out;
}

}  // namespace ff::reports
