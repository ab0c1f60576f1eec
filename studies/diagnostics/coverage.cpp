#include "studies/diagnostics/coverage.hpp"

#include "core/exact/known_factors.hpp"
#include "stats/basics/binomial.hpp"
#include "stats/basics/distributions.hpp"
#include "stats/basics/quantiles.hpp"
#include "stats/error_rates/multiplicity.hpp"
#include "stats/means/mean_interval.hpp"
#include "studies/analysis/class_error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

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

    [[nodiscard]] Coverage coverage(PairClass wanted, IntervalRule rule, std::uint64_t replicates) const {
        Coverage row{.cell = cell_, .pair_class = wanted, .interval_method = rule, .replicates = replicates};
        int source = 0;
        for (const Quantity pair : known_pairs_of_class(plan_, plan_.cells[cell_], known_, wanted)) {
            if (pair.from == source) continue;  // only the first target of the class from each source face
            source = pair.from;
            count(pair, row);
        }
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

/// The sources of claims about a cell.
std::vector<Claimant> claimants(const Store& store, std::size_t cell) {
    const Method& method = store.plan().spec.methods[store.plan().cells[cell].method];
    std::vector<Claimant> found;
    if (store.has(cell, observable::claim)) found.push_back(Claimant::estimator);
    if (method.claimed_error) found.push_back(Claimant::study);
    const bool shoots = estimator_info(method).observes == Observes::hits;
    if (shoots && is_randomised(method)) found.push_back(Claimant::one_run);
    return found;
}

/// The share of claims that has to hold.
double promised(const StudyPlan& plan, std::size_t cell, Claimant claimant) {
    if (claimant == Claimant::one_run) return plan.spec.level;
    return plan.spec.methods[plan.cells[cell].method].claimed_level.value_or(1);
}

/// The errors claimed for a pair, by trial.
std::vector<double> claims_on(const Store& store, const CellEstimates& estimates, Quantity pair, Claimant claimant) {
    const StudyPlan& plan = store.plan();
    const auto& values = estimates.values(pair);
    if (claimant == Claimant::estimator)
        return store.series(estimates.cell, observable::claim, pair.from, pair.to).value;
    if (claimant == Claimant::study)
        return std::vector(values.size(), *plan.spec.methods[plan.cells[estimates.cell].method].claimed_error);
    std::vector<double> claims;
    const double quantile = stats::normal_critical((1 - plan.spec.level) / 2);
    const auto index =
        static_cast<std::size_t>(pair.from - 1) * estimates.faces + static_cast<std::size_t>(pair.to - 1);
    for (const double value : values)
        claims.push_back(quantile * std::sqrt(std::max(0.0, value * (1 - value)) / estimates.rays[index]));
    return claims;
}

/// How often claims hold on one pair.
struct PairClaims {
    std::uint64_t held = 0;
    std::vector<double> ratios;  ///< [trial]: |error| / claim
};

PairClaims compare(const std::vector<double>& values, const std::vector<double>& claims, double exact) {
    PairClaims found;
    for (std::size_t trial = 0; trial < values.size(); ++trial) {
        const double error = std::abs(values[trial] - exact);
        if (error <= std::max(claims[trial], rounding_error)) ++found.held;
        const double ratio = claims[trial] > 0 ? error / claims[trial] : std::numeric_limits<double>::infinity();
        found.ratios.push_back(error <= rounding_error ? 0 : ratio);
    }
    return found;
}

std::optional<ClaimedErrors> judge(const Store& store, const CellEstimates& estimates, const KnownFactors& known,
                                   PairClass pair_class, Claimant claimant) {
    const StudyPlan& plan = store.plan();
    const auto pairs = known_pairs_of_class(plan, plan.cells[estimates.cell], known, pair_class);
    if (pairs.empty() || estimates.trials() == 0) return std::nullopt;
    ClaimedErrors found{.cell = estimates.cell,
                        .pair_class = pair_class,
                        .claimant = claimant,
                        .promised = promised(plan, estimates.cell, claimant)};
    std::vector<double> ratios;
    std::uint64_t fewest = std::numeric_limits<std::uint64_t>::max();
    for (const Quantity pair : pairs) {
        const auto claims = claims_on(store, estimates, pair, claimant);
        if (claims.size() != estimates.trials()) return std::nullopt;  // a program claims nothing in some of its runs
        const auto of_pair = compare(estimates.values(pair), claims, known.at(pair.from - 1, pair.to - 1).value());
        found.claims += of_pair.ratios.size();
        found.held += of_pair.held;
        ratios.insert(ratios.end(), of_pair.ratios.begin(), of_pair.ratios.end());
        if (of_pair.held >= fewest) continue;
        fewest = of_pair.held;
        found.worst_pair = pair;
    }
    found.worst_held = fewest;
    found.pairs = pairs.size();
    found.median_ratio = *stats::median_absolute_error(ratios, 0);
    found.largest_ratio = *std::ranges::max_element(ratios);
    return found;
}

/// Shares that have to hold are judged together, on each pair.
void find_failures(std::vector<ClaimedErrors>& all, double level) {
    std::size_t pairs = 0;
    for (const ClaimedErrors& each : all) pairs += each.pairs;
    if (all.empty()) return;
    const double of_pair = 1 - stats::bonferroni_level(1 - level, pairs);
    for (ClaimedErrors& each : all) {
        each.worst_share_interval =
            stats::clopper_pearson_interval({each.worst_held, each.claims / each.pairs}, of_pair);
        const bool wrong = each.promised < 1 ? each.worst_share_interval.high < each.promised : each.held < each.claims;
        each.finding = wrong ? ClaimedErrorFinding::fails : ClaimedErrorFinding::holds;
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
        const CellTrials trials(cells, cell, known);
        for (const PairClass wanted : pair_classes) {
            for (const auto& rule : names_of<IntervalRule>) {
                for (const std::uint64_t replicates : plan.spec.coverage) {
                    const Coverage row = trials.coverage(wanted, rule.value, replicates);
                    if (row.intervals > 0) rows.push_back(row);
                }
            }
        }
    }
    if (rows.empty()) return rows;
    const double alpha = stats::sidak_level(1 - plan.spec.level, rows.size());
    for (Coverage& row : rows)
        row.short_of_nominal = stats::binomial_lower_p({row.covered, row.intervals}, plan.spec.level) < alpha;
    return rows;
}

std::vector<ClaimedErrors> judge_claimed_errors(const CellReader& cells) {
    const StudyPlan& plan = cells.plan();
    std::vector<ClaimedErrors> all;
    for (std::size_t i = 0; i < plan.cells.size(); ++i) {
        const auto claiming = claimants(cells.store(), i);
        if (claiming.empty()) continue;
        const auto loaded = cells.load(i);
        const CellEstimates& estimates = *loaded;
        const KnownFactors known = known_factors(plan.scenes[plan.cells[i].scene]);
        for (const Claimant claimant : claiming) {
            if (claimant == Claimant::one_run && estimates.rays.empty()) continue;
            for (const PairClass pair_class : pair_classes) {
                if (auto found = judge(cells.store(), estimates, known, pair_class, claimant)) all.push_back(*found);
            }
        }
    }
    find_failures(all, plan.spec.level);
    return all;
}

}  // namespace ff::studies
