#include "reports/words/answer.hpp"
#include "reports/words/findings/letters.hpp"

#include "reports/text/labels.hpp"
#include "reports/text/numbers.hpp"
#include "reports/words/findings/advice.hpp"
#include "reports/words/findings/choice_words.hpp"
#include "reports/words/findings/coverage_words.hpp"
#include "reports/words/findings/occlusion_words.hpp"
#include "reports/words/findings/radiosity_words.hpp"
#include "reports/words/published_words.hpp"
#include "studies/analysis/configuration_estimates.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>
#include <set>
#include <string_view>
#include <utility>

namespace ff::reports {
namespace {

using studies::ConfigurationEstimate;
using studies::StudyResults;

/// The clause with a capital and a full stop.
std::string as_sentence(std::string clause) {
    if (clause.front() >= 'a' && clause.front() <= 'z') clause.front() = static_cast<char>(clause.front() - 'a' + 'A');
    return clause + ".";
}

std::string bars(const StudyResults& results) {
    return fmt::format("Bars: {:g} % intervals.", 100 * results.findings.plan.spec.level);
}

/// The finding of rankings, with letters for groups. The clauses say what to take, the details which method is first.
MainFinding of_rankings(const StudyResults& results, std::vector<Ranking> rankings, const Comparative& comparative,
                        MainFinding found, std::string_view ticks) {
    const studies::StudyPlan& plan = results.findings.plan;
    found.clauses = advice(plan, rankings, comparative);
    found.shorter = {advice(plan, rankings, comparative, Words::with_margin),
                     advice(plan, rankings, comparative, Words::names_alone)};
    for (const Ranking& ranking : rankings) {
        if (!ranking.caveat.empty() &&
            std::find(found.caveats.begin(), found.caveats.end(), ranking.caveat) == found.caveats.end())
            found.caveats.push_back(ranking.caveat);
    }
    found.rankings = std::move(rankings);
    found.note = fmt::format("{}{} {}", bars(results), ticks, letters_in_words(plan.spec.level, found.rankings.size()));
    return found;
}

std::optional<MainFinding> on_light(const StudyResults& results) {
    const auto light = light_in_brief(results);
    if (!light) return std::nullopt;
    return MainFinding{Subject::light, "What do form-factor errors do to the light?", {light->clause}};
}

std::optional<MainFinding> on_occlusion(const StudyResults& results) {
    const std::string clause = occlusion_clause(results);
    if (clause.empty()) return std::nullopt;
    return MainFinding{.subject = Subject::occlusion,
                       .question = "Which method has the smallest error, with and without occlusion?",
                       .clauses = {occlusion_advice(results)},
                       .details = {as_sentence(clause)}};
}

std::optional<MainFinding> on_coverage(const StudyResults& results) {
    if (results.coverage.empty()) return std::nullopt;
    return MainFinding{
        .subject = Subject::coverage,
        .question = "How often do intervals contain the exact value?",
        .clauses = {coverage_advice(results)},
        .rankings = least_coverage(results),
        .title = "Least coverage of each rule with R replicates.",
        .axis = "least coverage",
        .note = bars(results) +
                " Grey ticks: what the intervals promise. Beside each mark: the method with least coverage; * where "
                "that is significantly too little.",
    };
}

MainFinding on_errors(const StudyResults& results) {
    const studies::StudyPlan& plan = results.findings.plan;
    MainFinding found = of_rankings(results, rank_compared_errors(results), errs_less,
                                    {.question = "Which method has the smallest error?",
                                     .title = "Error of each method, smallest first.",
                                     .axis = "RMSE of a run",
                                     .logarithmic = true},
                                    "");
    for (const std::string& clause : clauses_of(plan, found.rankings)) found.details.push_back(as_sentence(clause));
    return found;
}

std::optional<MainFinding> on_publication(const StudyResults& results) {
    if (!results.published) return std::nullopt;
    MainFinding found = on_errors(results);
    found.subject = Subject::publication;
    found.question = "Which method is more accurate, and do the published figures hold?";
    if (std::string text = premise(results); !text.empty())
        found.details.insert(found.details.begin(), std::move(text));
    return found;
}

std::optional<MainFinding> on_choice(const StudyResults& results) {
    BestChoices best = best_choices(results);
    if (best.clauses.empty()) return std::nullopt;
    return MainFinding{
        .subject = Subject::choice,
        .question = "Which method is best on which kind of pairs?",
        .clauses = std::move(best.clauses),
        .shorter = std::move(best.shorter),
        .rankings = std::move(best.rankings),
        .title = "The methods that are best in the most cases.",
        .axis = "share of cases where nothing is shown to be better",
        .note = "At equal evaluations, of the cases (scenes and classes of pairs) that a method can do.",
    };
}

std::vector<std::string> configuration_clauses(const StudyResults& results,
                                               const std::vector<ConfigurationEstimate>& estimates) {
    std::size_t agree = 0;
    std::size_t biased = 0;
    std::size_t untested = 0;
    std::size_t deterministic = 0;
    double largest = 0;
    for (const ConfigurationEstimate& row : estimates) {
        if (!row.found->bias) {
            ++deterministic;
            largest = std::max(largest, std::abs(row.bias));
        } else if (row.found->bias_finding == studies::BiasFinding::biased) {
            ++biased;
        } else if (row.found->bias_finding != studies::BiasFinding::no_bias_found || !row.interval) {
            ++untested;
        } else {
            ++agree;
        }
    }
    std::vector<std::string> clauses;
    const std::size_t sampled = agree + biased + untested;
    if (sampled > 0) {
        clauses.push_back(
            fmt::format("trust {} of {} sampled estimates, which show no bias (a false alarm anywhere: {:g} %); {} "
                        "biased, {} undecided",
                        agree, sampled, 100 * (1 - results.findings.plan.spec.level),
                        biased == 0 ? "none is" : fmt::format("{} {}", biased, biased == 1 ? "is" : "are"), untested));
    }
    if (deterministic > 0) {
        clauses.push_back(
            fmt::format("the {} deterministic ones are off by at most {}", deterministic, brief(largest, 2)));
    }
    return clauses;
}

/// The estimate furthest off in each configuration.
Ranking furthest_estimates(const studies::StudyPlan& plan, const std::vector<ConfigurationEstimate>& estimates) {
    Ranking ranking{.heading = "furthest estimate of each"};
    std::set<std::string_view> seen;
    for (const ConfigurationEstimate& first : estimates) {
        if (!seen.insert(first.configuration->name).second) continue;
        const ConfigurationEstimate* worst = nullptr;
        for (const ConfigurationEstimate& row : estimates) {
            if (row.configuration != first.configuration || !row.standard_errors || !row.interval) continue;
            if (worst == nullptr || std::abs(*row.standard_errors) > std::abs(*worst->standard_errors)) worst = &row;
        }
        if (worst == nullptr) continue;
        const studies::Cell& cell = plan.cells[worst->found->cell];
        const bool biased = worst->found->bias_finding == studies::BiasFinding::biased;
        ranking.methods.push_back({std::string(first.configuration->name), cell.method, size_label(plan, cell),
                                   worst->standard_errors, std::nullopt, 0.0,
                                   fmt::format("{}{}", plan.spec.methods[cell.method].name, biased ? ", biased" : "")});
    }
    return ranking;
}

std::optional<MainFinding> on_configurations(const StudyResults& results) {
    const auto estimates = studies::configuration_estimates(results.findings);
    if (results.findings.plan.scenes.size() == 1 || estimates.empty()) return std::nullopt;
    return MainFinding{
        .subject = Subject::configurations,
        .question = "Do the estimates agree with the exact values?",
        .clauses = configuration_clauses(results, estimates),
        .rankings = {furthest_estimates(results.findings.plan, estimates)},
        .title = "The estimate furthest from its exact value.",
        .axis = "deviation in standard errors",
        .note = "Grey ticks: the exact value. Beside each mark: the method whose deviation is the largest.",
    };
}

std::optional<MainFinding> on_rates(const StudyResults& results) {
    auto rankings = rank_rates(results);
    if (rankings.empty()) return std::nullopt;
    return of_rankings(results, std::move(rankings), converges_faster,
                       {.subject = Subject::rates,
                        .question = "How fast does the error fall with the number of evaluations?",
                        .title = "Convergence rates, steepest first.",
                        .axis = "slope of ln(error) on ln(evaluations)"},
                       " Grey ticks: what theory expects at least.");
}

std::optional<MainFinding> on_variances(const StudyResults& results) {
    if (results.reductions.empty()) return std::nullopt;
    return of_rankings(results, rank_variances(results), varies_less,
                       {.subject = Subject::variances,
                        .question = "How much less variance than random points?",
                        .title = "Variance reduction, largest first.",
                        .axis = "variance of random points / variance",
                        .logarithmic = true},
                       " Grey ticks: no reduction.");
}

/// An answer is read in one go.
constexpr std::size_t most_words = 35;

std::size_t words_of(std::string_view text) {
    return static_cast<std::size_t>(std::count(text.begin(), text.end(), ' ')) + 1;
}

/// One sentence of as many of these clauses as have at most so many words together, but of one at least. The reports
/// say the rest below.
std::string sentence(std::vector<std::string> clauses, std::size_t words) {
    std::size_t taken = 1;
    for (std::size_t used = words_of(clauses.front()); taken < clauses.size(); ++taken) {
        used += words_of(clauses[taken]);
        if (used > words) break;
    }
    clauses.resize(taken);
    return as_sentence(fmt::format("{}", fmt::join(clauses, "; ")));
}

/// The clauses in as many words as leave room for all of them, if there are such.
const std::vector<std::string>& clauses_that_fit(const MainFinding& finding, std::size_t words) {
    const auto fit = [&](const std::vector<std::string>& clauses) {
        std::size_t used = 0;
        for (const std::string& clause : clauses) used += words_of(clause);
        return used <= words;
    };
    if (fit(finding.clauses)) return finding.clauses;
    for (const auto& clauses : finding.shorter) {
        if (fit(clauses)) return clauses;
    }
    return finding.clauses;
}

}  // namespace

MainFinding main_finding(const StudyResults& results) {
    for (const auto find :
         {on_light, on_occlusion, on_coverage, on_publication, on_choice, on_configurations, on_rates, on_variances}) {
        if (auto found = find(results)) return *std::move(found);
    }
    return on_errors(results);
}

Answer answer(const StudyResults& results) {
    Answer out{{}, {}, main_finding(results)};
    if (!results.findings.plan.spec.title.ends_with('?')) out.question = out.finding.question;
    std::vector<std::string> sentences;
    if (results.published && results.published->tables.figures.empty() && !results.published->claims.empty())
        sentences.push_back(claims_with_ratio(results));
    std::vector<std::string> others = out.finding.caveats;
    if (results.published && results.published->audit.figures > 0)
        others.push_back(audit_verdict(results.published->audit));
    if (!out.finding.clauses.empty()) {
        std::size_t beside = 0;
        for (const auto& each : {sentences, others}) {
            for (const std::string& other : each) beside += words_of(other);
        }
        const std::size_t words = most_words - std::min(most_words, beside);
        sentences.push_back(sentence(clauses_that_fit(out.finding, words), words));
    }
    sentences.insert(sentences.end(), others.begin(), others.end());
    if (sentences.empty())
        sentences.emplace_back(
            "Nothing is compared: trials are too few, squared errors vary without limit or not at all, or all is "
            "exact.");
    out.text = fmt::format("{}", fmt::join(sentences, " "));
    return out;
}

}  // namespace ff::reports
