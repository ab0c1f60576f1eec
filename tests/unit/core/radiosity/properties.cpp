#include "core/radiosity/system.hpp"

#include "core/radiosity/enclosures.hpp"
#include "tests/unit/core/radiosity/systems.hpp"

#include <gtest/gtest.h>
#include <Eigen/Eigenvalues>
#include <Eigen/LU>

#include <cmath>
#include <limits>
#include <random>

namespace ff {
namespace {

double radius_by_eigenvalues(const Eigen::MatrixXd& matrix) {
    return Eigen::EigenSolver<Eigen::MatrixXd>(matrix, false).eigenvalues().cwiseAbs().maxCoeff();
}

bool enclose(const RadiusBounds& bounds, double value) {
    return bounds.low <= value * (1 + 1e-13) && bounds.high >= value * (1 - 1e-13);
}

// Rows of the exact cube sum to 1, so that its spectral radius is 1, and rho with reflectance rho.
TEST(SpectralRadius, EqualsTheReflectanceOfTheExactCube) {
    for (const double reflectance : {0.1, 0.5, 0.999}) {
        const RadiusBounds bounds = spectral_radius(reflection_matrix(test::lit_cube(reflectance)));
        EXPECT_TRUE(enclose(bounds, reflectance));
        EXPECT_LT(bounds.high - bounds.low, 1e-12);
    }
}

TEST(SpectralRadius, LiesWithinItsBounds) {
    std::mt19937_64 engine(1);
    std::uniform_real_distribution<double> entry(0, 1);
    for (int n = 1; n <= 40; ++n) {
        Eigen::MatrixXd matrix(n, n);
        for (double& value : matrix.reshaped()) value = entry(engine) < 0.5 ? 0.0 : entry(engine);
        const RadiusBounds bounds = spectral_radius(matrix);
        const double radius = radius_by_eigenvalues(matrix);
        EXPECT_TRUE(enclose(bounds, radius)) << n << ": " << bounds.low << " " << radius << " " << bounds.high;
        if (n > 12) {
            EXPECT_LT(bounds.high - bounds.low, 1e-11 * radius) << n;  // hardly ever reducible
        }
        EXPECT_FALSE(enclose(bounds, 1.01 * bounds.high + 1e-9)) << "or the test could not fail";
    }
}

// The two eigenvalues of two plates differ only in sign: plain power iteration oscillates forever.
TEST(SpectralRadius, IsFoundWhereTwoEigenvaluesAreEquallyLarge) {
    const RadiusBounds bounds = spectral_radius((Eigen::MatrixXd(2, 2) << 0, 0.5, 0.08, 0).finished());
    EXPECT_TRUE(enclose(bounds, 0.2));
    EXPECT_LT(bounds.high - bounds.low, 1e-12);
}

TEST(SpectralRadius, IsZeroForTheZeroMatrix) {
    const RadiusBounds bounds = spectral_radius(Eigen::MatrixXd::Zero(3, 3));
    EXPECT_EQ(bounds.low, 0);
    EXPECT_EQ(bounds.high, 0);
}

TEST(SpectralRadius, KeepsItsBoundsApartForDisconnectedBlocks) {
    const Eigen::MatrixXd blocks = Eigen::Vector2d(0.5, 0.25).asDiagonal();
    const RadiusBounds bounds = spectral_radius(blocks);
    EXPECT_TRUE(enclose(bounds, 0.5));
    EXPECT_LE(bounds.low, 0.5);
}

TEST(FactorProperties, HaveNoDefectForExactFactors) {
    const RadiositySystem system = test::lit_box();
    const FactorProperties properties = factor_properties(system.factors, system.areas);
    EXPECT_LT(properties.closure_defect, 1e-14);
    EXPECT_LT(properties.reciprocity_defect, 1e-14);
    EXPECT_NEAR(properties.dominant_below(), 1, 1e-14);
}

TEST(FactorProperties, DistinguishClosureFromReciprocity) {
    const Eigen::MatrixXd direct = test::shot_factors(100, 3);
    const Eigen::VectorXd areas = test::lit_cube(0).areas;
    const FactorProperties of_direct = factor_properties(direct, areas);
    EXPECT_LT(of_direct.closure_defect, 1e-14);
    EXPECT_NEAR(of_direct.reciprocity_defect, (direct - direct.transpose()).cwiseAbs().maxCoeff(), 1e-15);
    EXPECT_GT(of_direct.reciprocity_defect, 0.01);
    const FactorProperties of_mirrored = factor_properties(test::mirrored(direct), areas);
    EXPECT_LT(of_mirrored.reciprocity_defect, 1e-15);
    EXPECT_GT(of_mirrored.closure_defect, 0.01);
}

// Dominance is lost exactly where the reflectance reaches 1 / the largest row sum, self-view or not.
TEST(Dominance, IsLostAtTheReciprocalOfTheLargestRowSum) {
    RadiositySystem system = test::lit_cube(0);
    system.factors = test::mirrored(test::shot_factors(100, 4));
    system.factors(0, 0) = 0.3;
    const double limit = factor_properties(system.factors, system.areas).dominant_below();
    ASSERT_LT(limit, 1);
    for (const double share : {0.5, 0.999999, 1.000001, 1.1}) {
        system.reflectance.setConstant(share * limit);
        EXPECT_EQ(solve_with_properties(system).properties.dominance > 0, share < 1) << share;
    }
}

// Rows that sum to 1 keep G dominant and P F convergent for every reflectance below 1, whatever the errors.
TEST(Dominance, IsKeptByRowsThatSumToOne) {
    RadiositySystem system = test::lit_cube(0);
    for (std::uint64_t seed = 1; seed <= 5; ++seed) {
        system.factors = test::shot_factors(20, seed);
        for (const double reflectance : {0.1, 0.9, 0.999, 0.999999}) {
            system.reflectance.setConstant(reflectance);
            const SystemProperties properties = solve_with_properties(system).properties;
            EXPECT_GT(properties.dominance, 0);
            EXPECT_LT(properties.spectral_radius.high, 1);
        }
    }
}

TEST(Condition, EstimatesTheConditionNumberFromBelow) {
    RadiositySystem system = test::lit_box();
    const Eigen::MatrixXd g = coefficient_matrix(system);
    const auto norm = [](const Eigen::MatrixXd& matrix) { return matrix.cwiseAbs().colwise().sum().maxCoeff(); };
    const double exact = norm(g) * norm(g.inverse());
    const double estimate = solve_with_properties(system).properties.condition;
    EXPECT_LE(estimate, exact * (1 + 1e-12));  // it is an estimate from below
    EXPECT_GT(estimate, exact / 3);            // and hardly ever off by more
    system.factors = cavity(2, 1).factors;
    system.areas = Eigen::Vector2d(2, 1);
    system.reflectance = Eigen::Vector2d(1, 1);  // no system of the world: singular
    EXPECT_GT(solve_with_properties(system).properties.condition, 1e15);
}

}  // namespace
}  // namespace ff
