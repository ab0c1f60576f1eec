#include "reports/words/sizes.hpp"

#include "reports/text/labels.hpp"
#include "studies/comparison/ranking.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <map>
#include <optional>

namespace ff::reports {

std::set<std::size_t> cells_in_between(const studies::StudyResults& results) {
    std::set<std::size_t> hidden;
    for (const studies::LadderSlopes& ladder : results.slopes) {
        const auto& cells = ladder.ladder.cells;
        if (cells.size() < studies::long_ladder) continue;
        hidden.insert(std::next(cells.begin()), std::prev(cells.end()));
    }
    for (const studies::OcclusionSeries& series : results.occlusion) {
        for (const studies::HiddenPair& scene : series.scenes) {
            for (const studies::CellAnalysis& found : results.findings.cells) {
                if (results.findings.plan.cells[found.cell].scene == scene.scene) hidden.insert(found.cell);
            }
        }
    }
    for (const studies::CellAnalysis& found : results.findings.cells) {
        const bool remarkable =
            found.lost_rays > 0 || (found.bias && found.bias_finding == studies::BiasFinding::biased);
        if (remarkable || found.equivalence == studies::EquivalenceFinding::refuted) hidden.erase(found.cell);
    }
    for (const studies::Rivalry& rivalry : results.rivals) {
        if (!results.occlusion.empty()) break;
        hidden.erase(results.findings.cells[rivalry.better].cell);
        if (rivalry.worse) hidden.erase(results.findings.cells[*rivalry.worse].cell);
    }
    return hidden;
}

namespace {

/// The slopes of a method on a class of pairs.
std::vector<const studies::ClassSlopes*> ladders_of(const studies::StudyResults& results, std::size_t scene,
                                                    std::size_t method, PairClass pair_class) {
    std::vector<const studies::ClassSlopes*> found;
    for (const studies::LadderSlopes& ladder : results.slopes) {
        if (ladder.ladder.scene != scene || ladder.ladder.method != method) continue;
        for (const studies::ClassSlopes& slopes : ladder.classes) {
            if (slopes.pair_class == pair_class) found.push_back(&slopes);
        }
    }
    return found;
}

std::optional<SizePoint> point_of(const studies::CellAnalysis& found, PairClass pair_class) {
    const studies::ClassError* error = found.class_error(pair_class);
    if (error == nullptr || found.evaluations_per_face == 0) return std::nullopt;
    const bool is_median = found.has_infinite_variance(pair_class);
    const SizePoint point{&found, is_median ? error->median_abs_error : error->rmse, is_median};
    return point.error < studies::rounding_error ? std::nullopt : std::optional(point);
}

}  // namespace

std::vector<SizeSeries> size_series(const studies::StudyResults& results, std::size_t scene, PairClass pair_class) {
    const studies::Analysis& findings = results.findings;
    std::vector<SizeSeries> all;
    for (std::size_t method = 0; method < findings.plan.spec.methods.size(); ++method) {
        SizeSeries series{findings.plan.spec.methods[method].name, {}, ladders_of(results, scene, method, pair_class)};
        for (const studies::CellAnalysis& found : findings.cells) {
            const studies::Cell& cell = findings.plan.cells[found.cell];
            if (cell.scene != scene || cell.method != method) continue;
            if (const auto point = point_of(found, pair_class)) series.points.push_back(*point);
        }
        std::stable_sort(series.points.begin(), series.points.end(), [](const SizePoint& a, const SizePoint& b) {
            return a.found->evaluations_per_face < b.found->evaluations_per_face;
        });
        if (!series.points.empty()) all.push_back(std::move(series));
    }
    return all;
}

std::vector<std::string> exact_methods(const studies::StudyResults& results, std::size_t scene, PairClass pair_class) {
    const studies::StudyPlan& plan = results.findings.plan;
    std::set<std::size_t> exact;
    for (const studies::CellAnalysis& found : results.findings.cells) {
        const studies::Cell& cell = plan.cells[found.cell];
        const studies::ClassError* error = cell.scene == scene ? found.class_error(pair_class) : nullptr;
        if (error != nullptr && error->rmse < studies::rounding_error) exact.insert(cell.method);
    }
    std::vector<std::string> names;
    for (const std::size_t method : exact) names.push_back(plan.spec.methods[method].name);
    return names;
}

std::vector<std::size_t> cells_of(const studies::StudyPlan& plan, const std::vector<SizeSeries>& all,
                                  bool deterministic) {
    std::vector<std::size_t> cells;
    for (const SizeSeries& series : all) {
        for (const SizePoint& point : series.points) {
            if (plan.cells[point.found->cell].deterministic == deterministic) cells.push_back(point.found->cell);
        }
    }
    return cells;
}

std::string least_errors_in_common(const studies::StudyResults& results, std::size_t scene, PairClass pair_class) {
    const studies::StudyPlan& plan = results.findings.plan;
    std::map<std::uint64_t, std::vector<std::size_t>> by_size;
    for (const SizeSeries& series : size_series(results, scene, pair_class)) {
        for (const SizePoint& point : series.points) {
            if (!plan.cells[point.found->cell].deterministic)
                by_size[point.found->evaluations_per_face].push_back(point.found->cell);
        }
    }
    // From the end, so that of sizes that as many have the largest is taken.
    const auto most = std::max_element(by_size.rbegin(), by_size.rend(),
                                       [](const auto& a, const auto& b) { return a.second.size() < b.second.size(); });
    if (most == by_size.rend() || most->second.size() < 2) return {};
    std::vector<std::string> names;
    const double level = studies::level_of_each_class(results.findings);
    for (const studies::Ranked& each : studies::rank_errors(results.findings, most->second, pair_class, level)) {
        if (each.group == 0) names.push_back(plan.spec.methods[plan.cells[each.index].method].name);
    }
    if (names.empty()) return {};
    return fmt::format("Smallest error at {} evaluations per face: {}.", most->first, listed(names, 4, "or"));
}

}  // namespace ff::reports
