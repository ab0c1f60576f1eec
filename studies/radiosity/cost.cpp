#include "studies/radiosity/cost.hpp"

#include "core/radiosity/patch_factors.hpp"
#include "studies/plan/plan.hpp"
#include "studies/radiosity/systems.hpp"

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

namespace ff::studies::radiosity {
namespace {

/// Matrices between patches at a time: exact factors, estimates, treated ones, and what balancing or elimination needs.
constexpr std::uint64_t matrices = 9;
constexpr std::uint64_t bytes_of_a_kernel_pair = 110;
constexpr std::uint64_t bytes_of_a_small_matrix = 48;  // overhead beside its entries

constexpr double seconds_between_faces = 6e-6;  // a system of six faces
constexpr double seconds_of_an_exact_factor = 6e-7;
constexpr double seconds_of_a_traced_ray = 2e-8;  // one by one, beside its point
constexpr double seconds_of_an_entry = 3e-10;     // an entry of a matrix from memory, times a vector
constexpr double seconds_of_elimination = 6e-11;  // a floating-point operation
constexpr double passes_over_a_matrix = 150;      // properties, balancing, conditions
constexpr double passes_of_solvers = 10;          // all solvers, for each iteration of Jacobi's

/// Limit of the total cost of all solvers on one system between patches: near reflectance 1 they need thousands of
/// iterations.
constexpr double most_seconds_of_solvers = 10;

/// Iterations of Jacobi's method to the tolerance, by the largest reflectance.
double iterations(const RadiosityRequest& request, const std::vector<double>& reflectance) {
    const double largest = *std::max_element(reflectance.begin(), reflectance.end());
    return largest > 0 ? std::log(request.tolerance) / std::log(largest) : 1;
}

/// The cost of all solvers on one system.
double seconds_of_solvers(const RadiosityRequest& request, double n, const std::vector<double>& reflectance) {
    return 2.0 / 3 * n * n * n * seconds_of_elimination +
           passes_of_solvers * iterations(request, reflectance) * n * n * seconds_of_an_entry;
}

/// Seconds for the systems of one matrix, at all reflectances. @param n  patches
double seconds_of_systems(const StudyPlan& plan, double n, bool with_solvers) {
    const RadiosityRequest& request = *plan.spec.radiosity;
    double seconds = passes_over_a_matrix * n * n * seconds_of_an_entry;
    for (std::size_t setting = 0; setting < request.reflectance.size(); ++setting) {
        seconds += 2.0 / 3 * n * n * n * seconds_of_elimination;
        if (with_solvers && runs_solvers(plan, n, setting))
            seconds += seconds_of_solvers(request, n, request.reflectance[setting]);
    }
    return seconds;
}

}  // namespace

bool runs_solvers(const StudyPlan& plan, double patches, std::size_t setting) {
    const RadiosityRequest& request = *plan.spec.radiosity;
    return request.solver_trials > 0 &&
           seconds_of_solvers(request, patches, request.reflectance[setting]) <= most_seconds_of_solvers;
}

std::uint64_t memory_needed(const StudyPlan& plan) {
    if (!plan.spec.radiosity) return 0;
    const std::uint64_t settings = plan.spec.radiosity->reflectance.size();
    std::uint64_t largest = 0;
    for (std::size_t index = 0; index < plan.cells.size(); ++index) {
        const Cell& cell = plan.cells[index];
        const std::uint64_t faces = plan.scenes.faces(cell.scene).size();
        const std::uint64_t exitances = all_treatments.size() * settings * (faces + 4) * sizeof(double);
        std::uint64_t bytes = cell.trials * (2 * faces * faces * sizeof(double) + bytes_of_a_small_matrix + exitances);
        if (has_patch_systems(plan, index)) {
            const std::uint64_t n = radiating_patches(plan.scenes[cell.scene], cell.subdivision);
            const bool kernels = estimator_info(plan.spec.methods[cell.method]).patch_factors == PatchFactors::kernels;
            const std::uint64_t bytes_of_a_pair =
                std::max(matrices * sizeof(double), kernels ? bytes_of_a_kernel_pair : 0);
            const std::uint64_t trials = patch_trials(plan, index);
            bytes = std::max(bytes,
                             n * n * bytes_of_a_pair + trials * all_treatments.size() * settings * n * sizeof(double));
        }
        largest = std::max(largest, bytes);
    }
    return largest;
}

double seconds_needed(const StudyPlan& plan) {
    if (!plan.spec.radiosity) return 0;
    const RadiosityRequest& request = *plan.spec.radiosity;
    const auto settings = static_cast<double>(request.reflectance.size());
    constexpr auto treatments = static_cast<double>(all_treatments.size());
    double seconds = 0;
    std::set<std::pair<std::size_t, std::uint32_t>> with_exact_factors;  // scenes and subdivisions
    for (std::size_t index = 0; index < plan.cells.size(); ++index) {
        const Cell& cell = plan.cells[index];
        seconds += static_cast<double>(cell.trials) * treatments * settings * seconds_between_faces;
        if (!has_patch_systems(plan, index)) continue;
        const double n = radiating_patches(plan.scenes[cell.scene], cell.subdivision);
        const auto trials = static_cast<double>(patch_trials(plan, index));
        double trial = expected_seconds_per_trial(plan, cell);
        if (estimator_info(plan.spec.methods[cell.method]).patch_factors == PatchFactors::rays)
            trial += seconds_of_a_traced_ray * static_cast<double>(evaluations_per_trial(plan, cell));
        if (with_exact_factors.emplace(cell.scene, cell.subdivision.m).second)
            seconds += n * n / 2 * seconds_of_an_exact_factor + seconds_of_systems(plan, n, true);
        seconds += trials * (trial + treatments * seconds_of_systems(plan, n, false));
        seconds += seconds_of_systems(plan, n, true) - seconds_of_systems(plan, n, false);
    }
    return seconds;
}

}  // namespace ff::studies::radiosity
