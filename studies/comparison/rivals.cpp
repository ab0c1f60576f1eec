#include "studies/comparison/rivals.hpp"

#include "samplers/sampler.hpp"

#include <algorithm>
#include <map>
#include <set>
#include <tuple>
#include <utility>

namespace ff::studies {
namespace {

std::optional<stats::Measured> log_rmse_of(const Findings& findings, std::size_t cell, const ClassError& error) {
    return log_rmse(error, findings.plan.cells[findings.cells[cell].cell].deterministic);
}

void add_ratio(const Findings& findings, const ClassError& better, const ClassError& worse, std::size_t methods,
               Rivalry& rivalry) {
    if (better.rmse < rounding_error) return;
    rivalry.ratio = worse.rmse / better.rmse;
    const auto first = log_rmse_of(findings, rivalry.better, better);
    const auto second = log_rmse_of(findings, *rivalry.worse, worse);
    rivalry.doubtful = !first || !second;
    if (rivalry.doubtful) return;
    const double level = findings.plan.spec.level;
    const auto pairs = static_cast<double>(methods * (methods - 1)) / 2;
    const auto interval = ratio_interval(*first, *second, 1 - (1 - level) / pairs);
    rivalry.apart = interval ? interval->low > 1 : *rivalry.ratio > 1;
    if (!interval || !interval->is_finite()) return;
    rivalry.interval = interval;
    rivalry.interval->level = level;
}

/// Cells of the last table that shows two methods for the same scene.
std::vector<std::size_t> published_rivals(const Findings& findings, const std::vector<TableComparison>& published) {
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

/// Whether no pair is off by more than rounding, as it is at every size then.
bool is_exact_to_rounding(const CellFindings& found) {
    return !found.class_errors.empty() &&
           std::all_of(found.class_errors.begin(), found.class_errors.end(),
                       [](const ClassError& error) { return error.rmse < rounding_error; });
}

/// One cell per method: sampled ones at the size that most of them share, quadratures at the same number of patches.
std::vector<std::size_t> comparable_cells(const Findings& findings, std::size_t scene) {
    const StudyPlan& plan = findings.plan;
    std::map<std::pair<std::uint32_t, std::uint64_t>, std::set<std::size_t>> methods_of_size;
    for (const Cell& cell : plan.cells) {
        if (cell.scene == scene && !cell.deterministic)
            methods_of_size[{cell.subdivision.m, cell.samples}].insert(cell.method);
    }
    std::pair<std::uint32_t, std::uint64_t> size{0, 0};
    std::tuple<std::size_t, std::uint64_t> best{0, 0};
    for (const auto& [candidate, methods] : methods_of_size) {
        const std::tuple rank{methods.size(), std::uint64_t{candidate.first} * candidate.first * candidate.second};
        if (rank > best) std::tie(best, size) = std::pair(rank, candidate);
    }
    std::map<std::size_t, std::size_t> chosen;  // cell by method
    for (std::size_t i = 0; i < plan.cells.size(); ++i) {
        const Cell& cell = plan.cells[i];
        if (cell.scene != scene || estimator_info(plan.spec.methods[cell.method]).exact) continue;
        if (may_be_luck(plan, cell)) continue;
        const bool fits =
            cell.deterministic ? cell.subdivision.m == size.first : std::pair(cell.subdivision.m, cell.samples) == size;
        const bool any_size = cell.deterministic || is_exact_to_rounding(findings.cells[i]);
        if (fits || (any_size && !chosen.contains(cell.method))) chosen.insert_or_assign(cell.method, i);
    }
    std::vector<std::size_t> cells;
    for (const auto& [method, cell] : chosen) cells.push_back(cell);
    return cells;
}

std::optional<Rivalry> best_two(const Findings& findings, std::size_t scene, PairClass pair_class,
                                const std::vector<std::size_t>& cells) {
    std::vector<std::pair<const ClassError*, std::size_t>> ranking;
    for (const std::size_t cell : cells) {
        if (const ClassError* error = findings.cells[cell].class_error(pair_class)) ranking.emplace_back(error, cell);
    }
    if (ranking.empty()) return std::nullopt;
    std::stable_sort(ranking.begin(), ranking.end(),
                     [](const auto& a, const auto& b) { return a.first->rmse < b.first->rmse; });
    Rivalry rivalry;
    rivalry.scene = scene;
    rivalry.pair_class = pair_class;
    rivalry.better = ranking[0].second;
    if (ranking.size() == 1) return rivalry;
    rivalry.worse = ranking[1].second;
    add_ratio(findings, *ranking[0].first, *ranking[1].first, ranking.size(), rivalry);
    return rivalry;
}

}  // namespace

bool may_be_luck(const StudyPlan& plan, const Cell& cell) {
    const Method& method = plan.spec.methods[cell.method];
    return cell.deterministic && !method.sampler.empty() && samplers::find(method.sampler).info.equal_weights;
}

std::vector<std::size_t> compared_cells(const Findings& findings, std::size_t scene,
                                        const std::vector<TableComparison>& published) {
    auto printed = published_rivals(findings, published);
    if (!printed.empty() && findings.plan.cells[printed.front()].scene == scene) return printed;
    return comparable_cells(findings, scene);
}

bool Rivalry::decided() const {
    if (!worse) return false;
    return !doubtful && (!ratio || apart);
}

std::vector<Rivalry> find_rivals(const Findings& findings, const std::vector<TableComparison>& published) {
    std::vector<Rivalry> rivals;
    for (std::size_t scene = 0; scene < findings.plan.scenes.size(); ++scene) {
        const auto cells = compared_cells(findings, scene, published);
        for (const PairClass pair_class : {PairClass::parallel, PairClass::adjacent, PairClass::other}) {
            if (const auto rivalry = best_two(findings, scene, pair_class, cells)) rivals.push_back(*rivalry);
        }
    }
    return rivals;
}

}  // namespace ff::studies
