#include "studies/trials/estimates.hpp"

#include "core/patches/face_averages.hpp"
#include "core/radiosity/patch_factors.hpp"
#include "core/support/contract.hpp"
#include "core/support/error.hpp"
#include "core/visibility/facing.hpp"

#include <algorithm>
#include <cmath>

namespace ff::studies {
namespace {

/// Direct estimates of one pair by trial; hits, not yet divided by the rays, where they are counted.
/// @throws IoError where the store lacks a trial that it says is saved
std::vector<double> direct_values(const Store& store, std::size_t cell, const DirectEstimates& direct, int from, int to,
                                  bool counted) {
    auto series = store.series(cell, counted ? observable::hits : observable::estimate, from, to);
    if (series.trial != direct.trial_numbers) {
        throw IoError(
            "{}: damaged (cell {} lacks trials of faces {} and {}). Take a copy, or remove it and "
            "run the study again.",
            store.database().file(), cell, from, to);
    }
    return std::move(series.value);
}

/// The number of rays from the face that was shot from, for each pair of faces.
std::vector<double> rays_of_pairs(const CellEstimates& estimates, const Scene& scene, Completion completion) {
    const Eigen::VectorXd of_face = static_cast<double>(estimates.samples_of_pair) * parts_a_surface(scene);
    std::vector<double> rays;
    for (Eigen::Index i = 0; i < of_face.size(); ++i) {
        for (Eigen::Index j = 0; j < of_face.size(); ++j)
            rays.push_back(completion == Completion::reciprocal ? of_face[std::min(i, j)] : of_face[i]);
    }
    return rays;
}

/// Hits add up exactly and are divided once, so that a row that closure fixes sums to 1 to the bit.
void divide_by_rays(CellEstimates& estimates) {
    const std::size_t faces = estimates.faces;
    for (std::size_t i = 0; i < faces; ++i) {
        const double rays = estimates.rays[i * faces + i];
        for (double& sum : estimates.row_sums[i]) sum /= rays;
        for (std::size_t j = 0; j < faces; ++j) {
            for (double& value : estimates.factors[i * faces + j]) value /= rays;
        }
    }
}

void add_row_sums(CellEstimates& estimates) {
    const std::size_t faces = estimates.faces;
    std::size_t trials = 0;
    for (const auto& values : estimates.factors) trials = std::max(trials, values.size());
    estimates.row_sums.assign(faces, std::vector<double>(trials, 0.0));
    for (std::size_t i = 0; i < faces; ++i) {
        for (std::size_t j = 0; j < faces; ++j) {
            const auto& values = estimates.factors[i * faces + j];
            for (std::size_t trial = 0; trial < values.size(); ++trial) estimates.row_sums[i][trial] += values[trial];
        }
    }
}

void add_sum_of_relative_errors(CellEstimates& estimates) {
    const std::size_t trials = estimates.trials();
    estimates.sum_relative_error.assign(trials, 0.0);
    for (const auto& sums : estimates.row_sums) {
        for (std::size_t trial = 0; trial < trials; ++trial) {
            estimates.sum_relative_error[trial] += 100.0 * std::abs(sums[trial] - 1.0);
        }
    }
}

std::size_t bytes_of(const CellEstimates& estimates) {
    std::size_t numbers = estimates.trial_numbers.size() + estimates.sum_relative_error.size();
    for (const auto& values : estimates.factors) numbers += values.size();
    for (const auto& values : estimates.row_sums) numbers += values.size();
    return numbers * sizeof(double);
}

}  // namespace

const std::vector<double>& CellEstimates::values(Quantity quantity) const {
    switch (quantity.kind) {
        case QuantityKind::form_factor: {
            FF_EXPECT(quantity.from >= 1 && quantity.to >= 1);
            return factors[static_cast<std::size_t>(quantity.from - 1) * faces +
                           static_cast<std::size_t>(quantity.to - 1)];
        }
        case QuantityKind::row_sum:
            return row_sums[static_cast<std::size_t>(quantity.from - 1)];
        case QuantityKind::sum_relative_error:
            break;
    }
    return sum_relative_error;
}

std::optional<double> CellEstimates::lattice(Quantity quantity) const {
    if (rays.empty() || quantity.kind == QuantityKind::sum_relative_error) return std::nullopt;
    const std::size_t row = static_cast<std::size_t>(quantity.from - 1) * faces;
    if (quantity.kind == QuantityKind::form_factor) return 1 / rays[row + static_cast<std::size_t>(quantity.to - 1)];
    for (std::size_t to = 0; to < faces; ++to) {
        if (rays[row + to] != rays[row]) return std::nullopt;
    }
    return 1 / rays[row];
}

CellEstimates load_estimates(const Store& store, std::size_t cell) {
    return load_estimates(store, cell, store.plan().spec.methods[store.plan().cells[cell].method].completion);
}

CellEstimates load_estimates(const Store& store, std::size_t cell_index, Completion completion) {
    const StudyPlan& plan = store.plan();
    const Cell& cell = plan.cells[cell_index];
    const Scene& scene = plan.scenes[cell.scene];
    const bool shoots = estimator_info(plan.spec.methods[cell.method]).observes == Observes::hits;
    const bool counted = shoots && has_one_surface_a_face(scene);
    const int faces = static_cast<int>(plan.scenes.faces(cell.scene).size());
    DirectEstimates direct;
    direct.trial_numbers = store.saved_trial_numbers(cell_index);
    for (int i = 1; i <= faces; ++i) {
        const bool with_itself = sees_itself(scene, i - 1);
        if (shoots) direct.lost_rays += static_cast<std::uint64_t>(store.total(cell_index, observable::lost, i, 0));
        for (int j = 1; j <= faces; ++j) {
            const bool used = i < j || (i > j && completion == Completion::direct) || (i == j && with_itself);
            direct.values.push_back(used ? direct_values(store, cell_index, direct, i, j, counted)
                                         : std::vector<double>());
        }
    }
    return complete(plan, cell_index, completion, std::move(direct));
}

CellEstimates complete(const StudyPlan& plan, std::size_t cell_index, Completion completion, DirectEstimates direct) {
    const Cell& cell = plan.cells[cell_index];
    const Method& method = plan.spec.methods[cell.method];
    const Scene& scene = plan.scenes[cell.scene];
    CellEstimates estimates;
    estimates.cell = cell_index;
    estimates.faces = plan.scenes.faces(cell.scene).size();
    estimates.trial_numbers = std::move(direct.trial_numbers);
    estimates.factors = std::move(direct.values);
    estimates.samples_of_pair = cell.samples_per_patch;
    const PointsServe points = estimator_info(method).points;
    if (points != PointsServe::scene) estimates.samples_of_pair *= cell.subdivision.per_part();
    if (points == PointsServe::pairs) estimates.samples_of_pair *= cell.subdivision.per_part();
    estimates.evaluations_per_face = (evaluations_per_trial(plan, cell) + estimates.faces - 1) / estimates.faces;
    const bool shoots = estimator_info(method).observes == Observes::hits;
    const bool counted = shoots && has_one_surface_a_face(scene);
    if (shoots && plan.scenes.is_closed(cell.scene))
        estimates.lost_rays = direct.lost_rays;  // out of an open scene rays may go
    if (counted) estimates.rays = rays_of_pairs(estimates, scene, completion);
    const std::size_t faces = estimates.faces;
    const Eigen::VectorXd areas = face_areas(scene);
    for (std::size_t i = 0; completion == Completion::reciprocal && i < faces; ++i) {
        for (std::size_t j = 0; j < i; ++j) {
            const std::size_t row = i * faces;
            auto& target = estimates.factors[row + j];
            target = estimates.factors[j * faces + i];
            double ratio = areas[static_cast<Eigen::Index>(j)] / areas[static_cast<Eigen::Index>(i)];
            // Hits of j, as if they were of the rays of i.
            if (counted) ratio *= estimates.rays[row + i] / estimates.rays[row + j];
            for (double& value : target) value *= ratio;
        }
    }
    add_row_sums(estimates);
    if (counted) divide_by_rays(estimates);
    if (plan.scenes.is_closed(cell.scene)) add_sum_of_relative_errors(estimates);
    return estimates;
}

stats::KnownLimits known_limits(const StudyPlan& plan, const CellEstimates& estimates, Quantity quantity) {
    const Cell& cell = plan.cells[estimates.cell];
    return known_limits(plan.spec.methods[cell.method], plan.scenes[cell.scene], cell.subdivision, quantity,
                        estimates.samples_of_pair, estimates.trials());
}

std::vector<Quantity> distinct_pairs(std::size_t faces, Completion completion) {
    std::vector<Quantity> pairs;
    const int count = static_cast<int>(faces);
    for (int i = 1; i <= count; ++i) {
        for (int j = completion == Completion::reciprocal ? i + 1 : 1; j <= count; ++j) {
            if (i != j) pairs.push_back({QuantityKind::form_factor, i, j});
        }
    }
    return pairs;
}

std::vector<Quantity> all_quantities(const CellEstimates& estimates) {
    auto quantities = distinct_pairs(estimates.faces, Completion::direct);
    for (int i = 1; i <= static_cast<int>(estimates.faces); ++i) {
        const Quantity with_itself{QuantityKind::form_factor, i, i};
        if (!estimates.values(with_itself).empty()) quantities.push_back(with_itself);
    }
    for (int i = 1; i <= static_cast<int>(estimates.faces); ++i) quantities.push_back({QuantityKind::row_sum, i, 0});
    if (!estimates.sum_relative_error.empty()) quantities.push_back({QuantityKind::sum_relative_error, 0, 0});
    return quantities;
}

std::shared_ptr<const CellEstimates> CellReader::load(std::size_t cell) const {
    const auto found = std::ranges::find_if(kept_, [&](const auto& kept) { return kept->cell == cell; });
    if (found != kept_.end()) {
        kept_.splice(kept_.begin(), kept_, found);
    } else {
        kept_.push_front(std::make_shared<const CellEstimates>(load_estimates(*store_, cell)));
        std::size_t bytes = 0;
        const auto beyond = std::find_if(std::next(kept_.begin()), kept_.end(), [&](const auto& kept) {
            bytes += bytes_of(*kept);
            return bytes > most_kept_;
        });
        kept_.erase(beyond, kept_.end());
    }
    return kept_.front();
}

}  // namespace ff::studies
