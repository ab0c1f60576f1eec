#include "core/radiosity/iteration.hpp"

#include <memory>

namespace ff {
namespace {

/// Exitance that waits in the room, spread over it: what the unshot power becomes after all reflections, by the mean
/// reflectance.
struct Ambient {
    Eigen::VectorXd share;  // of each patch's unshot exitance

    explicit Ambient(const RadiositySystem& system) {
        const double total = system.areas.sum();
        const double mean = system.reflectance.dot(system.areas) / total;
        share = system.areas / (total * (1 - mean));
    }
};

/// n shots. Each goes from the patch with most unshot power; `ambient` adds what will come back to it, as if it were
/// there already, which leaves the patch with negative unshot power.
Iteration shooting(const RadiositySystem& system, std::shared_ptr<const Ambient> ambient) {
    return [&system, ambient = std::move(ambient),
            unshot = std::make_shared<Eigen::VectorXd>(residual(system, system.emission))](Eigen::VectorXd& m) {
        for (Eigen::Index shot = 0; shot < system.size(); ++shot) {
            Eigen::VectorXd to_shoot = *unshot;
            if (ambient) to_shoot += ambient->share.dot(*unshot) * system.reflectance;
            Eigen::Index from = 0;
            to_shoot.cwiseProduct(system.areas).cwiseAbs().maxCoeff(&from);
            // What the patch sends to itself is in the ambient exitance already.
            const double own = ambient ? 0 : system.reflectance[from] * system.factors(from, from);
            const double change = to_shoot[from] / (1 - own);
            m[from] += change;
            (*unshot)[from] -= change;
            *unshot += change * system.reflectance.cwiseProduct(system.factors.col(from));
        }
        return true;
    };
}

}  // namespace

SolverRun solve_by_shooting(const RadiositySystem& system, Solver solver, const SolverOptions& options) {
    const auto n = static_cast<double>(system.size());
    if (solver == Solver::progressive_refinement) return iterate(system, options, 4 * n * n, shooting(system, nullptr));
    return iterate(system, options, 8 * n * n, shooting(system, std::make_shared<Ambient>(system)));
}

}  // namespace ff
