#include "studies/comparison/occlusion_series.hpp"

#include "core/configurations/built_in_scene.hpp"
#include "core/configurations/catalogue.hpp"
#include "core/exact/known_factors.hpp"
#include "stats/basics/distributions.hpp"
#include "studies/comparison/ranking.hpp"
#include "studies/theory/known_variance.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace ff::studies {
namespace {

constexpr std::size_t fewest_scenes = 3;

/// Cells of a method in a scene.
std::vector<std::size_t> cells_of(const StudyPlan& plan, std::size_t scene, std::size_t method) {
    std::vector<std::size_t> cells;
    for (std::size_t i = 0; i < plan.cells.size(); ++i) {
        if (plan.cells[i].scene == scene && plan.cells[i].method == method) cells.push_back(i);
    }
    return cells;
}

/// The least of the largest numbers of samples of a pair, over all methods in all scenes of a series.
std::uint64_t common_samples(const Analysis& findings, const std::vector<std::size_t>& scenes) {
    std::uint64_t common = std::numeric_limits<std::uint64_t>::max();
    for (const std::size_t scene : scenes) {
        for (std::size_t method = 0; method < findings.plan.spec.methods.size(); ++method) {
            std::uint64_t largest = 0;
            for (const std::size_t cell : cells_of(findings.plan, scene, method))
                largest = std::max(largest, findings.cells[cell].samples_of_pair);
            if (largest > 0) common = std::min(common, largest);
        }
    }
    return common;
}

std::optional<Slope> slope_of(const std::vector<LadderSlopes>& slopes, std::size_t scene, std::size_t method,
                              Quantity pair, ErrorSize size) {
    for (const LadderSlopes& ladder : slopes) {
        if (ladder.ladder.scene != scene || ladder.ladder.method != method) continue;
        for (const Slope& slope : ladder.pairs) {
            if (slope.pair == pair && slope.statistic == size) return slope;
        }
    }
    return std::nullopt;
}

/// Finds the error of a method on a pair in a scene, at the method's size closest to a number of samples of it.
class Errors {
  public:
    Errors(const CellReader& cells, const Analysis& findings, const std::vector<LadderSlopes>& slopes)
        : cells_(cells), findings_(findings), slopes_(slopes) {}

    [[nodiscard]] std::optional<PairError> of(std::size_t scene, std::size_t method, Quantity pair,
                                              const KnownFactors& known, std::uint64_t samples) const {
        const auto cells = cells_of(findings_.plan, scene, method);
        if (cells.empty()) return std::nullopt;
        const double wanted = std::log(static_cast<double>(samples));
        const std::size_t cell = *std::ranges::min_element(cells, {}, [&](std::size_t each) {
            const auto has = std::max<std::uint64_t>(1, findings_.cells[each].samples_of_pair);
            return std::abs(std::log(static_cast<double>(has)) - wanted);
        });
        if (findings_.cells[cell].trials == 0) return std::nullopt;
        const auto loaded = cells_.load(cell);
        const CellEstimates& estimates = *loaded;
        const VarianceStatus status = findings_.cells[cell].summary(pair).variance;
        if (status == VarianceStatus::undefined) return std::nullopt;
        const auto error = class_error_of(
            errors_of(estimates, std::array{pair}, known), 1, estimates.evaluations_per_face, status,
            findings_.plan.spec.level,
            unmet_squares({known_limits(findings_.plan, estimates, pair).unmet}, estimates.samples_of_pair));
        const ErrorSize size = status == VarianceStatus::infinite ? ErrorSize::median_abs_error : ErrorSize::rmse;
        return PairError{cell, error, slope_of(slopes_, scene, method, pair, size)};
    }

  private:
    const CellReader& cells_;
    const Analysis& findings_;
    const std::vector<LadderSlopes>& slopes_;
};

/// Which method errs least, and whether every other method is shown to err more.
/// @param alpha  this scene's share of the study's error rate
void judge_hidden_pair(const StudyPlan& plan, double alpha, HiddenPair& scene) {
    for (std::size_t method = 0; method < scene.methods.size(); ++method) {
        const auto& found = scene.methods[method];
        if (found && (!scene.least || found->size() < scene.methods[*scene.least]->size())) scene.least = method;
    }
    const bool all_rounding =
        std::ranges::all_of(scene.methods, [](const auto& found) { return !found || found->size() < rounding_error; });
    if (all_rounding) scene.least.reset();
    if (!scene.least) return;
    const auto is_deterministic = [&](std::size_t method) {
        return plan.cells[scene.methods[method]->cell].deterministic;
    };
    const PairError& best = *scene.methods[*scene.least];
    const auto log_of_best = log_rmse(best.error, is_deterministic(*scene.least));
    const double others = std::max(1.0, static_cast<double>(scene.methods.size()) - 1);
    const auto errs_more = [&](std::size_t method) {
        const PairError& other = *scene.methods[method];
        if (best.size() < rounding_error) return other.size() >= rounding_error;
        if (other.error.status == VarianceStatus::infinite) return true;  // so that its RMSE is infinite
        const auto log_of_other = log_rmse(other.error, is_deterministic(method));
        if (!log_of_best || !log_of_other) return false;
        const auto ratio = ratio_interval(*log_of_best, *log_of_other, 1 - alpha / others);
        return ratio ? ratio->low > 1 : other.size() > best.size();
    };
    scene.decided = true;
    const PairError* next = nullptr;
    for (std::size_t method = 0; method < scene.methods.size(); ++method) {
        if (method == *scene.least || !scene.methods[method]) continue;
        scene.decided = scene.decided && errs_more(method);
        const PairError& other = *scene.methods[method];
        if (other.error.status == VarianceStatus::infinite || (next != nullptr && next->size() <= other.size()))
            continue;
        next = &other;
        const auto log_of_next = log_rmse(other.error, is_deterministic(method));
        scene.next =
            log_of_best && log_of_next ? ratio_interval(*log_of_best, *log_of_next, 1 - alpha / others) : std::nullopt;
    }
    if (best.size() < rounding_error) scene.next.reset();
}

/// Whether a slope is shown to be flatter than that of random points, by its interval of this level.
bool is_slower_than_random(const Slope& slope, double level) {
    if (slope.variance == VarianceStatus::none) return *slope.slope > slope_of_random;
    const auto interval = interval_with_misfit(slope, level);
    return interval && interval->low > slope_of_random;
}

void judge_slopes(std::vector<OcclusionSeries>& all, double level) {
    std::vector<PairError*> with_slopes;
    for (OcclusionSeries& series : all) {
        for (HiddenPair& scene : series.scenes) {
            for (auto& found : scene.methods) {
                if (scene.is_partly_hidden() && found && found->slope && found->slope->slope)
                    with_slopes.push_back(&*found);
            }
        }
    }
    for (PairError* found : with_slopes)
        found->slower_than_random = is_slower_than_random(*found->slope, level_of_each(level, with_slopes.size()));
}

}  // namespace

std::vector<OcclusionSeries> occlusion_series(const CellReader& cells, const Analysis& findings,
                                              const std::vector<LadderSlopes>& slopes) {
    const StudyPlan& plan = findings.plan;
    const Errors errors(cells, findings, slopes);
    std::vector<OcclusionSeries> all;
    for (const SceneFamily& family : scene_families()) {
        std::vector<std::size_t> members;
        for (std::size_t scene = 0; scene < plan.scenes.size(); ++scene) {
            const auto member = family_member(plan.scenes[scene]);
            if (member && member->family == &family) members.push_back(scene);
        }
        if (members.size() < fewest_scenes) continue;
        for (const Configuration& configuration : configurations()) {
            if (configuration.scene_name != family.name) continue;
            OcclusionSeries series{family.name,
                                   family.measure,
                                   {QuantityKind::form_factor, configuration.from + 1, configuration.to + 1},
                                   common_samples(findings, members),
                                   {}};
            for (const std::size_t scene : members) {
                const KnownFactors known = known_factors(plan.scenes[scene]);
                const auto hidden = hidden_share(plan.scenes[scene], known, configuration.from, configuration.to);
                if (!hidden) continue;
                HiddenPair found{scene, *hidden, known.at(configuration.from, configuration.to).value(), {}, {},
                                 false, {}};
                for (std::size_t method = 0; method < plan.spec.methods.size(); ++method)
                    found.methods.push_back(errors.of(scene, method, series.pair, known, series.samples));
                series.scenes.push_back(std::move(found));
            }
            std::ranges::stable_sort(series.scenes, {}, &HiddenPair::hidden);
            if (!series.scenes.empty()) all.push_back(std::move(series));
        }
    }
    std::size_t scenes = 0;
    for (const OcclusionSeries& series : all) scenes += series.scenes.size();
    for (OcclusionSeries& series : all) {
        for (HiddenPair& scene : series.scenes)
            judge_hidden_pair(plan, (1 - plan.spec.level) / static_cast<double>(scenes), scene);
    }
    judge_slopes(all, plan.spec.level);
    return all;
}

}  // namespace ff::studies
