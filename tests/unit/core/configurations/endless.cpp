#include "core/configurations/closed_forms.hpp"

#include "core/support/error.hpp"
#include "tests/unit/core/configurations/extended_precision.hpp"

#include <gtest/gtest.h>

#include <boost/math/quadrature/gauss.hpp>

#include <algorithm>
#include <array>
#include <cmath>

namespace ff {
namespace {

using test::pi;
using test::Real;

TEST(Wedge, MatchesTheCrossedStringsMethod) {
    for (const Real angle : {0.01L, 1.0L, pi / 2, 3.0L}) {
        // Plates from the origin to (1, 0) and (cos, sin): crossed strings are the plates, uncrossed ones their ends'
        // distance and nothing.
        const Real uncrossed = std::hypot(std::cos(angle) - 1, std::sin(angle));
        EXPECT_PRED3(test::near, wedge_factor(angle), (2 - uncrossed) / 2, 1e-18L);
    }
    EXPECT_THROW(wedge_factor(4), UserError);
    EXPECT_THROW(wedge_factor(-0.1L), UserError);
}

TEST(PlaneToTubes, MatchesTheShareOfDirectionsThatTheRowCovers) {
    for (const Real cover : {0.1L, 0.5L, 0.9L}) {
        // A tube's shadow is as wide as its diameter, the distance between two of them shrinks with the cosine.
        const auto covered = [cover](Real angle) {
            return std::cos(angle) * std::min(Real{1}, cover / std::cos(angle));
        };
        using Rule = boost::math::quadrature::gauss<Real, 30>;
        const Real edge = std::acos(cover);
        const Real by_directions = Rule::integrate(covered, 0.0L, edge) + Rule::integrate(covered, edge, pi / 2);
        EXPECT_PRED3(test::near, plane_to_tubes_factor(cover), by_directions, 1e-18L);
    }
    EXPECT_EQ(plane_to_tubes_factor(0), 0);
    EXPECT_EQ(plane_to_tubes_factor(1), 1);
    EXPECT_THROW(plane_to_tubes_factor(1.5L), UserError);
}

}  // namespace
}  // namespace ff
