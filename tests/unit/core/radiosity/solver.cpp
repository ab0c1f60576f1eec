#include "core/radiosity/solver.hpp"

#include "core/radiosity/enclosures.hpp"
#include "core/radiosity/system.hpp"
#include "tests/unit/core/radiosity/systems.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace ff {
namespace {

double distance(const Eigen::VectorXd& a, const Eigen::VectorXd& b) {
    return (a - b).cwiseAbs().maxCoeff();
}

/// |m - G^-1 e| <= |G^-1| |residual|, and |G^-1| <= 1 / (1 - rho) in the max-norm where rows sum to 1.
double reach(const RadiositySystem& system, const SolverOptions& options) {
    return options.tolerance * system.emission.maxCoeff() / (1 - system.reflectance.maxCoeff());
}

RadiositySystem lit(const Enclosure& enclosure, double reflectance) {
    RadiositySystem system{enclosure.factors, enclosure.areas, {}, {}};
    system.reflectance = Eigen::VectorXd::Constant(system.size(), reflectance);
    system.emission = Eigen::VectorXd::Unit(system.size(), 0);
    return system;
}

TEST(EverySolver, AgreesWithElimination) {
    const SolverOptions options{.tolerance = 1e-10};
    for (const RadiositySystem& system : {test::lit_cube(0.1), test::lit_cube(0.9), test::lit_cube(0.999),
                                          test::lit_box(), lit(closed_cylinder(1, 2), 0.8), lit(cavity(2, 1), 0.95)}) {
        const Eigen::VectorXd exact = solve_exactly(system).value();
        for (const Solver solver : all_solvers) {
            const SolverRun run = solve(system, solver, options);
            EXPECT_EQ(run.outcome, SolverOutcome::converged) << name(solver);
            EXPECT_LE(distance(run.exitance, exact), reach(system, options)) << name(solver);
            EXPECT_LE(run.residuals.back(), options.tolerance);
            EXPECT_GT(run.flops, 0) << name(solver);
        }
    }
}

// Jacobi on the cube multiplies the slowest part of the error by rho each time.
TEST(Jacobi, TakesAsManyIterationsAsTheSpectralRadiusSays) {
    const SolverOptions options{.tolerance = 1e-6};
    for (const double reflectance : {0.5, 0.9, 0.99}) {
        const SolverRun run = solve(test::lit_cube(reflectance), Solver::jacobi, options);
        const std::size_t n = run.iterations();
        EXPECT_NEAR(run.residuals[n] / run.residuals[n - 1], reflectance, 1e-5);
        // The residual starts as rho F e; its part along the slowest vector is rho / 6 everywhere.
        const double expected = std::log(options.tolerance * 6 / reflectance) / std::log(reflectance);
        EXPECT_NEAR(static_cast<double>(n), expected, 2);
        EXPECT_EQ(run.flops, static_cast<double>(n) * (2 * 36 + 4 * 6));
    }
}

TEST(GaussSeidel, IsFasterThanJacobi) {
    const auto iterations = [](Solver solver) { return solve(test::lit_cube(0.95), solver).iterations(); };
    EXPECT_LT(iterations(Solver::gauss_seidel), iterations(Solver::jacobi));
    EXPECT_LT(iterations(Solver::chebyshev), iterations(Solver::jacobi) / 2);
    EXPECT_LT(iterations(Solver::conjugate_gradient), 6u);  // three distinct eigenvalues
}

// A first row that sums to 1.5 makes the spectral radius exceed 1: the series diverges, and so does every solver that
// sums it.
TEST(EverySolver, RecognisesDivergence) {
    RadiositySystem system = test::lit_cube(0.99);
    system.factors *= 1.02;
    ASSERT_GT(solve_with_properties(system).properties.spectral_radius.low, 1);
    for (const Solver solver : {Solver::jacobi, Solver::gauss_seidel, Solver::sor, Solver::chebyshev,
                                Solver::progressive_refinement, Solver::overshooting}) {
        const SolverRun run = solve(system, solver);
        EXPECT_EQ(run.outcome, SolverOutcome::diverged) << name(solver);
        EXPECT_LT(run.iterations(), 2000u) << name(solver);
    }
    // Elimination finds a solution, but not a possible exitance: light is negative.
    EXPECT_EQ(solve(system, Solver::lu).outcome, SolverOutcome::converged);
    EXPECT_LT(solve(system, Solver::lu).exitance.minCoeff(), 0);
}

TEST(EverySolver, StopsAtTheLastIterationAllowed) {
    const SolverRun run = solve(test::lit_cube(0.9999), Solver::jacobi, {.tolerance = 1e-6, .most_iterations = 100});
    EXPECT_EQ(run.outcome, SolverOutcome::exhausted);
    EXPECT_EQ(run.iterations(), 100u);
}

TEST(ConjugateGradient, IsMisledByNonReciprocalFactors) {
    RadiositySystem system = test::lit_cube(0.9);
    system.factors = test::shot_factors(100, 1);
    const SolverRun run = solve(system, Solver::conjugate_gradient, {.tolerance = 1e-10});
    EXPECT_NE(run.outcome, SolverOutcome::converged);
    system.factors = test::mirrored(system.factors);
    EXPECT_EQ(solve(system, Solver::conjugate_gradient, {.tolerance = 1e-10}).outcome, SolverOutcome::converged);
}

TEST(EverySolver, FinishesAtOnceWhenNothingIsReflected) {
    for (const Solver solver : all_solvers) {
        const SolverRun run = solve(test::lit_cube(0), solver);
        EXPECT_EQ(run.outcome, SolverOutcome::converged) << name(solver);
        EXPECT_EQ(run.exitance, test::lit_cube(0).emission) << name(solver);
    }
}

TEST(SolveExactly, RefusesSingularSystems) {
    RadiositySystem system = lit(cavity(2, 1), 0.5);
    system.factors << 0, 2, 2, 0;  // P F has the eigenvalue 1
    EXPECT_FALSE(solve_exactly(system));
    EXPECT_EQ(solve(system, Solver::lu).outcome, SolverOutcome::diverged);
}

}  // namespace
}  // namespace ff
