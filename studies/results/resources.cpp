#include "studies/results/resources.hpp"

#include "core/formulas/rectangle_formulas.hpp"
#include "core/geometry/scene.hpp"
#include "core/visibility/occlusion.hpp"
#include "core/visibility/touching.hpp"
#include "studies/analysis/slopes.hpp"
#include "studies/plan/ladders.hpp"
#include "studies/radiosity/cost.hpp"
#include "studies/run/run.hpp"
#include "studies/store/records.hpp"
#include "studies/store/store.hpp"

#include <algorithm>
#include <vector>

namespace ff::studies {
namespace {

constexpr std::uint64_t program = 30ULL << 20;  // code, libraries, the scene, the reports as they are written
constexpr std::uint64_t bytes_of_a_row = 30;    // an observation in the store, with keys and page overhead
constexpr double seconds_of_a_row = 3e-6;       // two thirds to save it, one to read and evaluate it
constexpr std::uint64_t bytes_of_a_line = 100;  // a line of trials.csv, while it is made
constexpr double seconds_of_a_draw = 6e-9;      // one trial drawn into a resample of a ladder, for each pair of faces
constexpr double seconds_of_a_group = 8e-6;     // a trial of a pair in intervals by all rules, for [coverage]
// Processor time of `report` with 65 536 and 4096 patches per face of a cube, and a grid of 1024 x 1024: 1.7 to 2.6.
constexpr double seconds_of_a_patch_factor = 2.5e-6;  // exact, from a patch to a surface
// Its tables and pictures in report.html; for boxes the faces are laid flat. From the most memory of `convergence_rays`
// and `sr_vs_pdm`, and of `catalogue` and `occlusion`.
constexpr std::uint64_t bytes_of_a_cell_of_a_box = 1000 << 10;
constexpr std::uint64_t bytes_of_another_cell = 600 << 10;
constexpr std::uint64_t bytes_of_a_step = 350 << 10;  // a size of a long ladder, shown in tables only

// Costs of scenes, which are read, planned with and traced by Embree. Their text is kept in the study, in the store and
// in reports.
constexpr std::uint64_t bytes_of_a_surface = 400;
constexpr std::uint64_t copies_of_scene_text = 4;
constexpr double seconds_of_a_surface = 1e-5;
constexpr double seconds_of_a_pair_of_surfaces = 2e-8;  // whether faces are parallel or adjacent
constexpr double seconds_of_a_cell = 8e-3;              // its tables and pictures in all reports

std::uint64_t observations_per_trial(const StudyPlan& plan, const Cell& cell) {
    const std::uint64_t faces = plan.scenes.faces(cell.scene).size();
    return faces * faces;
}

/// Sums and sums of squares of the hits, or factors, of each patch on each face.
std::uint64_t patch_sums(const StudyPlan& plan, const Cell& cell) {
    if (estimator_info(plan.spec.methods[cell.method]).patch_factors == PatchFactors::none) return 0;
    const std::uint64_t patches = cell.subdivision.patches(plan.scenes[cell.scene]);
    return 2 * sizeof(std::uint64_t) * patches * plan.scenes.faces(cell.scene).size();
}

std::uint64_t largest_record(const StudyPlan& plan) {
    std::uint64_t largest = 0;
    for (const WorkUnit& unit : plan.units) {
        const Cell& cell = plan.cells[unit.cell];
        // Lists grow by doubling: a third of their room is free on average.
        const std::uint64_t observations =
            unit.trials * observations_per_trial(plan, cell) * sizeof(Observation) * 3 / 2;
        largest = std::max(largest, observations + patch_sums(plan, cell));
    }
    return largest;
}

std::uint64_t memory_of_analysis(const StudyPlan& plan) {
    std::uint64_t largest = 0;
    std::uint64_t all = 0;
    for (const Cell& cell : plan.cells) {
        const std::uint64_t faces = plan.scenes.faces(cell.scene).size();
        const std::uint64_t estimates = cell.trials * sizeof(double) * (faces * faces + 2 * faces + 8);
        largest = std::max(largest, estimates + cell.trials * bytes_of_a_line);
        all += estimates;
    }
    // The sizes of a ladder are held together while slopes are fitted to errors of each class of pairs and to their
    // absolute values: four times the estimates, as measured.
    for (const Ladder& ladder : find_ladders(plan)) {
        std::uint64_t estimates = 0;
        for (const std::size_t cell : ladder.cells)
            estimates += plan.cells[cell].trials * sizeof(double) * observations_per_trial(plan, plan.cells[cell]);
        largest = std::max(largest, 4 * estimates);
    }
    return std::max(plan.spec.published ? largest + all : largest, radiosity::memory_needed(plan));
}

double seconds_of_slopes(const StudyPlan& plan) {
    double draws = 0;
    for (const Ladder& ladder : find_ladders(plan)) {
        if (plan.cells[ladder.cells.front()].deterministic) continue;
        std::uint64_t trials = 0;
        for (const std::size_t cell : ladder.cells) trials += plan.cells[cell].trials;
        const double pairs = static_cast<double>(observations_per_trial(plan, plan.cells[ladder.cells.front()]));
        draws += pairs * static_cast<double>(trials) * resamples_of_ladder(trials);
    }
    return draws * seconds_of_a_draw;
}

/// Intervals are made of one pair of each class from each face.
double seconds_of_coverage(const StudyPlan& plan) {
    double groups = 0;
    for (const Cell& cell : plan.cells) {
        if (cell.deterministic) continue;
        const double pairs = 2 * static_cast<double>(plan.scenes.faces(cell.scene).size());
        groups += pairs * static_cast<double>(cell.trials) * static_cast<double>(plan.spec.coverage.size());
    }
    return groups * seconds_of_a_group;
}

/// Patches are compared with exact factors where `exact_patch_to_face` has them.
double seconds_of_patches(const StudyPlan& plan) {
    double factors = 0;
    for (const Cell& cell : plan.cells) {
        const Scene& scene = plan.scenes[cell.scene];
        const std::uint64_t patches = cell.subdivision.patches(scene);
        if (patch_sums(plan, cell) == 0 || patches == scene.surfaces.size()) continue;
        const bool has_exact =
            std::ranges::all_of(scene.surfaces, [](const Surface& s) { return aligned_rectangle(s).has_value(); }) &&
            !may_be_occluded(scene);
        if (has_exact) factors += static_cast<double>(patches) * static_cast<double>(scene.surfaces.size());
    }
    return factors * seconds_of_a_patch_factor;
}

std::uint64_t memory_of_scenes(const StudyPlan& plan) {
    std::uint64_t bytes = 0;
    for (const Scene& scene : plan.scenes) bytes += scene.surfaces.size() * bytes_of_a_surface;
    for (const SceneSource& scene : plan.spec.scenes) {
        if (scene.text) bytes += scene.text->size() * copies_of_scene_text;
    }
    return bytes;
}

/// Reading them, building tracers, and telling how faces lie to each other.
double seconds_of_scenes(const StudyPlan& plan) {
    double seconds = 0;
    for (const Scene& scene : plan.scenes) {
        seconds += static_cast<double>(scene.surfaces.size()) * seconds_of_a_surface;
        std::vector<double> surfaces(scene.faces.size());
        for (const Surface& surface : scene.surfaces) {
            if (surface.face != no_face) ++surfaces[static_cast<std::size_t>(surface.face)];
        }
        for (std::size_t i = 0; i < surfaces.size(); ++i) {
            for (std::size_t j = 0; j < i; ++j) {
                const double pairs = surfaces[i] * surfaces[j];
                if (pairs <= static_cast<double>(most_surface_pairs)) seconds += pairs * seconds_of_a_pair_of_surfaces;
            }
        }
    }
    return seconds;
}

std::uint64_t bytes_in_reports(const StudyPlan& plan, std::size_t cell) {
    return plan.scenes[plan.cells[cell].scene].empty_box ? bytes_of_a_cell_of_a_box : bytes_of_another_cell;
}

/// Bytes that reports take. Only the first and the last cell of a long ladder have pictures.
std::uint64_t memory_of_reports(const StudyPlan& plan) {
    std::uint64_t bytes = 0;
    for (std::size_t cell = 0; cell < plan.cells.size(); ++cell) bytes += bytes_in_reports(plan, cell);
    for (const Ladder& ladder : find_ladders(plan)) {
        if (ladder.cells.size() >= long_ladder)
            bytes -= (ladder.cells.size() - 2) * (bytes_in_reports(plan, ladder.cells.front()) - bytes_of_a_step);
    }
    return bytes;
}

}  // namespace

std::uint64_t expected_store_size(const StudyPlan& plan) {
    std::uint64_t bytes = 0;
    for (const Cell& cell : plan.cells) bytes += cell.trials * observations_per_trial(plan, cell) * bytes_of_a_row;
    for (const WorkUnit& unit : plan.units) bytes += patch_sums(plan, plan.cells[unit.cell]);
    return bytes;
}

double expected_seconds_of_results(const StudyPlan& plan) {
    double observations = 0;
    for (const Cell& cell : plan.cells)
        observations += static_cast<double>(cell.trials * observations_per_trial(plan, cell));
    return observations * seconds_of_a_row + seconds_of_slopes(plan) + seconds_of_coverage(plan) +
           seconds_of_patches(plan) + radiosity::seconds_needed(plan) + seconds_of_scenes(plan) +
           static_cast<double>(plan.cells.size()) * seconds_of_a_cell;
}

std::uint64_t expected_memory(const StudyPlan& plan, unsigned threads) {
    const std::uint64_t units =
        std::min<std::uint64_t>(plan.units.size(), threads + units_waiting(threads) + std::uint64_t{1});
    const std::uint64_t running =
        units * largest_record(plan) + std::min(Store::page_cache_bytes, expected_store_size(plan));
    const std::uint64_t reporting = memory_of_analysis(plan) + memory_of_reports(plan);
    return program + memory_of_scenes(plan) + std::max(running, reporting) + plan.units.size() * sizeof(WorkUnit);
}

}  // namespace ff::studies
