#include "studies/comparison/ranking.hpp"

#include "samplers/sampler.hpp"
#include "stats/basics/distributions.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <numeric>
#include <set>
#include <tuple>
#include <utility>

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
    std::ranges::stable_sort(order, {}, [&](std::size_t i) { return measured[i].value; });
    std::vector<Ranked> sorted;
    for (const std::size_t i : order) {
        sorted.push_back(ranked[i]);
        sorted.back().group = groups[i];
        sorted.back().alone = std::ranges::all_of(
            order, [&](std::size_t other) { return other == i || are_apart(measured[i], measured[other], alpha); });
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

/// Cells of the last table that shows two methods for the same scene.
std::vector<std::size_t> published_rivals(const Analysis& findings, const std::vector<TableComparison>& published) {
    for (std::size_t table = published.size(); table-- > 0;) {
        std::map<std::size_t, std::size_t> cell_of_method;
        for (const FigureComparison& figure : published[table].figures) {
            if (figure.cell && figure.ours)
                cell_of_method.insert_or_assign(findings.plan.cells[*figure.cell].method, *figure.cell);
        }
        if (cell_of_method.size() < 2) continue;
        std::vector<std::size_t> cells;
        for (const auto& [method, cell] : cell_of_method) cells.push_back(cell);
        return cells;
    }
    return {};
}

/// Whether the error of every pair is rounding, and thus so at every size.
bool is_exact_to_rounding(const CellAnalysis& found) {
    return !found.class_errors.empty() &&
           std::ranges::all_of(found.class_errors, [](const ClassError& error) { return error.rmse < rounding_error; });
}

/// One cell per method: sampled ones at the size that most of them share, quadratures at the same number of patches.
std::vector<std::size_t> comparable_cells(const Analysis& findings, std::size_t scene) {
    const StudyPlan& plan = findings.plan;
    std::map<std::pair<std::uint32_t, std::uint64_t>, std::set<std::size_t>> methods_of_size;
    for (const Cell& cell : plan.cells) {
        if (cell.scene == scene && !cell.deterministic)
            methods_of_size[{cell.subdivision.m, cell.samples_per_patch}].insert(cell.method);
    }
    std::pair<std::uint32_t, std::uint64_t> size{0, 0};
    std::tuple<std::size_t, std::uint64_t> best{0, 0};
    for (const auto& [candidate, methods] : methods_of_size) {
        const std::tuple rank{methods.size(), std::uint64_t{candidate.first} * candidate.first * candidate.second};
        if (rank > best) std::tie(best, size) = std::pair(rank, candidate);
    }
    struct Chosen {
        bool fits = false;
        std::uint64_t evaluations = 0;
        std::size_t cell = 0;
        auto operator<=>(const Chosen&) const = default;
    };
    std::map<std::size_t, Chosen> chosen;  // of each method: a cell that fits before others, then the largest
    for (std::size_t i = 0; i < plan.cells.size(); ++i) {
        const Cell& cell = plan.cells[i];
        if (cell.scene != scene || estimator_info(plan.spec.methods[cell.method]).exact) continue;
        if (may_be_luck(plan, cell)) continue;
        const bool fits = cell.deterministic ? cell.subdivision.m == size.first
                                             : std::pair(cell.subdivision.m, cell.samples_per_patch) == size;
        const bool any_size = cell.deterministic || is_exact_to_rounding(findings.cells[i]);
        if (!fits && !any_size) continue;
        Chosen& of_method = chosen.try_emplace(cell.method).first->second;
        of_method = std::max(of_method, Chosen{fits, evaluations_per_trial(plan, cell), i});
    }
    std::vector<std::size_t> cells;
    for (const auto& [method, of_method] : chosen) cells.push_back(of_method.cell);
    return cells;
}

std::optional<Rivalry> best_two(const Analysis& findings, std::size_t scene, PairClass pair_class,
                                const std::vector<std::size_t>& cells, double level) {
    const auto error = [&](std::size_t cell) { return findings.cells[cell].class_error(pair_class); };
    std::vector<std::size_t> ranking;
    std::ranges::copy_if(cells, std::back_inserter(ranking), error);
    if (ranking.empty()) return std::nullopt;
    std::ranges::stable_sort(ranking, {}, [&](std::size_t cell) { return error(cell)->rmse; });
    Rivalry rivalry{.scene = scene, .pair_class = pair_class, .better = ranking[0]};
    if (ranking.size() == 1) return rivalry;
    rivalry.worse = ranking[1];
    if (error(ranking[0])->rmse < rounding_error) return rivalry;
    rivalry.ratio = error(ranking[1])->rmse / error(ranking[0])->rmse;
    const auto log_of = [&](std::size_t cell) {
        return log_rmse(*error(cell), findings.plan.cells[cell].deterministic);
    };
    const auto better = log_of(ranking[0]);
    const auto worse = log_of(ranking[1]);
    rivalry.doubtful = !better || !worse;
    if (rivalry.doubtful) return rivalry;
    const auto pairs = static_cast<double>(ranking.size() * (ranking.size() - 1)) / 2;
    const auto interval = ratio_interval(*better, *worse, 1 - (1 - level) / pairs);
    rivalry.apart = interval ? interval->low > 1 : *rivalry.ratio > 1;
    if (!interval || !interval->is_finite()) return rivalry;
    rivalry.interval = interval;
    rivalry.interval->level = findings.plan.spec.level;
    return rivalry;
}

}  // namespace

std::vector<std::size_t> groups_apart(std::span<const double> values,
                                      const std::function<bool(std::size_t, std::size_t)>& differ) {
    std::vector<std::size_t> order(values.size());
    std::iota(order.begin(), order.end(), 0);
    std::ranges::stable_sort(order, {}, [&](std::size_t i) { return values[i]; });
    std::vector<std::size_t> groups(values.size());
    for (std::size_t group = 0; !order.empty(); ++group) {
        const std::size_t begun = order.front();
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

double level_of_each_class(const Analysis& findings) {
    std::set<std::pair<std::size_t, PairClass>> classes;
    for (const CellAnalysis& found : findings.cells) {
        for (const ClassError& error : found.class_errors)
            classes.emplace(findings.plan.cells[found.cell].scene, error.pair_class);
    }
    return level_of_each(findings.plan.spec.level, classes.size());
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
        if (!slope.interval) return;
        const Ranked ranked{i, *slope.slope, interval_with_misfit(slope, slope.interval->level), 0, false};
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
    put_in_order(ranked, measured, level_of_each_class(findings));
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

bool may_be_luck(const StudyPlan& plan, const Cell& cell) {
    const Method& method = plan.spec.methods[cell.method];
    return cell.deterministic && !method.sampler.empty() && samplers::find(method.sampler).info.equal_weights;
}

std::vector<std::size_t> compared_cells(const Analysis& findings, std::size_t scene,
                                        const std::vector<TableComparison>& published) {
    auto printed = published_rivals(findings, published);
    if (!printed.empty() && findings.plan.cells[printed.front()].scene == scene) return printed;
    return comparable_cells(findings, scene);
}

bool Rivalry::decided() const {
    if (!worse) return false;
    return !doubtful && (!ratio || apart);
}

std::vector<Rivalry> find_rivals(const Analysis& findings, const std::vector<TableComparison>& published) {
    const double level = level_of_each_class(findings);
    std::vector<Rivalry> rivals;
    for (std::size_t scene = 0; scene < findings.plan.scenes.size(); ++scene) {
        const auto cells = compared_cells(findings, scene, published);
        for (const PairClass pair_class : pair_classes) {
            if (const auto rivalry = best_two(findings, scene, pair_class, cells, level)) rivals.push_back(*rivalry);
        }
    }
    return rivals;
}

}  // namespace ff::studies
