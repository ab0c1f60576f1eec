#include "core/estimators/pairs/area_kernel.hpp"

#include "core/exact/exact.hpp"
#include "core/geometry/box.hpp"
#include "tests/support/gauss_points.hpp"
#include "tests/support/philox_points.hpp"
#include "tests/unit/core/estimators/faces.hpp"
#include "tests/unit/core/tracing/instruction_sets.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace ff {
namespace {

using test::face_1;
using test::face_2;
using test::face_6;

Eigen::MatrixXd kernel_with_gauss_points(const Scene& scene, std::uint32_t m, int source_nodes, int target_nodes) {
    return area_kernel(scene, {m}, test::GaussPoints(source_nodes, target_nodes), PointMap::uniform, {}, 0);
}

// Expected values: python3 tests/unit/core/estimators/pdm.py, an independent sum of the definition.
TEST(AreaKernel, IsThePatchToPatchIntegralWithGaussLegendrePoints) {
    const Scene cube = make_box(6, 6, 6);
    struct Case {
        std::uint32_t m;
        int source_nodes, target_nodes;
        double parallel, row_sum;
    };
    constexpr std::array<Case, 5> cases{{
        {6, 5, 5, 0.199824896, 1.051365114},
        {9, 5, 5, 0.199824896, 1.034243205},
        {13, 5, 5, 0.199824896, 1.023706747},  // errors 0.308 / m of the row sum, all from pairs with a common edge
        {6, 5, 6, 0.199824896, 0.991536546},   // -0.0508 / m: nodes do not face each other across the edge
        {6, 5, 2, 0.199824065, 1.000481352},   // 0.0029 / m
    }};
    for (const auto& c : cases) {
        const Eigen::MatrixXd factors = kernel_with_gauss_points(cube, c.m, c.source_nodes, c.target_nodes);
        for (int from = 0; from < 6; ++from) {
            EXPECT_NEAR(factors.row(from).sum(), c.row_sum, 6e-10) << c.m << ' ' << from;
        }
        EXPECT_NEAR(factors(face_1, face_6), c.parallel, 6e-10) << c.m;
    }
}

TEST(AreaKernel, GivesTheSameWhetherOrNotSymmetryIsUsed) {
    const Scene box = make_box(3, 2, 1);
    test::GaussPoints points(5, 5);
    const Eigen::MatrixXd halved = area_kernel(box, {3}, points, PointMap::uniform, {}, 0);
    points.deny_exchangeable();
    const Eigen::MatrixXd full = area_kernel(box, {3}, points, PointMap::uniform, {}, 0);
    EXPECT_LT((halved - full).cwiseAbs().maxCoeff(), 1e-14);
    EXPECT_NEAR(6 * full(face_1, face_2), 3 * full(face_2, face_1), 1e-14) << "A_1 F_12 = A_2 F_21";
}

// The patches of a face are equal: its factors are the means of theirs. Rounding of sums of some hundred terms.
void expect_means_of_patch_factors(const Scene& box, const PointSource& points, PointMap map) {
    constexpr std::uint32_t m = 3;
    PatchFactorSums sums;
    const Eigen::MatrixXd once = area_kernel(box, {m}, points, map, {1, 2}, 0, &sums);
    ASSERT_EQ(sums.factors.size(), 6u * m * m * 6);
    for (std::size_t i = 0; i < sums.factors.size(); ++i)
        ASSERT_DOUBLE_EQ(sums.factors_squared[i], sums.factors[i] * sums.factors[i]);
    const Eigen::MatrixXd twice = once + area_kernel(box, {m}, points, map, {1, 2}, 1, &sums);
    for (int from = 0; from < 6; ++from) {
        for (int to = 0; to < 6; ++to) {
            double sum = 0;
            for (std::uint32_t p = 0; p < m * m; ++p)
                sum += sums.factors[(static_cast<std::size_t>(from) * m * m + p) * 6 + static_cast<std::size_t>(to)];
            EXPECT_NEAR(sum / (m * m), twice(from, to), 1e-13) << from << ' ' << to;
        }
    }
}

TEST(AreaKernel, AveragesPatchFactorsIntoFaceFactors) {
    const Scene box = make_box(3, 2, 1);
    for (const PointMap map : {PointMap::uniform, PointMap::graded}) {
        expect_means_of_patch_factors(box, test::GaussPoints(4, 4), map);  // one set of points, both orders at once
        expect_means_of_patch_factors(box, test::GaussPoints(4, 3), map);  // one set of points
        expect_means_of_patch_factors(box, test::PhiloxPoints(50), map);   // points for each pair of patches
    }
}

TEST(AreaKernel, GivesThePatchFactorsOfBothOrdersAtOnce) {
    const Scene box = make_box(3, 2, 1);
    for (const PointMap map : {PointMap::uniform, PointMap::graded}) {
        test::GaussPoints points(4, 4);
        PatchFactorSums halved;
        PatchFactorSums full;
        area_kernel(box, {3}, points, map, {}, 0, &halved);
        points.deny_exchangeable();
        area_kernel(box, {3}, points, map, {}, 0, &full);
        ASSERT_EQ(halved.factors.size(), full.factors.size());
        for (std::size_t i = 0; i < full.factors.size(); ++i) EXPECT_NEAR(halved.factors[i], full.factors[i], 1e-14);
    }
}

TEST(AreaKernel, LeavesTheDiagonalAtZero) {
    EXPECT_TRUE(kernel_with_gauss_points(make_box(3, 2, 1), 2, 3, 3).diagonal().isZero(0));
}

TEST(AreaKernel, HasTheSameBitsWithEveryInstructionSet) {
    const Scene box = make_box(3, 2, 1);
    const auto results = test::with_each_instruction_set([&box] {
        const Eigen::MatrixXd fixed = kernel_with_gauss_points(box, 3, 5, 6);
        const Eigen::MatrixXd random = area_kernel(box, {2}, test::PhiloxPoints(1500), PointMap::uniform, {1, 2}, 3);
        std::vector<double> bits(fixed.reshaped().begin(), fixed.reshaped().end());
        bits.insert(bits.end(), random.reshaped().begin(), random.reshaped().end());
        return bits;
    });
    for (const auto& result : results) EXPECT_EQ(result, results.front());
}

// 200 trials of 16 x 300 points on parallel faces, where the variance is finite. A z test at alpha = 1e-6 (4.9) against
// the exact value. A bias of 0.2 % (4e-4) goes unnoticed with probability below .01 as long as the standard error is
// below 4e-4 / (4.9 + 2.4), which is checked as well.
TEST(AreaKernel, IsUnbiasedOnParallelFacesWithRandomPoints) {
    const Scene cube = make_box(6, 6, 6);
    const double exact = *exact_form_factor(cube, face_1, face_6);
    constexpr std::uint32_t trials = 200;
    double sum = 0;
    double sum_of_squares = 0;
    for (std::uint32_t trial = 0; trial < trials; ++trial) {
        const double error =
            area_kernel(cube, {2}, test::PhiloxPoints(300), PointMap::uniform, {5, 6}, trial)(face_1, face_6) - exact;
        sum += error;
        sum_of_squares += error * error;
    }
    const double mean = sum / trials;
    const double standard_error = std::sqrt((sum_of_squares / trials - mean * mean) / (trials - 1));
    EXPECT_LT(std::abs(mean), 4.9 * standard_error);
    EXPECT_LT(standard_error, 4e-4 / (4.9 + 2.4));
}

/// Every point at a corner of both patches, so that r = 0 for patches that touch there.
class CornerPoints : public test::PhiloxPoints {
  public:
    using PhiloxPoints::fill;
    CornerPoints() : PhiloxPoints(3) {}
    void fill(const Stream&, PointIndex, WeightedBlock& block) const override {
        for (std::size_t i = 0; i < block.size; ++i) {
            for (auto& row : block.coordinate) row[i] = 0;
            block.weight[i] = 1.0 / 3;
        }
    }
};

TEST(AreaKernel, CountsPointsThatCoincideAsZero) {
    const Eigen::MatrixXd factors = area_kernel(make_box(1, 1, 1), {1}, CornerPoints(), PointMap::uniform, {}, 0);
    EXPECT_TRUE(factors.allFinite());
    EXPECT_EQ(factors(face_1, 2), 0) << "z = 0 and y = 0 meet at the origin";
}

/// Remembers which streams it was asked for.
class StreamRecorder : public test::PhiloxPoints {
  public:
    using PhiloxPoints::fill;
    StreamRecorder() : PhiloxPoints(1) {}
    void fill(const Stream& stream, PointIndex first, WeightedBlock& block) const override {
        streams.emplace_back(stream.source, stream.target);
        PhiloxPoints::fill(stream, first, block);
    }
    mutable std::vector<std::pair<std::uint32_t, std::uint32_t>> streams;
};

TEST(AreaKernel, GivesEveryOrderedPairOfPatchesItsOwnStream) {
    StreamRecorder points;
    area_kernel(make_box(1, 1, 1), {2}, points, PointMap::uniform, {}, 0);
    EXPECT_EQ(points.streams.size(), 24u * 20u);
    std::sort(points.streams.begin(), points.streams.end());
    EXPECT_EQ(std::adjacent_find(points.streams.begin(), points.streams.end()), points.streams.end());
    for (const auto& [source, target] : points.streams) EXPECT_NE(source / 4, (target - 1) / 4);
}

}  // namespace
}  // namespace ff
