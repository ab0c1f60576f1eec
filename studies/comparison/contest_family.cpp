#include "studies/comparison/contest_family.hpp"

#include "core/exact/known_factors.hpp"
#include "stats/basics/distributions.hpp"
#include "studies/comparison/ranking.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <optional>
#include <utility>

namespace ff::studies {
namespace {

/// An entrant with the logarithm of its value.
struct Placed {
    Entrant entrant;
    stats::Measured logarithm;
};

/// Adds the uncertainty of a number, times its weight, to a sum.
void add_parts(const stats::Measured& number, double weight, stats::Measured& sum) {
    if (weight == 0) return;
    for (stats::Measured::Part part : number.parts) {
        part.weight *= weight;
        sum.parts.push_back(part);
    }
}

/// The logarithm of the mean square error of a rung that may be repeated. The mean of k trials keeps the bias of one,
/// which may be k times as much of its mean square.
stats::Measured log_mean_square(const Rung& rung, double repeats) {
    stats::Measured number = rung.log_mean_square;
    if (repeats > 1 && rung.bias > 0 && !number.is_exact())
        number.parts.front().mean.unseen += (repeats - 1) * rung.bias * rung.bias;
    return number;
}

std::optional<Placed> at_budget(const Contender& contender, double budget) {
    const Rung* largest = nullptr;
    for (const Rung& rung : contender) {
        if (rung.cost <= budget * (1 + 1e-9)) largest = &rung;
    }
    if (largest == nullptr) return std::nullopt;
    const double repeats = largest->repeatable ? std::max(1.0, budget / largest->cost) : 1;
    Placed placed{{largest->cell, repeats, largest->mean_square / repeats, 0}, log_mean_square(*largest, repeats)};
    placed.logarithm.value -= std::log(repeats);
    if (largest->repeatable && largest->cost_error > 0 && !placed.logarithm.is_exact()) {
        const std::size_t trials = placed.logarithm.parts.front().mean.n;
        add_parts(stats::with_error(0, largest->cost_error, trials), 1, placed.logarithm);
    }
    return placed;
}

/// The cost to reach a mean square error.
std::optional<Placed> to_error(const Contender& contender, double target) {
    const Rung& last = contender.back();
    if (last.mean_square > target) {
        if (!last.repeatable) return std::nullopt;
        const double repeats = last.mean_square / target;
        Placed placed{{last.cell, repeats, last.cost * repeats, 0}, log_mean_square(last, repeats)};
        placed.logarithm.value = std::log(placed.entrant.value);
        return placed;
    }
    for (std::size_t i = contender.size() - 1; i-- > 0;) {
        const Rung& above = contender[i];
        const Rung& below = contender[i + 1];
        if (above.mean_square < target || above.mean_square <= below.mean_square) continue;
        const double fall = std::log(above.mean_square / below.mean_square);
        const double way = std::log(above.mean_square / target) / fall;
        const double stretch = std::log(below.cost / above.cost);
        Placed placed{{way < 1 ? above.cell : below.cell, 1, above.cost * std::exp(way * stretch), 0}, {}};
        placed.logarithm.value = std::log(placed.entrant.value);
        add_parts(above.log_mean_square, (1 - way) * stretch / fall, placed.logarithm);
        add_parts(below.log_mean_square, way * stretch / fall, placed.logarithm);
        return placed;
    }
    if (contender.size() != 1 || last.mean_square != target) return std::nullopt;
    return Placed{{last.cell, 1, last.cost, 0}, {std::log(last.cost), last.log_mean_square.parts}};
}

/// The costs, or mean square errors, that contests are held at: those of the contender with the most sizes, and one
/// more: the least cost that every contender can keep to, or the least error that any contender reaches. Of processor
/// time also the round ones in between, which contests of different scenes share.
std::vector<double> budgets(const std::vector<Contender>& all, const std::vector<Rung>& exact, Equal equal) {
    const auto longest = std::ranges::max_element(all, {}, [](const Contender& each) { return each.size(); });
    const bool of_errors = equal == Equal::error;
    std::vector<double> budgets;
    for (const Rung& rung : *longest) budgets.push_back(of_errors ? rung.mean_square : rung.cost);
    double for_all = of_errors ? std::numeric_limits<double>::infinity() : 0;
    for (const Contender& each : all)
        for_all = of_errors ? std::min(for_all, each.back().mean_square) : std::max(for_all, each.front().cost);
    for (const Rung& rung : exact)
        if (!of_errors) for_all = std::max(for_all, rung.cost);
    budgets.push_back(for_all);
    if (equal == Equal::processor_time) {
        const auto [least, most] = std::ranges::minmax(budgets);
        double time = round_time_from(least);
        while (time <= most) {
            budgets.push_back(time);
            time = round_time_from(time * 1.1);
        }
    }
    std::ranges::sort(budgets);
    budgets.erase(std::unique(budgets.begin(), budgets.end()), budgets.end());
    return budgets;
}

/// What is claimed of all pairs of entrants together.
struct Claim {
    double level;
    double power;
    double pairs;

    [[nodiscard]] double level_of_each() const { return 1 - (1 - level) / pairs; }
    /// How many times the trials it takes to show a ratio. @param low  lower end of its interval, at most 1
    [[nodiscard]] std::optional<double> times_trials(double ratio, double low) const {
        if (!(ratio > 1) || !(low > 0)) return std::nullopt;
        const double more_for_power =
            1 + stats::normal_critical(1 - power) / stats::normal_critical((1 - level_of_each()) / 2);
        const double times = std::pow(std::log(ratio / low) / std::log(ratio) * more_for_power, 2);
        constexpr double most = 1e6;
        return times <= most ? std::optional(times) : std::nullopt;
    }
};

/// The share of what the trials leave uncertain in the whole standard error, in which the clock has its part.
double share_of_trials(const stats::Measured& logarithm) {
    return stats::Measured{0, {logarithm.parts.front()}}.standard_error() / logarithm.standard_error();
}

/// Correlation of both logarithms: of the trials where these have the same random numbers. Clocks are taken to err
/// independently of each other, and values between sizes too.
double correlation(const Contest& contest, const Placed& a, const Placed& b, const Field& field) {
    if (contest.equal == Equal::error || a.logarithm.is_exact() || b.logarithm.is_exact()) return 0;
    return field.shared_noise(a.entrant.cell, b.entrant.cell, contest.pair_class) * share_of_trials(a.logarithm) *
           share_of_trials(b.logarithm);
}

Handicap compare(const Contest& contest, const std::vector<Placed>& placed, std::size_t a, std::size_t b,
                 const Claim& claim, const Field& field) {
    const Placed& better = placed[a];
    const Placed& worse = placed[b];
    Handicap handicap{a, b, worse.entrant.value / better.entrant.value, std::nullopt};
    const auto interval = ratio_interval(better.logarithm, worse.logarithm, claim.level_of_each(),
                                         correlation(contest, better, worse, field));
    handicap.apart = interval ? interval->low > 1 : handicap.ratio > 1 + 1e-9;
    // Much of the uncertainty of a clock does not become less with more trials.
    if (interval && !handicap.apart && contest.equal != Equal::processor_time)
        handicap.times_trials = claim.times_trials(handicap.ratio, interval->low);
    if (!interval || !interval->is_finite() || interval->low == 0) return handicap;
    handicap.interval = interval;
    handicap.interval->level = claim.level;
    return handicap;
}

void decide(Contest& contest, const std::vector<Placed>& placed, const Claim& claim, const Field& field) {
    const std::size_t n = placed.size();
    std::vector<bool> differ(n * n, false);
    std::vector<double> values;
    for (std::size_t a = 0; a < n; ++a) {
        contest.entrants.push_back(placed[a].entrant);
        values.push_back(placed[a].entrant.value);
        for (std::size_t b = a + 1; b < n; ++b) {
            const Handicap handicap = compare(contest, placed, a, b, claim, field);
            differ[a * n + b] = handicap.apart;
            contest.handicaps.push_back(handicap);
        }
    }
    const auto groups =
        groups_apart(values, [&](std::size_t a, std::size_t b) { return differ[std::min(a, b) * n + std::max(a, b)]; });
    const std::size_t first = contest.exact.empty() ? 0 : 1;
    for (std::size_t a = 0; a < n; ++a) contest.entrants[a].group = first + groups[a];
}

/// A contest with its entrants, before it is decided.
using Undecided = std::pair<Contest, std::vector<Placed>>;

/// @param kind  scene, class and what is equal
std::vector<Undecided> enter(Contest kind, const Field& field) {
    const auto all = field.contenders(kind.pair_class, kind.equal);
    if (all.empty()) return {};
    const auto exact = field.exact_sizes(kind.pair_class, kind.equal);
    std::vector<Undecided> contests;
    for (const double budget : budgets(all, exact, kind.equal)) {
        std::vector<Placed> placed;
        for (const Contender& contender : all) {
            if (auto entrant = kind.equal == Equal::error ? to_error(contender, budget) : at_budget(contender, budget))
                placed.push_back(*entrant);
        }
        kind.exact.clear();
        for (const Rung& rung : exact) {
            const auto is_same = [&](const Placed& each) {
                return field.method_of(each.entrant.cell) == field.method_of(rung.cell);
            };
            const auto itself = std::ranges::find_if(placed, is_same);
            // To an error, a size of the same method that is not exact may be the cheaper one.
            if (kind.equal == Equal::error ? itself != placed.end() && itself->entrant.value <= rung.cost
                                           : rung.cost > budget * (1 + 1e-9))
                continue;
            std::erase_if(placed, is_same);
            kind.exact.push_back(rung.cell);
        }
        if (placed.empty() || placed.size() + kind.exact.size() < 2) continue;
        std::ranges::stable_sort(placed, {}, [](const Placed& each) { return each.entrant.value; });
        kind.budget = kind.equal == Equal::error ? std::sqrt(budget) : budget;
        contests.emplace_back(kind, std::move(placed));
    }
    return contests;
}

/// Mean square error of the pairs of a class in each trial.
std::vector<double> squares_of(const CellReader& cells, std::size_t cell, PairClass pair_class) {
    const StudyPlan& plan = cells.plan();
    const KnownFactors known = known_factors(plan.scenes[plan.cells[cell].scene]);
    const auto pairs = known_pairs_of_class(plan, plan.cells[cell], known, pair_class);
    const auto errors = errors_of(*cells.load(cell), pairs, known);
    std::vector<double> squares(errors.size() / pairs.size(), 0.0);
    for (std::size_t i = 0; i < errors.size(); ++i)
        squares[i / pairs.size()] += errors[i] * errors[i] / static_cast<double>(pairs.size());
    return squares;
}

}  // namespace

double shared_noise(const CellOfRun& a, const CellOfRun& b, PairClass pair_class) {
    const Cell& one = a.cells->plan().cells[a.cell];
    const Cell& other = b.cells->plan().cells[b.cell];
    const bool is_same = a.cells == b.cells && a.cell == b.cell;
    if (is_same || one.deterministic || one.key != other.key || one.trials != other.trials) return 0;
    const auto x = squares_of(*a.cells, a.cell, pair_class);
    const auto y = squares_of(*b.cells, b.cell, pair_class);
    if (x.size() != y.size()) return 0;
    const auto n = static_cast<double>(x.size());
    const double mean_x = std::accumulate(x.begin(), x.end(), 0.0) / n;
    const double mean_y = std::accumulate(y.begin(), y.end(), 0.0) / n;
    double products = 0;
    double squares_x = 0;
    double squares_y = 0;
    for (std::size_t i = 0; i < x.size(); ++i) {
        products += (x[i] - mean_x) * (y[i] - mean_y);
        squares_x += (x[i] - mean_x) * (x[i] - mean_x);
        squares_y += (y[i] - mean_y) * (y[i] - mean_y);
    }
    return squares_x > 0 && squares_y > 0 ? products / std::sqrt(squares_x * squares_y) : 0;
}

void hold(std::size_t scene, const Field& field, const StudySpec& spec, std::vector<Contest>& contests) {
    std::vector<Undecided> undecided;
    std::map<Equal, double> pairs;  // of entrants
    for (const PairClass pair_class : pair_classes) {
        for (const Equal equal : {Equal::evaluations, Equal::processor_time, Equal::error}) {
            for (Undecided& each : enter({scene, pair_class, equal, 0, {}, {}}, field)) {
                const auto entrants = static_cast<double>(each.second.size());
                pairs[equal] += entrants * (entrants - 1) / 2;
                undecided.push_back(std::move(each));
            }
        }
    }
    for (auto& [contest, placed] : undecided) {
        decide(contest, placed, {spec.level, spec.power, pairs[contest.equal]}, field);
        contests.push_back(std::move(contest));
    }
}

}  // namespace ff::studies
