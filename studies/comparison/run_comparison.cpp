#include "studies/comparison/run_comparison.hpp"

#include "core/geometry/scene.hpp"
#include "core/support/error.hpp"
#include "core/support/nearest_name.hpp"
#include "stats/error_rates/multiplicity.hpp"
#include "studies/comparison/ranking.hpp"
#include "studies/comparison/run_tests.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace ff::studies {
namespace {

Basis basis_of(const Cell& first, const Cell& second, bool completed_alike) {
    if (first.deterministic && second.deterministic) return Basis::deterministic;
    if (first.deterministic || second.deterministic) return Basis::mixed;
    if (first.key != second.key) return Basis::independent;
    return completed_alike ? Basis::same_random_numbers : Basis::completed_differently;
}

std::vector<ChangedScene> changed_scenes(const StudyPlan& first, const StudyPlan& second) {
    std::vector<ChangedScene> changed;
    for (const Scene& a : first.scenes) {
        for (const Scene& b : second.scenes) {
            const bool is_same = a.canonical == b.canonical && a.faces == b.faces;
            if (a.name == b.name && !is_same) changed.push_back({a.name, difference_of_faces(a, b)});
        }
    }
    return changed;
}

/// Those of the same name with the same faces, as indices into both plans.
std::vector<std::pair<std::size_t, std::size_t>> same_scenes(const StudyPlan& first, const StudyPlan& second) {
    std::vector<std::pair<std::size_t, std::size_t>> same;
    for (std::size_t a = 0; a < first.scenes.size(); ++a) {
        for (std::size_t b = 0; b < second.scenes.size(); ++b) {
            const bool alike = first.scenes[a].name == second.scenes[b].name;
            if (alike && difference_of_faces(first.scenes[a], second.scenes[b]).empty()) same.emplace_back(a, b);
        }
    }
    return same;
}

std::optional<std::size_t> counterpart(const StudyPlan& plan, const Scene& scene, const std::string& method,
                                       const Cell& size) {
    for (std::size_t i = 0; i < plan.cells.size(); ++i) {
        const Cell& cell = plan.cells[i];
        const Scene& there = plan.scenes[cell.scene];
        if (there.name == scene.name && difference_of_faces(there, scene).empty() &&
            plan.spec.methods[cell.method].name == method && cell.subdivision.m == size.subdivision.m &&
            cell.samples_per_patch == size.samples_per_patch)
            return i;
    }
    return std::nullopt;
}

std::vector<RmseRatio> ratios_of(const CellAnalysis& first, const CellAnalysis& second, Basis basis) {
    std::vector<RmseRatio> ratios;
    for (const ClassError& a : first.class_errors) {
        const ClassError* b = second.class_error(a.pair_class);
        if (b == nullptr) continue;
        RmseRatio& found = ratios.emplace_back(RmseRatio{a.pair_class, a.rmse, b->rmse, {}, {}, {}, 1});
        if (a.rmse < rounding_error || b->rmse < rounding_error) continue;
        found.ratio = b->rmse / a.rmse;
        if (basis == Basis::independent && a.mean_square && b->mean_square)
            found.logarithms = {*log_rmse(a), *log_rmse(*b)};
    }
    return ratios;
}

/// Bonferroni over all tests, so that an interval without 1 is also a difference by Holm.
void add_simultaneous_intervals(RunComparison& comparison) {
    if (comparison.tests == 0) return;
    const double level = 1 - stats::bonferroni_level(1 - comparison.level, comparison.tests);
    for (CellComparison& cell : comparison.cells) {
        for (RmseRatio& ratio : cell.ratios) {
            if (ratio.logarithms.empty()) continue;
            const auto interval = ratio_interval(ratio.logarithms[0], ratio.logarithms[1], level);
            if (interval->is_finite() && interval->low > 0) ratio.interval = interval;
        }
    }
}

void widen(std::optional<stats::Interval>& all, double low, double high, double level) {
    if (!all) all = stats::Interval{low, high, level, "bonferroni", 0};
    all->low = std::min(all->low, low);
    all->high = std::max(all->high, high);
}

/// Values from the same random numbers have to be equal before they are processed further: the direct estimates are
/// compared.
void compare_trials(const Store& first, const Store& second, CellComparison& cell) {
    const auto a = load_estimates(first, cell.first, Completion::direct);
    const auto b = load_estimates(second, cell.second, Completion::direct);
    std::size_t j = 0;
    for (std::size_t i = 0; i < a.trial_numbers.size(); ++i) {
        while (j < b.trial_numbers.size() && b.trial_numbers[j] < a.trial_numbers[i]) ++j;
        if (j == b.trial_numbers.size()) break;
        if (b.trial_numbers[j] != a.trial_numbers[i]) continue;
        ++cell.trials;
        const auto differs = [&](const Quantity& pair) { return a.values(pair)[i] != b.values(pair)[j]; };
        const auto pairs = distinct_pairs(a.faces, Completion::direct);
        if (std::ranges::any_of(pairs, differs)) ++cell.differing;
    }
    if (cell.trials > 0) cell.likeness = cell.differing > 0 ? Likeness::different : Likeness::alike;
}

void compare_values(const CellEstimates& a, const CellEstimates& b, const std::vector<Quantity>& pairs,
                    CellComparison& cell) {
    if (a.trials() == 0 || b.trials() == 0) return;
    for (const Quantity pair : pairs) {
        const double difference = b.values(pair).front() - a.values(pair).front();
        if (std::abs(difference) <= std::abs(cell.largest_difference)) continue;
        cell.largest_difference = difference;
        cell.largest_pair = pair;
    }
    cell.likeness = std::abs(cell.largest_difference) > rounding_error ? Likeness::different : Likeness::alike;
}

/// The index of a method. @throws UserError where a study has none of this name
std::size_t find_method(const StudyPlan& plan, const std::string& method) {
    std::vector<std::string_view> names;
    for (const Method& known : plan.spec.methods) names.push_back(known.name);
    const auto found = std::ranges::find(names, std::string_view(method));
    if (found != names.end()) return static_cast<std::size_t>(found - names.begin());
    throw UserError("method '{}' (its run has none of this name). {}There are: {}.", method,
                    did_you_mean(method, names), fmt::join(names, ", "));
}

/// "'rays', 'lines' on 'room.obj'"
std::string contents_of(const StudyPlan& plan) {
    std::vector<std::string> methods;
    std::vector<std::string> scenes;
    for (const Method& method : plan.spec.methods) methods.push_back(fmt::format("'{}'", method.name));
    for (const Scene& scene : plan.scenes) scenes.push_back(fmt::format("'{}'", scene.name));
    return fmt::format("{} on {}", fmt::join(methods, ", "), fmt::join(scenes, ", "));
}

}  // namespace

std::size_t RunComparison::count(Likeness likeness) const {
    return static_cast<std::size_t>(std::ranges::count(cells, likeness, &CellComparison::likeness));
}

Lead RunComparison::lead() const {
    Lead found;
    for (const CellComparison& cell : cells) {
        for (const RmseRatio& ratio : cell.ratios) {
            if (!ratio.interval) continue;
            ++found.compared;
            widen(found.ratios, ratio.interval->low, ratio.interval->high, level);
            if (ratio.interval->low <= 1 && ratio.interval->high >= 1) continue;
            const bool first_leads = ratio.interval->low > 1;
            ++(first_leads ? found.first : found.second);
            widen(found.decided, first_leads ? ratio.interval->low : 1 / ratio.interval->high,
                  first_leads ? ratio.interval->high : 1 / ratio.interval->low, level);
        }
    }
    return found;
}

Lead RunComparison::lead_at_equal_evaluations() const {
    Lead found;
    for (const Bout& bout : bouts) {
        if (bout.equal != Equal::evaluations || !bout.is_main) continue;
        ++found.compared;
        if (bout.is_shown) ++(bout.better == 0 ? found.first : found.second);
        if (bout.is_exact) continue;
        const double low = std::sqrt(bout.interval ? bout.interval->low : bout.ratio);
        const double high = std::sqrt(bout.interval ? bout.interval->high : bout.ratio);
        widen(found.ratios, bout.better == 0 ? low : 1 / high, bout.better == 0 ? high : 1 / low, level);
        if (bout.is_shown) widen(found.decided, low, high, level);
    }
    return found;
}

RunComparison compare_runs(const Store& first, const Store& second, std::array<std::string, 2> names,
                           const std::optional<MethodNames>& methods) {
    RunComparison out{std::move(names), analyse(first), analyse(second), {}, {}, {}, {}, {}, {}, 0, 0.95, 0.9};
    const StudyPlan& a = first.plan();
    const StudyPlan& b = second.plan();
    out.level = a.spec.level;
    out.power = a.spec.power;
    out.changed_scenes = changed_scenes(a, b);
    out.differences = differences_of(a.spec, b.spec);
    if (methods) {
        const CellReader in_first(first);
        const CellReader in_second(second);
        out.bouts = hold_duel({in_first, out.first, find_method(a, (*methods)[0])},
                              {in_second, out.second, find_method(b, (*methods)[1])}, same_scenes(a, b));
    }
    const auto is_meant = [&](const StudyPlan& plan, const Cell& cell, std::size_t run) {
        return !methods || plan.spec.methods[cell.method].name == methods->at(run);
    };
    std::vector<bool> met(b.cells.size(), false);
    std::vector<Test> tests;
    for (std::size_t i = 0; i < a.cells.size(); ++i) {
        const Cell& cell = a.cells[i];
        if (!is_meant(a, cell, 0)) continue;
        const std::string& there = methods ? (*methods)[1] : a.spec.methods[cell.method].name;
        const auto other = counterpart(b, a.scenes[cell.scene], there, cell);
        if (!other) {
            out.only_first.push_back(i);
            continue;
        }
        met[*other] = true;
        CellComparison& compared = out.cells.emplace_back();
        compared.first = i;
        compared.second = *other;
        const Completion completion = a.spec.methods[cell.method].completion;
        const bool completed_alike = b.spec.methods[b.cells[*other].method].completion == completion;
        compared.basis = basis_of(cell, b.cells[*other], completed_alike);
        compared.ratios = ratios_of(out.first.cells[i], out.second.cells[*other], compared.basis);
        const auto in_a = load_estimates(first, i);
        const auto in_b = load_estimates(second, *other);
        // Those that are free in at least one of the two.
        const auto pairs = distinct_pairs(in_a.faces, completed_alike ? completion : Completion::direct);
        compared.pairs = pairs.size();
        if (in_a.trials() == 0 || in_b.trials() == 0) continue;  // one of the runs has just begun
        switch (compared.basis) {
            case Basis::independent:
                test_pairs(in_a, in_b, out.first, out.second, pairs, out.cells.size() - 1, compared, tests);
                test_classes(out.cells.size() - 1, compared, tests);
                break;
            case Basis::same_random_numbers:
                compare_trials(first, second, compared);
                break;
            case Basis::deterministic:
                compare_values(in_a, in_b, pairs, compared);
                break;
            case Basis::completed_differently:
            case Basis::mixed:
                break;
        }
    }
    for (std::size_t i = 0; i < met.size(); ++i) {
        if (!met[i] && is_meant(b, b.cells[i], 1)) out.only_second.push_back(i);
    }
    if (out.cells.empty() && out.bouts.empty()) {
        for (const ChangedScene& scene : out.changed_scenes) {
            if (!scene.difference.empty())
                throw UserError(
                    "nothing to compare (scene '{}' has other faces in each run: {}). Run the study again with one "
                    "scene, or give each scene a name of its own.",
                    scene.name, scene.difference);
        }
        throw UserError(
            "nothing to compare (no scene, method and size is in both: the first has {}; the second has {}). Give two "
            "runs that share some, or name a method of each, RESULTS:METHOD: unlike sizes are compared at equal cost "
            "where exact values are known.",
            contents_of(a), contents_of(b));
    }
    judge_cells(tests, out);
    add_simultaneous_intervals(out);
    return out;
}

}  // namespace ff::studies
