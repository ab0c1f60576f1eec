#include "studies/diagnostics/coverage.hpp"

#include "core/exact/known_factors.hpp"
#include "stats/basics/binomial.hpp"
#include "stats/basics/distributions.hpp"
#include "stats/error_rates/multiplicity.hpp"
#include "stats/means/mean_interval.hpp"
#include "studies/analysis/class_error.hpp"
#include "studies/trials/estimates.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>

namespace ff::studies {
namespace {

/// Stopping rules aim at the half-width of this many times R trials.
constexpr double stages = 4;

/// (replicates + 1) * alpha / 2 is whole for levels of .9, .95 and .99.
constexpr std::uint32_t resamples = 399;

/// An interval, and how many trials it took. Empty at the end of the trials.
struct Taken {
    std::optional<stats::Interval> interval;
    std::size_t trials = 0;
};

/// The input of every rule: trials of one pair, and what the rule may know.
struct Task {
    double level = 0;
    double reference = 0;
    std::size_t replicates = 0;
    double half_width = 0;  ///< half width that stopping rules aim at
};

stats::Moments moments_of(std::span<const double> values, const Task& task) {
    return stats::moments_of(values, task.reference);
}

std::optional<Taken> take_two_stage(std::span<const double> left, const Task& task) {
    const auto pilot = stats::pilot_of(left, task.replicates);
    if (!pilot) return Taken{std::nullopt, task.replicates};
    const std::uint64_t trials = stats::trials_for_half_width(*pilot, task.half_width, task.level);
    if (trials > left.size()) return std::nullopt;
    const auto mean = stats::mean_evidence_after(*pilot, left.first(trials), task.reference);
    return Taken{stats::interval_of(mean, task.level), trials};
}

std::optional<Taken> take_until_short(std::span<const double> left, const Task& task) {
    stats::Moments moments = moments_of(left.first(task.replicates), task);
    for (std::size_t trials = task.replicates;; ++trials) {
        const auto interval = stats::bias_interval_t(moments, task.level);
        if (interval && interval->width() / 2 <= task.half_width) return Taken{interval, trials};
        if (trials == left.size()) return std::nullopt;
        moments.add(left[trials]);
    }
}

std::optional<Taken> take(IntervalRule rule, std::span<const double> left, const Task& task, StreamKey key) {
    if (left.size() < task.replicates) return std::nullopt;
    const auto group = left.first(task.replicates);
    const auto about = [&](const std::optional<stats::Interval>& mean) {
        return Taken{mean ? std::optional(mean->shifted(-task.reference)) : std::nullopt, task.replicates};
    };
    switch (rule) {
        case IntervalRule::student_t:
            return Taken{stats::bias_interval_t(moments_of(group, task), task.level), task.replicates};
        case IntervalRule::normal:
            return about(stats::mean_interval_normal(moments_of(group, task), task.level));
        case IntervalRule::percentile_bootstrap:
            return about(stats::mean_interval_bootstrap(group, task.level, {key, resamples}));
        case IntervalRule::two_stage:
            return take_two_stage(left, task);
        case IntervalRule::look_short:
            break;
    }
    return take_until_short(left, task);
}

/// The trials of a cell, and what is known about them.
class CellTrials {
  public:
    CellTrials(const CellReader& cells, std::size_t cell, const KnownFactors& known)
        : plan_(cells.plan()), cell_(cell), known_(known), estimates_(cells.load(cell)) {}

    [[nodiscard]] const StudySpec& spec() const { return plan_.spec; }

    /// From each source face the first target of the class.
    [[nodiscard]] std::vector<Quantity> independent_pairs(PairClass wanted) const {
        std::vector<Quantity> found;
        for (const Quantity pair : known_pairs_of_class(plan_, plan_.cells[cell_], known_, wanted)) {
            if (found.empty() || found.back().from != pair.from) found.push_back(pair);
        }
        return found;
    }

    [[nodiscard]] Coverage coverage(PairClass wanted, IntervalRule rule, std::uint64_t replicates) const {
        Coverage row;
        row.cell = cell_;
        row.pair_class = wanted;
        row.interval_method = rule;
        row.replicates = replicates;
        for (const Quantity pair : independent_pairs(wanted)) count(pair, row);
        if (row.intervals == 0) return row;
        row.mean_trials /= static_cast<double>(row.intervals);
        row.coverage_interval = stats::clopper_pearson_interval({row.covered, row.intervals}, plan_.spec.level);
        return row;
    }

  private:
    [[nodiscard]] Task task_of(Quantity pair, std::uint64_t replicates) const {
        Task task{plan_.spec.level, known_.at(pair.from - 1, pair.to - 1).value(), static_cast<std::size_t>(replicates),
                  0};
        const double r = static_cast<double>(replicates);
        const double deviation = moments_of(estimates_->values(pair), task).standard_deviation().value_or(0.0);
        task.half_width = stats::student_critical(r - 1, (1 - task.level) / 2) * deviation / std::sqrt(stages * r);
        return task;
    }

    /// Adds the groups of one pair.
    void count(Quantity pair, Coverage& row) const {
        const Task task = task_of(pair, row.replicates);
        if (task.half_width <= 0) return;
        const std::string text =
            fmt::format("coverage|{}|{}|{}|{}", plan_.cells[cell_].canonical, pair.from, pair.to, row.replicates);
        std::span<const double> left = estimates_->values(pair);
        for (std::size_t group = 0;; ++group) {
            const StreamKey key = derive_key(plan_.spec.seed, fmt::format("{}|{}", text, group));
            const auto taken = take(row.interval_method, left, task, key);
            if (!taken) return;
            left = left.subspan(taken->trials);
            row.mean_trials += static_cast<double>(taken->trials);
            ++row.intervals;
            if (taken->interval && taken->interval->contains(0)) ++row.covered;  // without spread there is no interval
        }
    }

    const StudyPlan& plan_;
    std::size_t cell_;
    const KnownFactors& known_;
    std::shared_ptr<const CellEstimates> estimates_;
};

void add_rows(const CellTrials& trials, std::vector<Coverage>& rows) {
    for (const PairClass wanted : {PairClass::parallel, PairClass::adjacent, PairClass::other}) {
        for (const auto& rule : names_of<IntervalRule>) {
            for (const std::uint64_t replicates : trials.spec().coverage) {
                Coverage row = trials.coverage(wanted, rule.value, replicates);
                if (row.intervals > 0) rows.push_back(row);
            }
        }
    }
}

}  // namespace

std::vector<Coverage> measure_coverage(const CellReader& cells) {
    const StudyPlan& plan = cells.plan();
    std::vector<Coverage> rows;
    if (plan.spec.coverage.empty()) return rows;
    for (std::size_t cell = 0; cell < plan.cells.size(); ++cell) {
        if (plan.cells[cell].deterministic) continue;
        const KnownFactors known = known_factors(plan.scenes[plan.cells[cell].scene]);
        add_rows(CellTrials(cells, cell, known), rows);
    }
    if (rows.empty()) return rows;
    const double alpha = stats::sidak_level(1 - plan.spec.level, rows.size());
    for (Coverage& row : rows)
        row.short_of_nominal = stats::binomial_lower_p({row.covered, row.intervals}, plan.spec.level) < alpha;
    return rows;
}

}  // namespace ff::studies
