#include "studies/plan/plan.hpp"

#include "core/estimators/added.hpp"
#include "core/geometry/placement.hpp"
#include "core/geometry/scene.hpp"
#include "core/radiosity/patch_factors.hpp"
#include "core/support/contract.hpp"
#include "core/support/error.hpp"
#include "samplers/outside/added.hpp"
#include "samplers/sampler.hpp"
#include "stats/basics/interval.hpp"
#include "studies/scene_files/scene_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <unordered_set>
#include <utility>

namespace ff::studies {
namespace {

constexpr double unit_seconds = 0.2;

/// The observations of a unit wait in memory to be saved: some kilobytes per trial.
constexpr double most_trials_of_a_unit = 2000;

/// 320 MB of plan, and a day of work for a hundred cores.
constexpr std::uint64_t most_units = 10'000'000;

/// About a month on one core.
constexpr double most_evaluations = 1e15;
constexpr std::uint64_t most_patches = 1u << 31;  // patches of a scene

std::uint64_t sample_count(const Method& method, const Size& size) {
    if (method.nodes) {
        const std::uint64_t source = method.nodes->source;
        const std::uint64_t target = method.nodes->target;
        return target == 0 ? source * source : source * source * target * target;
    }
    return size.samples_per_patch.value_or(0);
}

std::string canonical_text(const Scene& scene, const Method& method, const Cell& cell) {
    std::string text = fmt::format("{}|{}|{}|m={}|n={}", scene.canonical, method.sampler, method.estimator,
                                   cell.subdivision.m, cell.samples_per_patch);
    if (method.nodes) text += fmt::format("|nodes={},{}", method.nodes->source, method.nodes->target);
    if (estimator_info(method).has_allocation()) text += fmt::format("|allocation={}", name(method.allocation));
    if (method.map != PointMap::uniform) text += fmt::format("|map={}", name(method.map));
    return text;
}

/// Warnings of a plan, each once.
class Warnings {
  public:
    explicit Warnings(StudyPlan& plan) : plan_(plan) {}

    void add(std::string text) {
        if (seen_.insert(text).second) plan_.warnings.push_back(std::move(text));
    }

    void add_control(const Method& method) {
        const bool sampler = !method.sampler.empty() && samplers::find(method.sampler).info.control;
        if (!sampler && method.tracer != TracerChoice::leaky) return;
        add(fmt::format("method '{}': {} is a control, broken on purpose; its results are not to be used", method.name,
                        sampler ? method.sampler : name(method.tracer)));
    }

    void add_size(const Method& method, const Cell& cell) {
        if (method.sampler.empty() || method.nodes) return;
        const auto problem = samplers::check_size(samplers::find(method.sampler).info,
                                                  points_per_sequence(method, cell.subdivision, cell.samples_per_patch),
                                                  estimator_info(method).dimension);
        if (problem.message.empty()) return;
        add(fmt::format("method '{}': {}", method.name, problem.message));
    }

    void add_trials(const Cell& cell) {
        if (cell.deterministic || cell.trials >= stats::fewest_replicates || plan_.spec.until) return;
        add(fmt::format("fewer than {} trials: estimates are shown without verdicts", stats::fewest_replicates));
    }

  private:
    StudyPlan& plan_;
    std::unordered_set<std::string> seen_;
};

/// @throws UserError where trials would repeat others
void expect_trials_at_hand(const Method& method, const Cell& cell) {
    if (method.sampler.empty() || cell.deterministic) return;
    const std::uint64_t most = samplers::find(method.sampler).info.most_trials;
    if (most == 0 || cell.trials <= most) return;
    throw UserError(
        "method '{}': {} trials ({} has {} sets of points, and each serves one trial). Take "
        "trials = {}, or randomise = \"owen\" for any number.",
        method.name, cell.trials, method.sampler, most, most);
}

/// Patches, or ordered pairs of patches of different surfaces with kernels.
double evaluated_patches(const Method& method, const Scene& scene, Subdivision subdivision) {
    if (estimator_info(method).points == PointsServe::scene) return 1;
    const auto all = static_cast<double>(subdivision.patches(scene));
    if (estimator_info(method).points != PointsServe::pairs) return all;
    double pairs = all * all;
    for (const Surface& surface : scene.surfaces) {
        const double own = subdivision.of(surface).parts();
        pairs -= own * own;
    }
    return pairs;
}

/// @throws UserError where one trial alone would take for ever
void expect_feasible(const Method& method, const Scene& scene, const Cell& cell) {
    const std::uint64_t patches = cell.subdivision.patches(scene);
    if (patches > most_patches) {
        throw UserError(
            "method '{}': {} patches in scene '{}' (at most {}). Take fewer patches per face, or "
            "coarser grids.",
            method.name, patches, scene.name, most_patches);
    }
    const double evaluations =
        evaluated_patches(method, scene, cell.subdivision) * static_cast<double>(cell.samples_per_patch);
    if (evaluations <= most_evaluations) return;
    throw UserError(
        "method '{}': one trial takes {:.1g} evaluations (more than {:g}). Take fewer patches, samples or nodes.",
        method.name, evaluations, most_evaluations);
}

/// @throws UserError where an adaptive study leaves a size fewer trials than its pilot has
void expect_room_for_pilot(const StudySpec& spec, const Method& method, const Cell& cell) {
    if (!spec.until || cell.deterministic || cell.trials >= spec.until->pilot) return;
    throw UserError("method '{}': trials = {} (the pilot of [until] has {}). Take more trials, or a smaller pilot.",
                    method.name, cell.trials, spec.until->pilot);
}

/// Whether a method takes part in a scene. One that cannot be used there is named in `left_out`, if the study allows
/// that.
/// @throws UserError otherwise
bool takes_part(const StudySpec& spec, const Method& method, const Scene& scene, std::vector<std::string>& left_out) {
    try {
        expect_applicable(method, scene);
    } catch (const UserError&) {
        if (spec.inapplicable == Inapplicable::refuse) throw;
        left_out.push_back(scene.name);
        return false;
    }
    return true;
}

void warn_about_left_out(const StudyPlan& plan, const std::vector<std::vector<std::string>>& left_out,
                         Warnings& warnings) {
    for (std::size_t m = 0; m < left_out.size(); ++m) {
        if (left_out[m].empty()) continue;
        warnings.add(fmt::format("method '{}' cannot be used in {} of {} scenes, and is left out there: {}",
                                 plan.spec.methods[m].name, left_out[m].size(), plan.scenes.size(),
                                 fmt::join(left_out[m], ", ")));
    }
    if (!plan.cells.empty()) return;
    throw UserError(
        "no method of the study can be used in any of its scenes (inapplicable = \"skip\" leaves them all "
        "out). Leave the key out to see why.");
}

}  // namespace

void add_units(const StudyPlan& plan, std::size_t cell_index, std::uint64_t first_trial, std::uint64_t end_trial,
               std::vector<WorkUnit>& units) {
    const double seconds = expected_seconds_per_trial(plan, plan.cells[cell_index]);
    const auto batch = static_cast<std::uint64_t>(std::clamp(unit_seconds / seconds, 1.0, most_trials_of_a_unit));
    if (units.size() + (end_trial - first_trial) / batch >= most_units) {
        throw UserError("method '{}': {} trials make more than {} work units. Take fewer trials.",
                        plan.spec.methods[plan.cells[cell_index].method].name, end_trial, most_units);
    }
    const bool adaptive = plan.spec.until && !plan.cells[cell_index].deterministic;
    const std::uint64_t pilot = adaptive ? plan.spec.until->pilot : 0;
    for (std::uint64_t first = first_trial; first < end_trial;) {
        std::uint64_t trials = std::min(batch, end_trial - first);
        // A round ends where a unit does: that of the pilot, and later ones not far beyond what they need.
        if (first < pilot) trials = std::min(trials, pilot - first);
        if (adaptive && first >= pilot) trials = std::min(trials, std::max<std::uint64_t>(1, first / 8));
        units.push_back({units.size(), cell_index, first, trials});
        first += trials;
    }
}

std::uint64_t points_per_sequence(const Method& method, Subdivision subdivision, std::uint64_t samples) {
    return method.allocation == Allocation::face ? samples * subdivision.per_part() : samples;
}

std::uint64_t evaluations_per_trial(const StudyPlan& plan, const Cell& cell) {
    const Method& method = plan.spec.methods[cell.method];
    const double patches = evaluated_patches(method, plan.scenes[cell.scene], cell.subdivision);
    return static_cast<std::uint64_t>(patches) * cell.samples_per_patch;
}

double expected_seconds_per_trial(const StudyPlan& plan, const Cell& cell) {
    const Method& method = plan.spec.methods[cell.method];
    const EstimatorEntry& estimator = find_estimator(method.estimator);
    if (find_added_estimator(method.estimator) != nullptr && estimator.info.nanoseconds > 0)
        return 1e-9 * estimator.info.nanoseconds;
    const double each = estimator.nanoseconds(estimator_options(method), plan.scenes[cell.scene]);
    if (!estimator.info.takes_points() && !estimator.info.own_points) return 1e-9 * each;
    // Points that are the same for all pairs of patches are made once.
    const bool made_once = estimator.info.points == PointsServe::pairs && cell.deterministic;
    const double sampling =
        made_once || estimator.info.own_points ? 0.0 : samplers::find(method.sampler).info.nanoseconds;
    return 1e-9 * static_cast<double>(evaluations_per_trial(plan, cell)) * (each + sampling);
}

Scenes::Scenes(std::vector<Scene> scenes) : scenes_(std::make_shared<const std::vector<Scene>>(std::move(scenes))) {}

std::size_t Scenes::size() const {
    return scenes_ ? scenes_->size() : 0;
}

const Scene& Scenes::operator[](std::size_t index) const {
    FF_EXPECT(index < size());
    return (*scenes_)[index];
}

const Scene* Scenes::begin() const {
    return scenes_ ? scenes_->data() : nullptr;
}

const Scene* Scenes::end() const {
    return begin() + size();
}

const std::string& Scenes::name(std::size_t index) const {
    return (*this)[index].name;
}

const std::vector<std::string>& Scenes::faces(std::size_t index) const {
    return (*this)[index].faces;
}

bool Scenes::is_closed(std::size_t index) const {
    return (*this)[index].closed;
}

StudyPlan plan_study(StudySpec spec) {
    StudyPlan plan;
    plan.spec = std::move(spec);
    Warnings warnings(plan);
    std::vector<Scene> scenes;
    for (const SceneSource& scene : plan.spec.scenes) scenes.push_back(make_scene(scene));
    for (const Scene& scene : scenes) {
        expect_no_masks(scene);
        if (!scene.empty_box) {
            for (std::string& doubt : doubts_about(scene)) warnings.add(std::move(doubt));
        }
        if (plan.spec.radiosity) expect_fitting(*plan.spec.radiosity, scene);
    }
    // Only the warnings above say where a scene lies. What is built in lies at the origin.
    for (std::size_t i = 0; i < scenes.size(); ++i) {
        if (plan.spec.scenes[i].text) scenes[i] = placed(scenes[i], {placement_of(scenes[i]).origin, 1});
    }
    plan.scenes = Scenes(std::move(scenes));
    std::vector<std::vector<std::string>> left_out(plan.spec.methods.size());  // scenes, by method
    for (std::size_t scene = 0; scene < plan.scenes.size(); ++scene) {
        for (std::size_t m = 0; m < plan.spec.methods.size(); ++m) {
            const Method& method = plan.spec.methods[m];
            if (!takes_part(plan.spec, method, plan.scenes[scene], left_out[m])) continue;
            for (const Size& size : method.sizes) {
                Cell cell;
                cell.scene = scene;
                cell.method = m;
                cell.subdivision.m = static_cast<std::uint32_t>(std::lround(std::sqrt(size.patches_per_face)));
                cell.samples_per_patch = sample_count(method, size);
                cell.deterministic = !is_randomised(method);
                expect_feasible(method, plan.scenes[scene], cell);
                cell.trials = cell.deterministic ? 1 : size.trials.value_or(plan.spec.trials);
                expect_room_for_pilot(plan.spec, method, cell);
                cell.canonical = canonical_text(plan.scenes[scene], method, cell);
                cell.key = derive_key(plan.spec.seed, cell.canonical);
                warnings.add_control(method);
                warnings.add_size(method, cell);
                expect_trials_at_hand(method, cell);
                warnings.add_trials(cell);
                plan.cells.push_back(std::move(cell));
                if (has_patch_systems(plan, plan.cells.size() - 1)) expect_few_patches(plan, plan.cells.size() - 1);
                add_units(plan, plan.cells.size() - 1, 0, plan.cells.back().trials, plan.units);
            }
        }
    }
    warn_about_left_out(plan, left_out, warnings);
    return plan;
}

bool tells_patches_apart(const StudyPlan& plan, std::size_t index) {
    const EstimatorInfo& estimator = estimator_info(plan.spec.methods[plan.cells[index].method]);
    const Scene& scene = plan.scenes[plan.cells[index].scene];
    return plan.cells[index].subdivision.patches(scene) > scene.surfaces.size() &&
           estimator.patch_factors != PatchFactors::none;
}

bool has_patch_systems(const StudyPlan& plan, std::size_t index) {
    return plan.spec.radiosity && plan.spec.radiosity->patch_trials > 0 && tells_patches_apart(plan, index);
}

std::uint64_t patch_trials(const StudyPlan& plan, std::size_t index) {
    return std::min(plan.cells[index].trials, plan.spec.radiosity->patch_trials);
}

void expect_few_patches(const StudyPlan& plan, std::size_t index) {
    const Cell& cell = plan.cells[index];
    const Method& method = plan.spec.methods[cell.method];
    const Scene& scene = plan.scenes[cell.scene];
    const std::uint32_t patches = radiating_patches(scene, cell.subdivision);
    const std::uint32_t most =
        estimator_info(method).patch_factors == PatchFactors::rays ? most_traced_patches : most_kernel_patches;
    if (!has_exact_patch_factors(scene)) {
        throw UserError(
            "[radiosity]: patch_trials in scene '{}' (patches have exact factors where all surfaces are parallelograms "
            "and unoccluded). Leave patch_trials out.",
            scene.name);
    }
    if (const auto* const added = samplers::find_added(method.sampler); added != nullptr && added->content().empty()) {
        throw UserError(
            "[radiosity]: patch_trials with method '{}' (reports compute these trials again, and the store "
            "does not hold what makes the points of {}). Leave patch_trials out.",
            method.name, method.sampler);
    }
    if (patches <= most) return;
    throw UserError(
        "[radiosity]: patch_trials with method '{}' and {} patches in all (every pair has a factor: at most {} patches "
        "with {}). Take fewer patches per face, or leave patch_trials out.",
        method.name, patches, most, method.estimator);
}

void expect_applicable(const Method& method, const Scene& scene) {
    const std::string refusal = find_estimator(method.estimator).refusal(estimator_options(method), scene);
    if (!refusal.empty()) throw UserError("method '{}': {}", method.name, refusal);
}

}  // namespace ff::studies
