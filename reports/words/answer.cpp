#include "reports/words/answer.hpp"

#include "reports/text/labels.hpp"
#include "reports/text/numbers.hpp"
#include "reports/words/coverage_words.hpp"
#include "reports/words/occlusion_words.hpp"
#include "reports/words/premise.hpp"
#include "reports/words/published_summary.hpp"
#include "reports/words/radiosity_words.hpp"
#include "reports/words/standing.hpp"
#include "studies/analysis/configuration_estimates.hpp"
#include "studies/comparison/decisions.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <set>
#include <string_view>
#include <utility>

namespace ff::reports {
namespace {

using studies::StudyResults;

constexpr std::array all_classes{PairClass::parallel, PairClass::adjacent, PairClass::other};
constexpr std::size_t most_clauses = 4;
constexpr std::size_t most_bytes = 400;  // of several clauses: half the screen of a phone

std::string on_pairs_of(const studies::StudyPlan& plan, std::size_t scene, std::string_view classes) {
    const std::string where = fmt::format("on {} pairs", classes);
    return plan.scenes.size() == 1 ? where : fmt::format("{} of {}", where, plan.scenes[scene].name);
}

/// The largest size of each ladder stands for the others.
std::vector<std::string> variance_clauses(const StudyResults& results) {
    std::vector<std::string> clauses;
    std::set<std::pair<std::size_t, PairClass>> seen;
    for (const studies::VarianceReduction& each : results.reductions) {
        if (seen.emplace(each.random_cell, each.pair_class).second)
            clauses.push_back(variance_clause(results, each.random_cell, each.pair_class));
    }
    return clauses;
}

std::vector<std::string> choice_clauses(const StudyResults& results) {
    const studies::StudyPlan& plan = results.findings.plan;
    std::vector<std::string> clauses;
    for (const studies::Decision& decision : studies::decide(plan, results.contests, studies::Equal::evaluations)) {
        if (decision.choices.empty()) continue;
        const studies::Choice& first = decision.choices.front();
        const bool begins = clauses.empty();
        clauses.push_back(fmt::format("{}{} on {} ({}{} of {}{})", begins ? "take, at equal evaluations, " : "",
                                      listed({plan.spec.methods[first.method].name}),
                                      kind_of_pairs(decision.pair_class, decision.may_be_occluded),
                                      begins ? "best in " : "", first.best, first.entered,
                                      begins ? " scenes that it can do" : ""));
    }
    return clauses;
}

std::vector<std::string> configuration_clauses(const StudyResults& results) {
    std::size_t agree = 0;
    std::size_t biased = 0;
    std::size_t untested = 0;
    std::size_t deterministic = 0;
    double largest = 0;
    for (const studies::ConfigurationEstimate& row : studies::configuration_estimates(results.findings)) {
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
            fmt::format("{} of {} sampled estimates agree with the exact value, {} {} biased (a false alarm "
                        "anywhere: {:g} %) and {} cannot be tested",
                        agree, sampled, biased, biased == 1 ? "is" : "are",
                        100 * (1 - results.findings.plan.spec.level), untested));
    }
    if (deterministic > 0) {
        clauses.push_back(
            fmt::format("the {} deterministic ones are off by at most {}", deterministic, brief(largest, 2)));
    }
    return clauses;
}

/// A clause for each class of pairs of each scene; classes of which the same is said share one.
template <class Clause>
std::vector<std::string> by_class(const StudyResults& results, const Clause& clause) {
    const studies::StudyPlan& plan = results.findings.plan;
    std::vector<std::string> clauses;
    for (std::size_t scene = 0; scene < plan.scenes.size(); ++scene) {
        std::vector<std::pair<std::string, std::vector<std::string>>> said;  // what, and of which classes
        for (const PairClass pair_class : all_classes) {
            const std::string text = clause(results, scene, pair_class);
            if (text.empty()) continue;
            const std::string what = text.substr(on_pairs(plan, scene, pair_class).size());
            if (said.empty() || said.back().first != what) said.push_back({what, {}});
            said.back().second.emplace_back(name(pair_class));
        }
        for (auto& [what, classes] : said)
            clauses.push_back(on_pairs_of(plan, scene, listed(std::move(classes))) + what);
    }
    return clauses;
}

bool has_ranked_slopes(const StudyResults& results) {
    return !by_class(results, rate_clause).empty();
}

std::vector<std::string> clauses_of(const StudyResults& results, Subject subject) {
    switch (subject) {
        case Subject::light:
            return {light_in_brief(results)->clause};
        case Subject::occlusion:
            return {occlusion_clause(results)};
        case Subject::coverage:
            return coverage_clauses(results);
        case Subject::publication:
        case Subject::errors:
            break;
        case Subject::choice:
            return choice_clauses(results);
        case Subject::configurations:
            return configuration_clauses(results);
        case Subject::rates:
            return by_class(results, rate_clause);
        case Subject::variances:
            return variance_clauses(results);
    }
    return by_class(results, error_clause);
}

std::string question_of(Subject subject) {
    switch (subject) {
        case Subject::light:
            return "What do form-factor errors do to the light?";
        case Subject::occlusion:
            return "Which method has the smallest error, with and without occlusion?";
        case Subject::coverage:
            return "How often do intervals contain the exact value?";
        case Subject::publication:
            return "Which method is more accurate, and do the published figures hold?";
        case Subject::choice:
            return "Which method is best on which kind of pairs?";
        case Subject::configurations:
            return "Do the estimates agree with the exact values?";
        case Subject::rates:
            return "How fast does the error fall with the number of evaluations?";
        case Subject::variances:
            return "How much less variance than random points?";
        case Subject::errors:
            break;
    }
    return "Which method has the smallest error?";
}

/// Clauses as one sentence, or as sentences where they have parts themselves.
std::string sentence(std::vector<std::string> clauses) {
    if (clauses.empty()) return {};
    const std::size_t all = clauses.size();
    std::size_t bytes = clauses.front().size();
    std::size_t taken = 1;
    while (taken < std::min(all, most_clauses) && bytes + clauses[taken].size() <= most_bytes)
        bytes += clauses[taken++].size();
    clauses.resize(taken);
    if (all > taken) clauses.back() += fmt::format(" ({} more below)", all - taken);
    const bool compound = std::any_of(clauses.begin(), clauses.end(),
                                      [](const std::string& clause) { return clause.find(';') != std::string::npos; });
    for (std::string& clause : clauses) {
        if ((compound || &clause == &clauses.front()) && clause.front() >= 'a' && clause.front() <= 'z')
            clause.front() = static_cast<char>(clause.front() - 'a' + 'A');
    }
    return fmt::format("{}.", fmt::join(clauses, compound ? ". " : "; "));
}

}  // namespace

std::string listed(std::vector<std::string> names, std::size_t most) {
    for (std::string& name : names) {
        if (name.find(',') != std::string::npos) name = fmt::format("“{}”", name);
    }
    if (names.empty()) return {};
    if (names.size() == 1) return names.front();
    if (names.size() > most) {
        const std::size_t more = names.size() - most + 1;
        names.resize(most - 1);
        return fmt::format("{} and {} more", fmt::join(names, ", "), more);
    }
    const std::string last = names.back();
    names.pop_back();
    return fmt::format("{} and {}", fmt::join(names, ", "), last);
}

std::string kind_of_pairs(PairClass pair_class, bool may_be_occluded) {
    return fmt::format("{}{} pairs", may_be_occluded ? "possibly occluded " : "", name(pair_class));
}

std::string on_pairs(const studies::StudyPlan& plan, std::size_t scene, PairClass pair_class) {
    return on_pairs_of(plan, scene, name(pair_class));
}

Subject subject_of(const StudyResults& results) {
    if (light_in_brief(results)) return Subject::light;
    if (!occlusion_clause(results).empty()) return Subject::occlusion;
    if (!results.coverage.empty()) return Subject::coverage;
    if (results.published) return Subject::publication;
    if (results.findings.plan.scenes.size() > 1 && !studies::configuration_estimates(results.findings).empty())
        return results.slopes.empty() || choice_clauses(results).empty() ? Subject::configurations : Subject::choice;
    if (has_ranked_slopes(results)) return Subject::rates;
    if (!results.reductions.empty()) return Subject::variances;
    return Subject::errors;
}

Answer answer(const StudyResults& results) {
    const Subject subject = subject_of(results);
    Answer out;
    if (!results.findings.plan.spec.title.ends_with('?')) out.question = question_of(subject);
    std::vector<std::string> sentences;
    if (results.published) {
        if (std::string text = premise(results); !text.empty()) sentences.push_back(std::move(text));
        if (results.published->tables.figures.empty() && !results.published->claims.empty()) {
            sentences.push_back(claims_sentence(*results.published));
            if (results.published->claims.size() == 1) sentences.push_back(results.published->claims.front().evidence);
        }
    }
    if (std::string text = sentence(clauses_of(results, subject)); !text.empty()) sentences.push_back(std::move(text));
    if (results.published) {
        const studies::AuditReport& audit = results.published->audit;
        if (audit.figures > 0)
            sentences.push_back(fmt::format("The publication's {} printed figures contain {} contradiction{}.",
                                            audit.figures, audit.contradictions(),
                                            audit.contradictions() == 1 ? "" : "s"));
    }
    if (sentences.empty()) sentences.emplace_back("No method of this study can be compared with exact values.");
    out.text = fmt::format("{}", fmt::join(sentences, " "));
    return out;
}

}  // namespace ff::reports
