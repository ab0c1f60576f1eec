#include "reports/words/coverage_words.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace ff::reports {
namespace {

using studies::Coverage;
using studies::IntervalRule;

bool infinite(const studies::StudyResults& results, const Coverage& row) {
    return results.findings.cells[row.cell].has_infinite_variance(row.pair_class);
}

/// The range of these rows in words.
std::string range_in_words(const std::vector<const Coverage*>& rows) {
    const auto less = [](const Coverage* a, const Coverage* b) { return a->share() < b->share(); };
    const auto [least, most] = std::minmax_element(rows.begin(), rows.end(), less);
    const auto short_of =
        std::count_if(rows.begin(), rows.end(), [](const Coverage* row) { return row->short_of_nominal; });
    return fmt::format("covers {:.3f} to {:.3f}; significantly short in {} of {} rows", (*least)->share(),
                       (*most)->share(), short_of, rows.size());
}

constexpr std::array all_rules{IntervalRule::student_t, IntervalRule::normal, IntervalRule::percentile_bootstrap,
                               IntervalRule::two_stage, IntervalRule::look_short};

}  // namespace

std::vector<std::string> coverage_clauses(const studies::StudyResults& results) {
    std::vector<std::string> clauses;
    for (const IntervalRule rule : all_rules) {
        std::size_t rows = 0;
        std::size_t short_of = 0;
        double least = 1;
        double most = 0;
        for (const Coverage& row : results.coverage) {
            if (row.rule != rule || infinite(results, row)) continue;
            ++rows;
            short_of += row.short_of_nominal ? 1 : 0;
            least = std::min(least, row.share());
            most = std::max(most, row.share());
        }
        if (rows == 0) continue;
        clauses.push_back(fmt::format("{} {:.1f} to {:.1f} % (significantly short in {} of {} rows)",
                                      rule_in_words(rule), 100 * least, 100 * most, short_of, rows));
    }
    if (!clauses.empty()) {
        clauses.front() = fmt::format("intervals that promise {:g} % contain the exact value in: {}",
                                      100 * results.findings.plan.spec.level, clauses.front());
    }
    return clauses;
}

std::string_view rule_in_words(IntervalRule rule) {
    switch (rule) {
        case IntervalRule::student_t:
            return "Student's t";
        case IntervalRule::normal:
            return "normal quantiles";
        case IntervalRule::percentile_bootstrap:
            return "percentile bootstrap";
        case IntervalRule::two_stage:
            return "Stein's two stages";
        case IntervalRule::look_short:
            break;
    }
    return "stopping where t looks short";
}

std::vector<std::string> coverage_in_brief(const studies::StudyResults& results) {
    std::vector<std::string> lines;
    for (const IntervalRule rule : all_rules) {
        for (const std::uint64_t replicates : results.findings.plan.spec.coverage) {
            std::vector<const Coverage*> finite;
            for (const Coverage& row : results.coverage) {
                if (row.rule == rule && row.replicates == replicates && !infinite(results, row)) finite.push_back(&row);
            }
            if (finite.empty()) continue;
            lines.push_back(fmt::format("{}, R = {}: {} (nominal {:g}).", rule_in_words(rule), replicates,
                                        range_in_words(finite), results.findings.plan.spec.level));
        }
    }
    std::vector<const Coverage*> without;
    for (const Coverage& row : results.coverage) {
        if (row.rule == IntervalRule::student_t && infinite(results, row)) without.push_back(&row);
    }
    if (!without.empty())
        lines.push_back(fmt::format("Student's t where the variance is infinite: {}.", range_in_words(without)));
    return lines;
}

}  // namespace ff::reports
