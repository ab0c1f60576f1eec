#include "studies/comparison/ranking.hpp"

#include "stats/basics/distributions.hpp"
#include "studies/comparison/rivals.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace ff::studies {
namespace {

bool are_apart(const stats::Measured& a, const stats::Measured& b, double alpha) {
    const auto interval = stats::difference_interval(a, b, 1 - alpha);
    return interval ? !interval->contains(0) : a.value != b.value;
}

/// Level of the test of one pair of values, which share that of all pairs.
double alpha_of_pair(std::size_t values, double level) {
    const double pairs = static_cast<double>(values) * (static_cast<double>(values) - 1) / 2;
    return (1 - level) / std::max(1.0, pairs);
}

/// Groups of what has been measured, and the whole in their order, best first.
void put_in_order(std::vector<Ranked>& ranked, const std::vector<stats::Measured>& measured, double level) {
    const auto groups = groups_apart(measured, level);
    const double alpha = alpha_of_pair(measured.size(), level);
    std::vector<std::size_t> order(ranked.size());
    std::iota(order.begin(), order.end(), 0);
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return measured[a].value < measured[b].value; });
    std::vector<Ranked> sorted;
    for (const std::size_t i : order) {
        sorted.push_back(ranked[i]);
        sorted.back().group = groups[i];
        sorted.back().alone = std::all_of(order.begin(), order.end(), [&](std::size_t other) {
            return other == i || are_apart(measured[i], measured[other], alpha);
        });
        if (i != order.front())
            sorted.back().behind = stats::difference_interval(measured[order.front()], measured[i], 1 - alpha);
    }
    ranked = std::move(sorted);
}

std::size_t fewest_trials(const ClassSlopes& found) {
    std::size_t fewest = std::numeric_limits<std::size_t>::max();
    for (const ClassError& size : found.sizes) fewest = std::min(fewest, size.trials);
    return fewest;
}

}  // namespace

std::vector<std::size_t> groups_apart(std::span<const double> values,
                                      const std::function<bool(std::size_t, std::size_t)>& differ) {
    std::vector<std::size_t> order(values.size());
    std::iota(order.begin(), order.end(), 0);
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return values[a] < values[b]; });
    std::vector<std::size_t> groups(values.size());
    for (std::size_t begun = 0, group = 0; !order.empty(); ++group) {
        begun = order.front();
        std::vector<std::size_t> others;
        for (const std::size_t i : order) {
            if (i != begun && differ(begun, i))
                others.push_back(i);
            else
                groups[i] = group;
        }
        order = std::move(others);
    }
    return groups;
}

std::vector<std::size_t> groups_apart(std::span<const stats::Measured> values, double level) {
    std::vector<double> sizes;
    for (const stats::Measured& measured : values) sizes.push_back(measured.value);
    const double alpha = alpha_of_pair(values.size(), level);
    return groups_apart(sizes, [&](std::size_t a, std::size_t b) { return are_apart(values[a], values[b], alpha); });
}

double level_of_each(double level, std::size_t rankings) {
    return 1 - (1 - level) / static_cast<double>(std::max<std::size_t>(1, rankings));
}

RankedSlopes rank_slopes(std::span<const LadderSlopes> ladders, std::size_t scene, PairClass pair_class, double level) {
    RankedSlopes out;
    const auto for_each = [&](const auto& use) {
        for (std::size_t i = 0; i < ladders.size(); ++i) {
            for (const ClassSlopes& found : ladders[i].classes) {
                if (ladders[i].ladder.scene == scene && found.pair_class == pair_class) use(i, found);
            }
        }
    };
    for_each([&](std::size_t, const ClassSlopes& found) {
        out.of_median |= found.rmse.variance == VarianceStatus::infinite && found.median.interval;
    });
    std::vector<stats::Measured> measured;
    for_each([&](std::size_t i, const ClassSlopes& found) {
        const Slope& slope = out.of_median ? found.median : found.rmse;
        if (!slope.slope || !slope.interval) return;
        const double widening = found.bent ? slope.misfit : 1;
        Ranked ranked{i, *slope.slope, slope.interval, 0, false};
        ranked.interval->low = *slope.slope - widening * (*slope.slope - slope.interval->low);
        ranked.interval->high = *slope.slope + widening * (slope.interval->high - *slope.slope);
        const double critical = stats::normal_critical((1 - slope.interval->level) / 2);
        measured.push_back(
            stats::with_error(*slope.slope, ranked.interval->width() / (2 * critical), fewest_trials(found)));
        out.slopes.push_back(ranked);
    });
    put_in_order(out.slopes, measured, level);
    return out;
}

std::vector<Ranked> rank_errors(const Analysis& findings, std::span<const std::size_t> cells, PairClass pair_class,
                                double level) {
    std::vector<Ranked> ranked;
    std::vector<stats::Measured> measured;
    for (const std::size_t cell : cells) {
        const ClassError* error = findings.cells[cell].class_error(pair_class);
        if (error == nullptr || findings.cells[cell].has_infinite_variance(pair_class)) continue;
        // Where only rounding is left, more trials would not show more.
        const bool certain = findings.plan.cells[cell].deterministic || error->rmse < rounding_error;
        if (!certain && !error->mean_square) continue;
        measured.push_back(certain ? stats::Measured{std::log(std::max(error->rmse, rounding_error)), {}}
                                   : *log_rmse(*error));
        ranked.push_back({cell, error->rmse, certain ? std::nullopt : error->interval, 0, false});
    }
    put_in_order(ranked, measured, level);
    return ranked;
}

std::vector<Ranked> rank_efforts(const Analysis& findings, std::span<const std::size_t> cells, PairClass pair_class) {
    std::vector<Ranked> ranked;
    std::vector<stats::Measured> measured;
    for (const std::size_t cell : cells) {
        const ClassError* error = findings.cells[cell].class_error(pair_class);
        if (error == nullptr || !error->mean_square) continue;
        const auto evaluations = static_cast<double>(error->evaluations);
        measured.push_back(stats::logarithm_of(*error->mean_square, evaluations));
        ranked.push_back({cell, error->rmse * error->rmse * evaluations, std::nullopt, 0, false});
    }
    put_in_order(ranked, measured, findings.plan.spec.level);
    return ranked;
}

std::vector<Ranked> rank_reductions(const Analysis& findings, std::span<const VarianceReduction> reductions,
                                    std::size_t random_cell, PairClass pair_class, double level) {
    std::vector<Ranked> ranked;
    std::vector<stats::Measured> measured;
    const auto add = [&](const Ranked& one) {
        ranked.push_back(one);
        measured.push_back(log_variance(*findings.cells[one.index].class_error(pair_class)));
    };
    for (const VarianceReduction& reduction : reductions) {
        if (reduction.random_cell != random_cell || reduction.pair_class != pair_class) continue;
        if (ranked.empty()) add({random_cell, 1, std::nullopt, 0, false});
        add({reduction.cell, reduction.factor, reduction.interval, 0, false});
    }
    put_in_order(ranked, measured, level);
    return ranked;
}

}  // namespace ff::studies
