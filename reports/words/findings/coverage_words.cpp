#include "reports/words/findings/coverage_words.hpp"
#include "reports/text/numbers.hpp"

#include "reports/text/labels.hpp"
#include "stats/basics/binomial.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <set>
#include <utility>

namespace ff::reports {
namespace {

using studies::Coverage;
using studies::IntervalRule;

constexpr std::array all_rules{IntervalRule::student_t, IntervalRule::normal, IntervalRule::percentile_bootstrap,
                               IntervalRule::two_stage, IntervalRule::look_short};

/// A rule is recommended where its coverage is known to be at most this below what it promises, ...
constexpr double least_precision = 0.05;
/// ... and may be as near to it as this.
constexpr double tolerated = 0.01;

/// Several rows in words: the smallest and the largest coverage, and how many are significantly short.
struct Range {
    std::vector<const Coverage*> rows;  ///< ascending
    std::ptrdiff_t short_of = 0;

    /// Whether so few intervals were made that no row determines its coverage to within a half.
    [[nodiscard]] bool tells_nothing() const {
        return std::all_of(rows.begin(), rows.end(),
                           [](const Coverage* row) { return row->coverage_interval.width() > 0.5; });
    }
    [[nodiscard]] std::string in_words() const {
        if (tells_nothing()) return "too few trials to tell the coverage";
        const std::string shares = rows.size() == 1
                                       ? fmt::format("{:.3f}", rows.front()->share())
                                       : fmt::format("{:.3f} to {:.3f}", rows.front()->share(), rows.back()->share());
        return fmt::format("covers {}; significantly short in {} of {}", shares, short_of, counted(rows.size(), "row"));
    }
};

/// The rows of a rule, of one number of replicates or of all from a fewest one on.
Range range_of(const studies::StudyResults& results, IntervalRule rule, std::optional<std::uint64_t> replicates,
               std::uint64_t fewest = 0, bool finite = true) {
    Range range;
    for (const Coverage& row : results.coverage) {
        if (row.interval_method != rule || (replicates && row.replicates != *replicates)) continue;
        if (row.replicates < fewest) continue;
        if (results.findings.cells[row.cell].has_infinite_variance(row.pair_class) == finite) continue;
        range.rows.push_back(&row);
        range.short_of += row.short_of_nominal ? 1 : 0;
    }
    std::stable_sort(range.rows.begin(), range.rows.end(),
                     [](const Coverage* a, const Coverage* b) { return a->share() < b->share(); });
    return range;
}

std::string share_in_words(const Coverage& row) {
    return fmt::format("{:.1f} %", 100 * row.share());
}

/// " (91.4 to 95.0)"
std::string ends_of_share(const Coverage& row) {
    return fmt::format(" ({:.1f} to {:.1f})", 100 * row.coverage_interval.low, 100 * row.coverage_interval.high);
}

}  // namespace

std::string coverage_advice(const studies::StudyResults& results) {
    const double level = results.findings.plan.spec.level;
    const bool without_variance = !range_of(results, IntervalRule::student_t, {}, 0, false).rows.empty();
    auto numbers = results.findings.plan.spec.coverage;
    std::sort(numbers.begin(), numbers.end());
    for (const std::uint64_t fewest : numbers) {
        std::optional<std::pair<const Coverage*, IntervalRule>> worst;  // least coverage
        for (const IntervalRule rule : all_rules) {
            const Range here = range_of(results, rule, fewest);
            if (here.rows.empty() || here.tells_nothing() || here.short_of == 0) continue;
            const Coverage* least = here.rows.front();
            if (!worst || least->share() < worst->first->share()) worst.emplace(least, rule);
        }
        for (const IntervalRule rule : all_rules) {
            if (range_of(results, rule, {}, fewest).short_of > 0) continue;
            stats::Proportion all{};  // intervals of all rows are independent
            for (const Coverage* row : range_of(results, rule, fewest).rows) {
                all.hits += row->covered;
                all.trials += row->intervals;
            }
            if (all.trials == 0) continue;
            const stats::Interval share = stats::clopper_pearson_interval(all, level);
            if (share.low < level - least_precision || share.high < level - tolerated) continue;
            const Coverage& least = *range_of(results, rule, {}, fewest).rows.front();
            std::string text =
                fmt::format("from {} replicates on take {}{}: at worst its {:g} % intervals hold in {} of runs{}",
                            fewest, rule_in_words(rule), without_variance ? " where the variance is finite" : "",
                            100 * level, share_in_words(least), ends_of_share(least));
            if (worst)
                text += fmt::format("; {} in {}{}", rule_in_words(worst->second), share_in_words(*worst->first),
                                    ends_of_share(*worst->first));
            return text;
        }
    }
    return fmt::format("no rule is shown to keep its {:g} %: trials are too few, or coverage falls short", 100 * level);
}

std::vector<Ranking> least_coverage(const studies::StudyResults& results) {
    const studies::StudyPlan& plan = results.findings.plan;
    std::vector<Ranking> rankings;
    std::set<IntervalRule> seen;
    for (const Coverage& first : results.coverage) {
        if (!seen.insert(first.interval_method).second) continue;
        Ranking& ranking = rankings.emplace_back(Ranking{.heading = std::string(rule_in_words(first.interval_method))});
        for (const std::uint64_t replicates : plan.spec.coverage) {
            const Range range = range_of(results, first.interval_method, replicates);
            if (range.rows.empty()) continue;
            const Coverage& least = *range.rows.front();
            const studies::Cell& cell = plan.cells[least.cell];
            ranking.methods.push_back(
                {fmt::format("R = {}", replicates), cell.method, size_label(plan, cell), least.share(),
                 least.coverage_interval, plan.spec.level,
                 fmt::format("{}{}", plan.spec.methods[cell.method].name, least.short_of_nominal ? "*" : "")});
        }
    }
    return rankings;
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
            const Range range = range_of(results, rule, replicates);
            if (range.rows.empty()) continue;
            lines.push_back(fmt::format("{}, R = {}: {} (nominal {:g}).", rule_in_words(rule), replicates,
                                        range.in_words(), results.findings.plan.spec.level));
        }
    }
    const Range without = range_of(results, IntervalRule::student_t, {}, 0, false);
    if (!without.rows.empty())
        lines.push_back(fmt::format("Student's t where the variance is infinite: {}.", without.in_words()));
    return lines;
}

}  // namespace ff::reports
