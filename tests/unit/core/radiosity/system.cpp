#include "core/radiosity/system.hpp"

#include "core/radiosity/solver.hpp"
#include "tests/unit/core/radiosity/systems.hpp"

#include <gtest/gtest.h>

namespace ff {
namespace {

// In a closed box where all patches emit and reflect alike, nothing distinguishes them: m = e / (1 - rho), whatever F
// is, as long as its rows sum to 1.
TEST(RadiositySystem, HasTheFurnaceSolutionForIdenticalPatches) {
    for (const double reflectance : {0.0, 0.1, 0.9, 0.999}) {
        // Rounding is magnified by the condition of G, (1 + rho) / (1 - rho) or less.
        const double rounding = 20 * 2.3e-16 * 2 / (1 - reflectance);
        RadiositySystem system = test::lit_cube(reflectance);
        system.emission.setConstant(3);
        for (const bool shot : {false, true}) {
            if (shot) system.factors = test::shot_factors(50, 1);
            const Eigen::VectorXd exitance = solve_exactly(system).value();
            for (const double m : exitance) EXPECT_NEAR(m * (1 - reflectance) / 3, 1, rounding) << reflectance;
        }
        if (reflectance == 0) continue;
        system.factors(0, 1) *= 1.01;
        const double off = solve_exactly(system).value()[0] * (1 - reflectance) / 3 - 1;
        EXPECT_GT(off, 100 * rounding) << "or the test could not fail";
    }
}

// Infinite parallel plates: m_1 = (e_1 + rho_1 e_2) / (1 - rho_1 rho_2).
TEST(RadiositySystem, HasTheSolutionOfTwoPlates) {
    RadiositySystem plates;
    plates.factors = (Eigen::MatrixXd(2, 2) << 0, 1, 1, 0).finished();
    plates.areas = Eigen::Vector2d(1, 1);
    plates.reflectance = Eigen::Vector2d(0.3, 0.8);
    plates.emission = Eigen::Vector2d(2, 0.5);
    const Eigen::VectorXd exitance = solve_exactly(plates).value();
    EXPECT_NEAR(exitance[0], (2 + 0.3 * 0.5) / (1 - 0.24), 1e-14);
    EXPECT_NEAR(exitance[1], (0.5 + 0.8 * 2) / (1 - 0.24), 1e-14);
}

TEST(EnergyBalance, ClosesForExactFactorsButNotForOthers) {
    RadiositySystem system = test::lit_box();
    const auto balance = [&] { return energy_balance(system, solve_exactly(system).value()); };
    EXPECT_NEAR(balance().emitted, 0.3 * 1 + 1 * 2, 1e-14);  // faces 3 (2 x 0.5) and 6 (2 x 1)
    EXPECT_NEAR(balance().defect(), 0, 1e-14);
    system.factors.row(2) *= 1.1;  // light from nowhere
    EXPECT_LT(balance().defect(), -1e-3);
    system.factors.row(2) *= 0.8;
    EXPECT_GT(balance().defect(), 1e-3);
}

TEST(Residual, IsZeroAtTheSolutionOnly) {
    const RadiositySystem system = test::lit_box();
    Eigen::VectorXd exitance = solve_exactly(system).value();
    EXPECT_LT(residual(system, exitance).cwiseAbs().maxCoeff(), 1e-14);
    EXPECT_EQ(residual(system, Eigen::VectorXd::Zero(6)), system.emission);
    exitance[4] += 0.1;
    EXPECT_NEAR(residual(system, exitance)[4], -0.1, 1e-14);
}

}  // namespace
}  // namespace ff
