#include "studies/comparison/run_tests.hpp"

#include "stats/error_rates/multiplicity.hpp"
#include "stats/error_rates/power.hpp"
#include "studies/analysis/pair_spreads.hpp"
#include "studies/comparison/ranking.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace ff::studies {
namespace {

std::optional<Untested> obstacle(const CellAnalysis& first, const CellAnalysis& second, Quantity pair) {
    if (std::min(first.trials, second.trials) < stats::fewest_replicates) return Untested::few_trials;
    if (first.repeated_trials + second.repeated_trials > 0) return Untested::repeated_trials;
    const std::array found{first.summary(pair).variance, second.summary(pair).variance};
    for (const auto& [status, reason] : {std::pair(VarianceStatus::undefined, Untested::not_finite),
                                         std::pair(VarianceStatus::infinite, Untested::infinite_variance),
                                         std::pair(VarianceStatus::sparse, Untested::too_few_hits)}) {
        if (std::ranges::find(found, status) != found.end()) return reason;
    }
    return std::nullopt;
}

void keep_smaller(std::optional<Contrast>& kept, const Contrast& contrast) {
    if (!kept || contrast.adjusted_p < kept->adjusted_p) kept = contrast;
}

void add(double size, Detectable& detectable) {
    if (!std::isfinite(size)) return;
    ++detectable.pairs;
    detectable.size = std::max(detectable.size, size);
}

}  // namespace

void test_pairs(const CellEstimates& a, const CellEstimates& b, const Analysis& first, const Analysis& second,
                const std::vector<Quantity>& pairs, std::size_t index, CellComparison& cell, std::vector<Test>& tests) {
    const CellAnalysis& in_first = first.cells[cell.first];
    const CellAnalysis& in_second = second.cells[cell.second];
    const PairSpreads of_first = spreads_of(first.plan, in_first, a, pairs);
    const PairSpreads of_second = spreads_of(second.plan, in_second, b, pairs);
    for (std::size_t i = 0; i < pairs.size(); ++i) {
        auto untested = obstacle(in_first, in_second, pairs[i]);
        const auto means = untested ? std::nullopt : stats::difference_of_means(a.values(pairs[i]), b.values(pairs[i]));
        if (!means) {
            ++cell.untestable;
            cell.obstacles.insert(untested.value_or(Untested::no_spread));
            continue;
        }
        tests.push_back({.cell = index,
                         .contrast = {pairs[i], means->difference, means->standard_error, 1},
                         .p = stats::test_mean(*means).p,
                         .means = means});
        // Trials that never vary may have missed what would make them vary: they show no ratio.
        const auto spreads = compared_spreads(of_first, of_second, i);
        if (!spreads) continue;
        const auto& [x, y] = *spreads;
        tests.push_back({.cell = index,
                         .tested = Tested::spread,
                         .contrast = {pairs[i], std::exp((y.value - x.value) / 2), 0, 1},
                         .p = stats::p_of_equal(x, y),
                         .spreads = spreads});
    }
}

void test_classes(std::size_t index, const CellComparison& cell, std::vector<Test>& tests) {
    for (std::size_t i = 0; i < cell.ratios.size(); ++i) {
        const auto& logarithms = cell.ratios[i].logarithms;
        if (logarithms.empty()) continue;
        tests.push_back(
            {.cell = index, .tested = Tested::rmse, .p = stats::p_of_equal(logarithms[0], logarithms[1]), .ratio = i});
    }
}

void judge_cells(const std::vector<Test>& tests, RunComparison& comparison) {
    comparison.tests = tests.size();
    if (tests.empty()) return;
    std::vector<double> p;
    for (const Test& test : tests) p.push_back(test.p);
    const auto adjusted = stats::holm(p);
    const double alpha = 1 - comparison.level;
    const double shared = stats::bonferroni_level(alpha, tests.size());
    for (std::size_t i = 0; i < tests.size(); ++i) {
        const Test& test = tests[i];
        CellComparison& cell = comparison.cells[test.cell];
        Contrast contrast = test.contrast;
        contrast.adjusted_p = adjusted[i];
        switch (test.tested) {
            case Tested::mean:
                keep_smaller(cell.mean, contrast);
                add(stats::detectable_difference(*test.means, {shared, comparison.power}), cell.difference);
                break;
            case Tested::spread:
                keep_smaller(cell.spread, contrast);
                add(detectable_ratio(*test.spreads, 1 - shared, comparison.power), cell.ratio);
                break;
            case Tested::rmse:
                cell.ratios[test.ratio].adjusted_p = adjusted[i];
                break;
        }
        if (cell.likeness == Likeness::untestable) cell.likeness = Likeness::alike;
        if (adjusted[i] < alpha) cell.likeness = Likeness::different;
    }
    for (CellComparison& cell : comparison.cells) {
        const bool could_differ = cell.difference.pairs > 0 && cell.ratio.pairs > 0;
        const bool is_open = cell.basis == Basis::independent && cell.likeness == Likeness::alike && !could_differ;
        if (is_open) cell.likeness = Likeness::untestable;
    }
}

}  // namespace ff::studies
