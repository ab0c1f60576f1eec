#include "studies/comparison/rivals.hpp"

#include "samplers/sampler.hpp"
#include "studies/comparison/ranking.hpp"

#include <algorithm>
#include <iterator>
#include <map>
#include <set>
#include <tuple>
#include <utility>

namespace ff::studies {
namespace {

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
           std::all_of(found.class_errors.begin(), found.class_errors.end(),
                       [](const ClassError& error) { return error.rmse < rounding_error; });
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
    std::map<std::size_t, Chosen> chosen;  // by method; those that fit first, then the largest
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
    std::copy_if(cells.begin(), cells.end(), std::back_inserter(ranking), error);
    if (ranking.empty()) return std::nullopt;
    std::stable_sort(ranking.begin(), ranking.end(),
                     [&](std::size_t a, std::size_t b) { return error(a)->rmse < error(b)->rmse; });
    Rivalry rivalry;
    rivalry.scene = scene;
    rivalry.pair_class = pair_class;
    rivalry.better = ranking[0];
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
    const auto rivals_at = [&](double level) {
        std::vector<Rivalry> rivals;
        for (std::size_t scene = 0; scene < findings.plan.scenes.size(); ++scene) {
            const auto cells = compared_cells(findings, scene, published);
            for (const PairClass pair_class : {PairClass::parallel, PairClass::adjacent, PairClass::other}) {
                if (const auto rivalry = best_two(findings, scene, pair_class, cells, level))
                    rivals.push_back(*rivalry);
            }
        }
        return rivals;
    };
    const double level = findings.plan.spec.level;
    return rivals_at(level_of_each(level, rivals_at(level).size()));
}

}  // namespace ff::studies
