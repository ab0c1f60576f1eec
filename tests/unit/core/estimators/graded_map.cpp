#include "core/estimators/graded_map.hpp"

#include "core/estimators/pairs/area_kernel.hpp"
#include "core/exact/exact.hpp"
#include "core/geometry/box.hpp"
#include "stats/basics/moments.hpp"
#include "stats/variances/tails.hpp"
#include "tests/support/gauss_points.hpp"
#include "tests/support/philox_points.hpp"
#include "tests/unit/core/tracing/instruction_sets.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace ff {
namespace {

/// Two unit squares at a right angle, with a common edge or, shifted along it by 1, a common vertex.
Scene two_squares(double shift) {
    Scene scene;
    scene.surfaces = {{Parallelogram{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {0, 0, 1}, 0},
                      {Parallelogram{{shift, 0, 0}, {1, 0, 0}, {0, 0, 1}}, {0, 1, 0}, 1}};
    scene.faces = {"floor", "wall"};
    return scene;
}

/// One kernel value for each trial.
std::vector<double> single_values(const Scene& scene, PointMap map, std::uint32_t trials) {
    std::vector<double> values;
    for (std::uint32_t trial = 0; trial < trials; ++trial)
        values.push_back(area_kernel(scene, {1}, test::PhiloxPoints(1), map, {7, 8}, trial)(0, 1));
    return values;
}

TEST(GradedPoints, PreserveTheIntegralOfAnyFunction) {
    // Ten nodes integrate polynomials up to degree 19 exactly, so the map changes nothing but the last digits.
    const test::GaussPoints points(10, 10);
    WeightedBlock block;
    double weights = 0, moments = 0;
    for (PointIndex first = 0; first < points.points(); first += block.size) {
        block.size = 1000;
        points.fill({}, first, block);
        grade_points({3, 1, 2, 3}, block);
        for (std::size_t i = 0; i < block.size; ++i) {
            weights += block.weight[i];
            moments += block.weight[i] * block.coordinate[0][i] * block.coordinate[1][i] * block.coordinate[2][i] *
                       block.coordinate[3][i];
        }
    }
    EXPECT_NEAR(weights, 1, 1e-13);
    EXPECT_NEAR(moments, 1.0 / 16, 1e-13);
}

TEST(GradedPair, HasTheContactAtZeroOfItsGradedCoordinates) {
    const Parallelogram source{{-1, -1, 0}, {1, 0, 0}, {0, 1, 0}};  // its corner at (1, 1) is the origin
    const Parallelogram target{{-1, 0, 0}, {1, 0, 0}, {0, 0, 1}};
    const GradedPair edge = grade_pair(source, target).value();
    EXPECT_EQ(edge.power, (std::array<std::uint32_t, 4>{1, 3, 1, 3}));
    EXPECT_EQ(edge.from.corner, Eigen::Vector3d(-1, 0, 0));
    EXPECT_EQ(edge.from.edge_v, Eigen::Vector3d(0, -1, 0));
    EXPECT_EQ(edge.to.corner, target.corner);

    const Parallelogram diagonal{{0, 0, 0}, {1, 0, 0}, {0, 0, 1}};
    const GradedPair vertex = grade_pair(source, diagonal).value();
    EXPECT_EQ(vertex.power, (std::array<std::uint32_t, 4>{2, 2, 2, 2}));
    EXPECT_EQ(vertex.from.corner, vertex.to.corner);

    EXPECT_FALSE(grade_pair(source, {{5, 0, 0}, {1, 0, 0}, {0, 0, 1}}));
}

// 200 000 kernel values each; the generalised Pareto law of the largest 2000 has a standard error of about .035.
// Theory and measurement are 4 standard errors apart by chance once in 15 000 runs; the indices themselves (shapes
// .667, .5, .4, and 0 or less) are distinguished: a map that did nothing would miss by 7 standard errors at an edge.
TEST(GradedMap, HasTheTailIndexOfTheory) {
    constexpr std::uint32_t trials = 200000;
    for (const auto& [shift, contact] : {std::pair{0.0, Contact::edge}, std::pair{1.0, Contact::vertex}}) {
        const Scene scene = two_squares(shift);
        EXPECT_EQ(closest_contact(scene, 0, 1), contact);
        for (const PointMap map : {PointMap::uniform, PointMap::graded}) {
            const auto fit = stats::fit_tail(single_values(scene, map, trials), 0.01).value();
            const auto index = kernel_tail_index(contact, map);
            if (index) {
                EXPECT_LT(std::abs(fit.shape - 1 / *index), 4 * fit.standard_error) << shift << ' ' << fit.shape;
            } else {
                EXPECT_LT(fit.shape, 4 * fit.standard_error) << shift;
            }
        }
    }
}

// A z test at alpha = 1e-6 (4.9) over 2000 trials of 256 points per pair of patches; a bias of 3 % (6e-3) goes
// unnoticed with probability below .01 as long as the standard error is below 6e-3 / (4.9 + 2.4), which is checked as
// well.
TEST(GradedMap, LeavesTheEstimateUnbiased) {
    for (const double shift : {0.0, 1.0}) {
        const Scene scene = two_squares(shift);
        const double exact = *exact_form_factor(scene, 0, 1);
        for (const std::uint32_t m : {1u, 2u}) {
            std::vector<double> values;
            for (std::uint32_t trial = 0; trial < 2000; ++trial) {
                values.push_back(
                    area_kernel(scene, {m}, test::PhiloxPoints(256), PointMap::graded, {3, m}, trial)(0, 1));
            }
            const auto moments = stats::moments_of(values, exact);
            const double standard_error = moments.standard_error().value();
            EXPECT_LT(std::abs(*moments.mean() - exact), 4.9 * standard_error) << shift << ' ' << m;
            EXPECT_LT(standard_error, 6e-3 / (4.9 + 2.4));
        }
    }
}

TEST(GradedMap, DoesNotHelpQuadrature) {
    // The ridge where points face each other across the edge stays, and the weights of the map sharpen it.
    const Scene cube = make_box(6, 6, 6);
    const Eigen::MatrixXd exact = *exact_form_factors(cube);
    const auto error = [&](PointMap map) {
        return (area_kernel(cube, {2}, test::GaussPoints(5, 5), map, {}, 0) - exact).cwiseAbs().maxCoeff();
    };
    EXPECT_NEAR(error(PointMap::uniform), 0.0385, 1e-4);
    EXPECT_NEAR(error(PointMap::graded), 0.595, 1e-3);
}

TEST(GradedMap, TreatsSharedAndPairwisePointsAlike) {
    // Points that are common to all pairs and points that each pair has for itself, but the same everywhere.
    class Fixed : public test::GaussPoints {
      public:
        using GaussPoints::GaussPoints;
        [[nodiscard]] bool randomised() const override { return true; }
    };
    const Scene box = make_box(3, 2, 1);
    const Eigen::MatrixXd common = area_kernel(box, {3}, test::GaussPoints(3, 3), PointMap::graded, {}, 0);
    const Eigen::MatrixXd own = area_kernel(box, {3}, Fixed(3, 3), PointMap::graded, {}, 0);
    EXPECT_LT((common - own).cwiseAbs().maxCoeff(), 1e-14);
}

TEST(GradedMap, HasTheSameBitsWithEveryInstructionSet) {
    const Scene box = make_box(3, 2, 1);
    const auto results = test::with_each_instruction_set([&box] {
        const Eigen::MatrixXd factors = area_kernel(box, {2}, test::PhiloxPoints(1500), PointMap::graded, {1, 2}, 3);
        return std::vector<double>(factors.reshaped().begin(), factors.reshaped().end());
    });
    for (const auto& result : results) EXPECT_EQ(result, results.front());
}

}  // namespace
}  // namespace ff
