// Properties of form factors in every scene, over random boxes and random pairs of rectangles.

#include "core/exact/exact.hpp"
#include "core/geometry/box.hpp"
#include "core/geometry/scene.hpp"
#include "tests/unit/core/geometry/random_rectangles.hpp"
#include "tests/unit/core/geometry/rectangles.hpp"

#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace ff {
namespace {

using test::any_box;
using test::any_rectangle;
using test::same_exchange_area;

/// Permitted error of a form factor, or of a row of them, of `source` in a box: the promised 1e-18 of the squared
/// extent for each of five exchange areas, and a few roundings to double. Only long and thin boxes come near the first
/// term.
double factor_tolerance(const Scene& box, double source_area) {
    return 5e-18 * box.empty_box.value().squaredNorm() / source_area + 1e-15;
}

double exchange(const Surface& from, const Surface& to) {
    return exact_exchange_area(from, to).value();
}

/// Sum over all pairs of patches.
double exchange_of_patches(const Surface& from, Grid of_from, const Surface& to, Grid of_to) {
    double sum = 0;
    for (std::uint32_t i = 0; i < of_from.parts(); ++i) {
        for (std::uint32_t j = 0; j < of_to.parts(); ++j) {
            sum += exchange(patch(from, of_from, i), patch(to, of_to, j));
        }
    }
    return sum;
}

RC_GTEST_PROP(ExactFormFactors, CloseInEveryBox, ()) {
    const Scene box = *any_box();
    const auto factors = exact_form_factors(box).value();
    for (int from = 0; from < 6; ++from) {
        RC_ASSERT(std::abs(factors.row(from).sum() - 1) <= factor_tolerance(box, face_area(box, from)));
    }
}

RC_GTEST_PROP(ExactFormFactors, AreReciprocalInEveryBox, ()) {
    const Scene box = *any_box();
    const auto factors = exact_form_factors(box).value();
    for (int from = 0; from < 6; ++from) {
        for (int to = 0; to < from; ++to) {
            const double there = face_area(box, from) * factors(from, to);
            const double back = face_area(box, to) * factors(to, from);
            const double allowed = 2e-18 * box.empty_box.value().squaredNorm() + 1e-15 * there;
            RC_ASSERT(std::abs(there - back) <= allowed);
        }
    }
}

RC_GTEST_PROP(ExactPatchToFace, ClosesAndAveragesToTheFacesInEveryBox, ()) {
    const Scene box = *any_box();
    const Subdivision subdivision{*rc::gen::inRange<std::uint32_t>(1, 6)};
    const auto patches = exact_patch_to_face(box, subdivision).value();
    const auto faces = exact_form_factors(box).value();
    const auto per_face = static_cast<Eigen::Index>(subdivision.per_part());
    for (int from = 0; from < 6; ++from) {
        const Eigen::MatrixXd rows = patches.middleRows(from * per_face, per_face);
        const double tolerance = factor_tolerance(box, face_area(box, from) / static_cast<double>(per_face));
        RC_ASSERT(rows.minCoeff() >= 0);
        RC_ASSERT((rows.rowwise().sum().array() - 1).abs().maxCoeff() <= tolerance);
        RC_ASSERT((rows.colwise().mean() - faces.row(from)).cwiseAbs().maxCoeff() <= tolerance);
    }
}

RC_GTEST_PROP(ExactExchangeArea, IsReciprocalAndNeverNegative, ()) {
    const Surface from = *any_rectangle();
    const Surface to = *any_rectangle();
    RC_CLASSIFY(exchange(from, to) > 0, "facing");
    RC_ASSERT(exchange(from, to) >= 0);
    RC_ASSERT(same_exchange_area(exchange(from, to), exchange(to, from), test::squared_extent(from, to)));
}

RC_GTEST_PROP(ExactExchangeArea, IsAdditiveUnderSubdivision, ()) {
    const Surface from = *any_rectangle();
    const Surface to = *any_rectangle();
    const auto any_number = rc::gen::inRange<std::uint32_t>(1, 4);
    const Grid of_from{*any_number, *any_number};
    const Grid of_to{*any_number, *any_number};
    const int parts = static_cast<int>(of_from.parts() * of_to.parts());
    RC_ASSERT(same_exchange_area(exchange(from, to), exchange_of_patches(from, of_from, to, of_to),
                                 test::squared_extent(from, to), parts));
}

RC_GTEST_PROP(ExactExchangeArea, NeverExceedsTheSmallerArea, ()) {
    const Surface from = *any_rectangle();
    const Surface to = *any_rectangle();
    RC_ASSERT(exchange(from, to) <=
              std::min(area(from.shape), area(to.shape)) + 1e-15 * test::squared_extent(from, to));
}

RC_GTEST_PROP(ExactExchangeArea, DoesNotDependOnPositionOrientationOrHandedness, ()) {
    const Surface from = *any_rectangle();
    const Surface to = *any_rectangle();
    const double expected = exchange(from, to);
    const double extent = test::squared_extent(from, to);
    const Eigen::Vector3d offset(*rc::gen::inRange(-1000, 1000), *rc::gen::inRange(-1000, 1000), 7);
    RC_ASSERT(
        same_exchange_area(exchange(test::translated(from, offset), test::translated(to, offset)), expected, extent));
    RC_ASSERT(same_exchange_area(exchange(test::axes_rotated(from), test::axes_rotated(to)), expected, extent));
    const int axis = *rc::gen::inRange(0, 3);
    RC_ASSERT(same_exchange_area(exchange(test::mirrored(from, axis), test::mirrored(to, axis)), expected, extent));
}

RC_GTEST_PROP(ExactExchangeArea, GrowsAsTheSquareOfTheScene, ()) {
    const Surface from = *any_rectangle();
    const Surface to = *any_rectangle();
    const double expected = exchange(from, to);
    // Powers of two lose nothing, to the last bit.
    RC_ASSERT(exchange(test::scaled(from, 1024), test::scaled(to, 1024)) == 1024.0 * 1024.0 * expected);
    const double factor = *rc::gen::inRange(1, 1000) / 16.0;
    RC_ASSERT(same_exchange_area(exchange(test::scaled(from, factor), test::scaled(to, factor)),
                                 factor * factor * expected, factor * factor * test::squared_extent(from, to)));
}

TEST(SameExchangeArea, NoticesADifferenceOfTwoParts) {
    EXPECT_TRUE(same_exchange_area(1, 1 + 1e-15, 1));
    EXPECT_FALSE(same_exchange_area(1, 1 + 3e-15, 1));
    EXPECT_FALSE(same_exchange_area(1, 1 - 6e-15, 1, 4));
}

TEST(ExchangeOfPatches, NoticesAMissingPatch) {
    const Surface floor = test::rectangle("0:1 0:1 0:0 +z");
    const Surface wall = test::rectangle("0:1 0:0 0:1 +y");
    const double patches = exchange_of_patches(floor, {2, 2}, wall, {2, 2});
    const double farthest = exchange(patch(floor, {2, 2}, 3), patch(wall, {2, 2}, 3));
    EXPECT_TRUE(same_exchange_area(exchange(floor, wall), patches, 3, 16));
    EXPECT_FALSE(same_exchange_area(exchange(floor, wall), patches - farthest, 3, 16));
}

}  // namespace
}  // namespace ff
