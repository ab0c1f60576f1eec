#include "core/estimators/pairs/contour.hpp"

#include "core/configurations/catalogue.hpp"
#include "core/exact/exact.hpp"
#include "core/geometry/box.hpp"
#include "core/geometry/scene.hpp"
#include "core/support/logarithm.hpp"
#include "tests/support/gauss_points.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace ff {
namespace {

TEST(Logarithm, MatchesTheLibraryToRounding) {
    for (const double x : {1e-300, 1e-5, 0.3, 0.7071, 0.70711, 0.999999, 1.0, 1.000001, 1.41422, 2.0, 10.0, 1e300})
        EXPECT_NEAR(logarithm(x), std::log(x), 3e-16 * std::max(1.0, std::abs(std::log(x)))) << x;
}

Eigen::MatrixXd with_nodes(const Scene& scene, int nodes, std::uint32_t m) {
    const test::GaussPoints points(nodes, 1);
    Outcome outcome;
    PatchTotals totals;
    Contour(scene, TracerChoice::automatic)
        .observe({.subdivision = {m}, .points = &points, .samples = points.points(), .options = {}, .key = {}}, outcome,
                 totals);
    return outcome.estimates;
}

double largest_error(const Scene& scene, int nodes, std::uint32_t m) {
    return (with_nodes(scene, nodes, m) - *exact_form_factors(scene)).cwiseAbs().maxCoeff();
}

TEST(Contour, ConvergesToAllDigitsBetweenParallelFaces) {
    const Scene cube = make_box(1, 1, 1);
    const Eigen::MatrixXd exact = *exact_form_factors(cube);
    EXPECT_NEAR(with_nodes(cube, 3, 1)(0, 5), exact(0, 5), 1e-3);
    EXPECT_NEAR(with_nodes(cube, 12, 1)(0, 5), exact(0, 5), 1e-11);
}

// Where faces touch, edges that meet in a corner leave the singularity of ln r there; edges that coincide leave none.
TEST(Contour, ConvergesWhereFacesTouch) {
    const Scene box = make_box(3, 2, 1);
    EXPECT_LT(largest_error(box, 4, 1), 2e-2);
    EXPECT_LT(largest_error(box, 16, 1), 1e-3);
    EXPECT_LT(largest_error(box, 16, 3), 1e-3);
}

TEST(Contour, IsRightBetweenTriangles) {
    const Scene scene = *configuration_scene("parallel_right_triangles");
    const Eigen::MatrixXd factors = with_nodes(scene, 12, 1);
    EXPECT_NEAR(factors(0, 1), 0.115049228149611, 1e-8);  // ffstudy list configurations
    EXPECT_NEAR(with_nodes(scene, 12, 2)(0, 1), 0.115049228149611, 1e-8);
}

TEST(Contour, RefusesTargetsPartlyBehind) {
    EXPECT_NE(Contour::refusal({}, *configuration_scene("l_shaped_room")).find("behind the plane of another"),
              std::string::npos);
}

}  // namespace
}  // namespace ff
