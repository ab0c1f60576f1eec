#include "reports/words/answer.hpp"

#include "reports/words/premise.hpp"
#include "reports/words/published_summary.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace ff::reports {
namespace {

using studies::StudyResults;

constexpr std::size_t most_clauses = 4;
constexpr std::size_t most_bytes = 400;  // of several clauses: half the screen of a phone

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

Answer answer(const StudyResults& results) {
    Answer out{{}, {}, main_finding(results)};
    if (!results.findings.plan.spec.title.ends_with('?')) out.question = out.finding.question;
    std::vector<std::string> sentences;
    if (results.published) {
        if (std::string text = premise(results); !text.empty()) sentences.push_back(std::move(text));
        if (results.published->tables.figures.empty() && !results.published->claims.empty()) {
            sentences.push_back(claims_sentence(*results.published));
            if (results.published->claims.size() == 1) sentences.push_back(results.published->claims.front().evidence);
        }
    }
    if (std::string text = sentence(out.finding.clauses); !text.empty()) sentences.push_back(std::move(text));
    if (results.published) {
        const studies::audit::Report& audit = results.published->audit;
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
