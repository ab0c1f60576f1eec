#include "studies/radiosity/treatment.hpp"

#include "core/patches/face_averages.hpp"
#include "studies/radiosity/lighting.hpp"

namespace ff::studies {
namespace {

Eigen::MatrixXd by_reciprocity(const Eigen::MatrixXd& direct, const Eigen::VectorXd& areas) {
    Eigen::MatrixXd result = direct;
    for (Eigen::Index i = 0; i < direct.rows(); ++i) {
        for (Eigen::Index j = 0; j < i; ++j) result(i, j) = direct(j, i) * (areas[j] / areas[i]);
    }
    return result;
}

Eigen::MatrixXd balanced(const Elements& elements, const Uncertainty& errors, const Eigen::MatrixXd& direct) {
    const Balanced result =
        balance(direct,
                errors.rays.size() > 0 ? weights_of_hits(direct, errors.rays, elements.areas, elements.sight)
                                       : weights_of_values(direct),
                elements.areas);
    return result.balanced ? result.factors : Eigen::MatrixXd();
}

Eigen::MatrixXd weighted(const Elements& elements, const Uncertainty& errors, const Eigen::MatrixXd& direct) {
    const Balanced result = balance_correlated(direct, errors.covariances, elements.areas, elements.sight);
    return result.balanced ? result.factors : Eigen::MatrixXd();
}

/// Kernels of points that are laid evenly have no variance where faces touch.
bool has_covariances(const Method& method, const Cell& cell, const TrialMatrices& trials) {
    if (cell.deterministic || trials.direct.size() < least_trials_of_covariances) return false;
    const auto touching =
        find_estimator(method.estimator).integrand(estimator_options(method), PairClass::adjacent, Hiding::none);
    if (touching == Integrand::unbounded) return false;
    return trials.direct.front().rows() <= most_correlated_patches;
}

std::vector<RowScatter> measure_scatters(const TrialMatrices& trials) {
    const Eigen::Index n = trials.direct.front().rows();
    const auto count = static_cast<Eigen::Index>(trials.direct.size());
    std::vector<RowScatter> scatters;
    for (Eigen::Index i = 0; i < n; ++i) {
        Eigen::MatrixXd rows(count, n);
        for (Eigen::Index t = 0; t < count; ++t) rows.row(t) = trials.direct[static_cast<std::size_t>(t)].row(i);
        scatters.push_back(scatter_of_row(rows));
    }
    return scatters;
}

/// @param rays  of a trial, where factors are shares of hits; else empty
std::vector<Eigen::MatrixXd> covariances_of(const std::vector<RowScatter>& scatters, const Eigen::VectorXd& rays,
                                            const Sight& sight) {
    std::vector<Eigen::MatrixXd> covariances;
    for (const RowScatter& row : scatters) {
        const auto i = static_cast<Eigen::Index>(covariances.size());
        const double half_a_hit = rays.size() > 0 ? 0.5 / (static_cast<double>(row.trials) * rays[i]) : 0;
        covariances.push_back(covariance_of_row(row, sight.row(i).transpose(), half_a_hit));
    }
    return covariances;
}

}  // namespace

std::string_view name(Treatment treatment) {
    static constexpr std::array<std::string_view, all_treatments.size()> names{"direct", "reciprocal", "normalised",
                                                                               "balanced", "weighted"};
    return names.at(static_cast<std::size_t>(treatment));
}

Treatment treatment_of(Completion completion) {
    return completion == Completion::direct ? Treatment::direct : Treatment::reciprocal;
}

TrialMatrices load_matrices(const Store& store, std::size_t cell_index) {
    const StudyPlan& plan = store.plan();
    const Cell& cell = plan.cells[cell_index];
    const CellEstimates estimates = load_estimates(store, cell_index, Completion::direct);
    const auto faces = static_cast<Eigen::Index>(estimates.faces);
    TrialMatrices trials;
    trials.numbers = estimates.trial_numbers;
    if (estimator_info(plan.spec.methods[cell.method]).observes == Observes::hits)
        trials.errors.rays =
            static_cast<double>(estimates.evaluations_per_face) * parts_a_surface(plan.scenes[cell.scene]);
    trials.direct.assign(estimates.trials(), Eigen::MatrixXd::Zero(faces, faces));
    for (Eigen::Index i = 0; i < faces; ++i) {
        for (Eigen::Index j = 0; j < faces; ++j) {
            const auto& values = estimates.factors[static_cast<std::size_t>(i * faces + j)];
            for (std::size_t trial = 0; trial < values.size(); ++trial) trials.direct[trial](i, j) = values[trial];
        }
    }
    if (has_covariances(plan.spec.methods[cell.method], cell, trials)) {
        trials.scatters = measure_scatters(trials);
        trials.errors.covariances =
            covariances_of(trials.scatters, trials.errors.rays, face_sight(plan.scenes[cell.scene]));
    }
    return trials;
}

Uncertainty errors_without(const TrialMatrices& trials, std::size_t trial, const Sight& sight) {
    std::vector<RowScatter> others = trials.scatters;
    for (std::size_t i = 0; i < others.size(); ++i)
        others[i] = without(others[i], trials.direct[trial].row(static_cast<Eigen::Index>(i)));
    return {.rays = trials.errors.rays, .covariances = covariances_of(others, trials.errors.rays, sight)};
}

Eigen::MatrixXd treat(const Elements& elements, const Uncertainty& errors, const Eigen::MatrixXd& direct,
                      Treatment treatment) {
    switch (treatment) {
        case Treatment::direct:
            return direct;
        case Treatment::reciprocal:
            return by_reciprocity(direct, elements.areas);
        case Treatment::normalised:
            return normalise_rows(by_reciprocity(direct, elements.areas));
        case Treatment::balanced:
            return balanced(elements, errors, direct);
        case Treatment::weighted:
            break;
    }
    return weighted(elements, errors, direct);
}

}  // namespace ff::studies
