#include "studies/analysis/patch_error.hpp"

#include "core/exact/exact.hpp"
#include "core/patches/patch_order.hpp"
#include "core/visibility/mirrors.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

namespace ff::studies {
namespace {

/// Sums over all saved trials of what a trial estimates for the factors from each patch to each face:
/// [patch * faces + face]; empty where none are kept.
struct PatchTotals {
    std::uint64_t trials = 0;
    std::vector<double> sum;
    std::vector<double> sum_of_squares;
};

PatchTotals patch_totals(const Store& store, std::size_t cell) {
    const Cell& planned = store.plan().cells.at(cell);
    const bool counted = estimator_info(store.plan().spec.methods[planned.method]).observes == Observes::hits;
    const auto rays = static_cast<double>(planned.samples_per_patch);
    PatchTotals totals;
    Statement query(store.database().handle(),
                    "SELECT trials, patch_hits, patch_hits_squared FROM units WHERE cell = ? ORDER BY unit");
    query.bind(0, static_cast<std::int64_t>(cell));
    while (query.step()) {
        const auto sum = query.integers(1);
        const auto squares = query.integers(2);
        if (sum.empty()) continue;
        totals.trials += static_cast<std::uint64_t>(query.integer(0));
        totals.sum.resize(sum.size());
        totals.sum_of_squares.resize(squares.size());
        for (std::size_t i = 0; i < sum.size(); ++i) {
            totals.sum[i] += counted ? static_cast<double>(sum[i]) / rays : std::bit_cast<double>(sum[i]);
            totals.sum_of_squares[i] +=
                counted ? static_cast<double>(squares[i]) / (rays * rays) : std::bit_cast<double>(squares[i]);
        }
    }
    return totals;
}

bool at_edge(const PatchPlace& place, Grid grid) {
    return std::min(place.row, place.column) == 0 || place.row == grid.rows - 1 || place.column == grid.columns - 1;
}

double root_of_mean(double sum, std::size_t count) {
    return count == 0 ? 0 : std::sqrt(sum / static_cast<double>(count));
}

}  // namespace

std::optional<PatchErrors> patch_errors(const Store& store, std::size_t cell_index) {
    const Cell& cell = store.plan().cells[cell_index];
    const Scene& scene = store.plan().scenes[cell.scene];
    const std::size_t faces = scene.faces.size();
    const PatchOrder order(scene, cell.subdivision);
    const std::size_t patches = order.size();
    const PatchTotals sums = patch_totals(store, cell_index);
    if (patches == scene.surfaces.size() || sums.trials == 0 || sums.sum.size() != patches * faces) return std::nullopt;
    const auto exact = exact_patch_to_face(scene, cell.subdivision);
    if (!exact) return std::nullopt;

    PatchErrors errors;
    const auto trials = static_cast<double>(sums.trials);
    double edge_squares = 0;
    double inner_squares = 0;
    std::size_t edge_patches = 0;
    std::size_t inner_patches = 0;
    for (std::uint32_t patch = 0; patch < patches; ++patch) {
        const PatchPlace place = order.place(patch);
        const Surface& surface = scene.surfaces[place.surface];
        if (!is_of_face(surface)) {
            errors.rmse.push_back(0);
            continue;
        }
        const auto own = static_cast<std::size_t>(surface.face);
        double squares = 0;
        for (std::size_t face = 0; face < faces; ++face) {
            if (face == own) continue;
            const double truth = (*exact)(patch, static_cast<Eigen::Index>(face));
            const double mean = sums.sum[patch * faces + face] / trials;
            const double mean_square = sums.sum_of_squares[patch * faces + face] / trials;
            const double variance = sums.trials == 1 ? 0 : std::max(0.0, mean_square - mean * mean);
            squares += variance + (mean - truth) * (mean - truth);
        }
        squares /= static_cast<double>(faces - 1);
        errors.rmse.push_back(std::sqrt(squares));
        const bool edge = at_edge(place, cell.subdivision.of(surface));
        (edge ? edge_squares : inner_squares) += squares;
        ++(edge ? edge_patches : inner_patches);
    }
    errors.at_edges = root_of_mean(edge_squares, edge_patches);
    errors.inside = root_of_mean(inner_squares, inner_patches);
    errors.worst =
        static_cast<std::size_t>(std::max_element(errors.rmse.begin(), errors.rmse.end()) - errors.rmse.begin());
    return errors;
}

}  // namespace ff::studies
