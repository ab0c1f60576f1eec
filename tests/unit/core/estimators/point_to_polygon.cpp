#include "core/estimators/points/point_to_polygon.hpp"

#include "core/exact/exact.hpp"
#include "core/geometry/box.hpp"
#include "core/geometry/scene.hpp"
#include "tests/support/gauss_points.hpp"
#include "tests/support/philox_points.hpp"
#include "tests/unit/core/estimators/faces.hpp"
#include "tests/unit/core/tracing/instruction_sets.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace ff {
namespace {

using test::face_1;
using test::face_6;

/// With n x n nodes on every patch (and one, of weight 1, on the target, where no point is).
Eigen::MatrixXd polygon_with_gauss_points(const Scene& scene, std::uint32_t m, int nodes) {
    const test::GaussPoints points(nodes, 1);
    return point_to_polygon(scene, {m}, points, points.points(), Allocation::patch, {}, 0);
}

Eigen::MatrixXd polygon_with_random_points(const Scene& scene, std::uint32_t m, std::uint64_t samples,
                                           Allocation allocation, std::uint32_t trial) {
    const std::uint64_t points = allocation == Allocation::face ? samples * m * m : samples;
    return point_to_polygon(scene, {m}, test::PhiloxPoints(points), samples, allocation, {1, 2}, trial);
}

TEST(PointToPolygon, LeavesOnlyTheErrorOfTheSourceIntegral) {
    const Scene box = make_box(3, 2, 1);
    const Eigen::MatrixXd exact = *exact_form_factors(box);
    EXPECT_NEAR(polygon_with_gauss_points(box, 2, 12)(face_1, face_6), exact(face_1, face_6), 1e-13) << "smooth";
    const double coarse = (polygon_with_gauss_points(box, 1, 6) - exact).cwiseAbs().maxCoeff();
    const double fine = (polygon_with_gauss_points(box, 4, 12) - exact).cwiseAbs().maxCoeff();
    EXPECT_LT(fine, coarse / 16) << "the jump at the corners is the error that is left";
    EXPECT_LT(fine, 2e-6);
}

TEST(PointToPolygon, SeesAllOfTheHemisphereFromEveryPoint) {
    const Eigen::MatrixXd factors = polygon_with_random_points(make_box(3, 2, 1), 3, 50, Allocation::patch, 0);
    for (int from = 0; from < 6; ++from) EXPECT_NEAR(factors.row(from).sum(), 1, 1e-14) << from;
    EXPECT_TRUE(factors.diagonal().isZero(0));
}

TEST(PointToPolygon, CountsOnlyWhatLiesAboveTheHorizonAndOnlyFromItsFront) {
    // Two plates that cross each other's plane without hiding anything: half of each is of no use to the other.
    const Surface floor{Parallelogram{{0, -1, 0}, {2, 0, 0}, {0, 2, 0}}, {0, 0, 1}, 0};
    const Surface wall{Parallelogram{{0, 0, -1}, {2, 0, 0}, {0, 0, 4}}, {0, 1, 0}, 1};
    Scene crossing;
    crossing.surfaces = {floor, wall};
    crossing.faces = {"floor", "wall"};
    const Eigen::MatrixXd factors = polygon_with_gauss_points(crossing, 8, 12);  // patches end where the planes meet
    const double exchange = *exact_exchange_area(floor, wall);
    EXPECT_NEAR(factors(0, 1), exchange / 4, 1e-5);
    EXPECT_NEAR(factors(1, 0), exchange / 8, 1e-5);
    EXPECT_GT(exchange / 4, 0.1);
}

// 200 trials of 4 x 256 points. On every pair a z test at alpha = 1e-7 (5.3; 3e-6 over all pairs) against the exact
// value; a bias of 2 % (4e-3) goes unnoticed with probability below .01 as long as the standard error is below
// 4e-3 / (5.3 + 2.4), which is checked as well.
TEST(PointToPolygon, IsUnbiasedWithEitherAllocation) {
    const Scene cube = make_box(6, 6, 6);
    const Eigen::MatrixXd exact = *exact_form_factors(cube);
    constexpr std::uint32_t trials = 200;
    for (const Allocation allocation : {Allocation::patch, Allocation::face}) {
        Eigen::ArrayXXd sum = Eigen::ArrayXXd::Zero(6, 6);
        Eigen::ArrayXXd squares = sum;
        for (std::uint32_t trial = 0; trial < trials; ++trial) {
            const Eigen::ArrayXXd error = (polygon_with_random_points(cube, 2, 256, allocation, trial) - exact).array();
            sum += error;
            squares += error.square();
        }
        const Eigen::ArrayXXd mean = sum / trials;
        const Eigen::ArrayXXd standard_error = ((squares / trials - mean.square()) / (trials - 1)).sqrt();
        for (int i = 0; i < 6; ++i) {
            for (int j = 0; j < 6; ++j) {
                if (i == j) continue;
                EXPECT_LT(std::abs(mean(i, j)), 5.3 * standard_error(i, j)) << i << ' ' << j;
                EXPECT_LT(standard_error(i, j), 4e-3 / (5.3 + 2.4)) << i << ' ' << j;
            }
        }
    }
}

TEST(PointToPolygon, HasTheSameBitsWithEveryInstructionSet) {
    const Scene box = make_box(3, 2, 1);
    const auto results = test::with_each_instruction_set([&box] {
        const Eigen::MatrixXd factors = polygon_with_random_points(box, 2, 1500, Allocation::patch, 3);
        return std::vector<double>(factors.reshaped().begin(), factors.reshaped().end());
    });
    for (const auto& result : results) EXPECT_EQ(result, results.front());
}

/// Remembers which points it was asked for.
class RequestRecorder : public test::PhiloxPoints {
  public:
    using PhiloxPoints::fill;
    struct Request {
        std::uint32_t source = 0, target = 0;
        PointIndex first = 0;
        std::size_t size = 0;
        auto operator<=>(const Request&) const = default;
    };
    using PhiloxPoints::PhiloxPoints;
    void fill(const Stream& stream, PointIndex first, WeightedBlock& block) const override {
        requests.push_back({stream.source, stream.target, first, block.size});
        EXPECT_EQ(block.dimension, 2u);
        PhiloxPoints::fill(stream, first, block);
    }
    mutable std::vector<Request> requests;
};

TEST(PointToPolygon, GivesEveryPatchItsOwnPoints) {
    RequestRecorder own(7);
    point_to_polygon(make_box(1, 1, 1), {2}, own, 7, Allocation::patch, {}, 0);
    ASSERT_EQ(own.requests.size(), 24u);
    for (std::uint32_t p = 0; p < 24; ++p) EXPECT_EQ(own.requests[p], (RequestRecorder::Request{p, 0, 0, 7}));

    RequestRecorder shared(28);
    point_to_polygon(make_box(1, 1, 1), {2}, shared, 7, Allocation::face, {}, 0);
    ASSERT_EQ(shared.requests.size(), 24u);
    for (std::uint32_t p = 0; p < 24; ++p)
        EXPECT_EQ(shared.requests[p], (RequestRecorder::Request{p / 4, 0, PointIndex{p % 4} * 7, 7}));
}

}  // namespace
}  // namespace ff
