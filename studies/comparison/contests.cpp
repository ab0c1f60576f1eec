#include "studies/comparison/contests.hpp"

#include "core/exact/known_factors.hpp"
#include "studies/comparison/contenders.hpp"
#include "studies/comparison/ranking.hpp"
#include "studies/trials/estimates.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
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
/// more: the least cost that every contender can keep to, or the least error that any contender reaches.
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
    std::ranges::sort(budgets);
    budgets.erase(std::unique(budgets.begin(), budgets.end()), budgets.end());
    return budgets;
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

/// Correlation of both mean square errors where trials have the same random numbers, else 0.
double shared_noise(const CellReader& cells, std::size_t a, std::size_t b, PairClass pair_class) {
    const StudyPlan& plan = cells.plan();
    const Cell& one = plan.cells[a];
    const Cell& other = plan.cells[b];
    if (a == b || one.deterministic || one.key != other.key || one.trials != other.trials) return 0;
    const auto x = squares_of(cells, a, pair_class);
    const auto y = squares_of(cells, b, pair_class);
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

/// The contests of a scene and class with the same thing equal.
class Family {
  public:
    Family(const CellReader& cells, Contest kind, const std::vector<Contender>& all, const std::vector<Rung>& exact)
        : cells_(&cells), equal_(kind.equal) {
        if (all.empty()) return;
        const auto method_of = [&](std::size_t cell) { return cells.plan().cells[cell].method; };
        for (const double budget : budgets(all, exact, kind.equal)) {
            std::vector<Placed> placed;
            for (const Contender& contender : all) {
                if (auto entrant =
                        kind.equal == Equal::error ? to_error(contender, budget) : at_budget(contender, budget))
                    placed.push_back(*entrant);
            }
            kind.exact.clear();
            for (const Rung& rung : exact) {
                const auto is_same = [&](const Placed& each) {
                    return method_of(each.entrant.cell) == method_of(rung.cell);
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
            pairs_ += static_cast<double>(placed.size() * (placed.size() - 1)) / 2;
            kind.budget = kind.equal == Equal::error ? std::sqrt(budget) : budget;
            contests_.push_back(kind);
            placed_.push_back(std::move(placed));
        }
    }

    [[nodiscard]] Equal equal() const { return equal_; }
    /// Number of pairs of entrants, in all contests.
    [[nodiscard]] double pairs() const { return pairs_; }

    /// @param pairs  of all contests whose intervals hold together
    std::vector<Contest> decide(double level, double pairs) {
        for (std::size_t i = 0; i < contests_.size(); ++i) decide(contests_[i], placed_[i], level, pairs);
        return std::move(contests_);
    }

  private:
    void decide(Contest& contest, const std::vector<Placed>& placed, double level, double pairs) const {
        const std::size_t n = placed.size();
        std::vector<bool> differ(n * n, false);
        std::vector<double> values;
        for (std::size_t a = 0; a < n; ++a) {
            contest.entrants.push_back(placed[a].entrant);
            values.push_back(placed[a].entrant.value);
            for (std::size_t b = a + 1; b < n; ++b) {
                const Handicap handicap = compare(contest, placed, a, b, level, pairs);
                differ[a * n + b] = handicap.apart;
                contest.handicaps.push_back(handicap);
            }
        }
        const auto groups = groups_apart(
            values, [&](std::size_t a, std::size_t b) { return differ[std::min(a, b) * n + std::max(a, b)]; });
        const std::size_t first = contest.exact.empty() ? 0 : 1;
        for (std::size_t a = 0; a < n; ++a) contest.entrants[a].group = first + groups[a];
    }

    [[nodiscard]] Handicap compare(const Contest& contest, const std::vector<Placed>& placed, std::size_t a,
                                   std::size_t b, double level, double pairs) const {
        const Placed& better = placed[a];
        const Placed& worse = placed[b];
        Handicap handicap{a, b, worse.entrant.value / better.entrant.value, std::nullopt, false};
        const double shared = contest.equal == Equal::evaluations
                                  ? shared_noise(*cells_, better.entrant.cell, worse.entrant.cell, contest.pair_class)
                                  : 0;
        const auto interval = ratio_interval(better.logarithm, worse.logarithm, 1 - (1 - level) / pairs, shared);
        handicap.apart = interval ? interval->low > 1 : handicap.ratio > 1 + 1e-9;
        if (!interval || !interval->is_finite() || interval->low == 0) return handicap;
        handicap.interval = interval;
        handicap.interval->level = level;
        return handicap;
    }

    const CellReader* cells_;
    Equal equal_;
    std::vector<Contest> contests_;
    std::vector<std::vector<Placed>> placed_;
    double pairs_ = 0;
};

}  // namespace

std::vector<Contest> hold_contests(const CellReader& cells, const Analysis& findings) {
    const Costs costs = measured_costs(findings.plan, cells.store().context());
    std::vector<Contest> contests;
    for (std::size_t scene = 0; scene < findings.plan.scenes.size(); ++scene) {
        std::vector<std::vector<Family>> of_classes;
        std::map<Equal, double> pairs;  // intervals of a scene with the same thing equal hold together
        for (const PairClass pair_class : pair_classes) {
            std::vector<Family>& families = of_classes.emplace_back();
            for (const Equal equal : {Equal::evaluations, Equal::processor_time, Equal::error}) {
                families.emplace_back(cells, Contest{scene, pair_class, equal, 0, {}, {}},
                                      contenders(findings, costs, scene, pair_class, equal),
                                      exact_sizes(findings, costs, scene, pair_class, equal));
                pairs[equal] += families.back().pairs();
            }
        }
        for (std::vector<Family>& families : of_classes) {
            for (Family& family : families) {
                for (Contest& contest : family.decide(findings.plan.spec.level, pairs[family.equal()]))
                    contests.push_back(std::move(contest));
            }
        }
    }
    return contests;
}

std::vector<const Contest*> main_contests(std::span<const Contest> contests, Equal equal) {
    std::map<std::pair<std::size_t, PairClass>, const Contest*> chosen;
    for (const Contest& contest : contests) {
        if (contest.equal != equal) continue;
        const Contest*& best = chosen[{contest.scene, contest.pair_class}];
        const auto methods = [](const Contest& of) { return of.entrants.size() + of.exact.size(); };
        const std::size_t most = best == nullptr ? 0 : methods(*best);
        const bool as_many = methods(contest) == most && equal != Equal::error;  // budgets ascend
        if (methods(contest) > most || as_many) best = &contest;
    }
    std::vector<const Contest*> result;
    for (const auto& [of, contest] : chosen) result.push_back(contest);
    return result;
}

}  // namespace ff::studies
