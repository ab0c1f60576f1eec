#include "core/geometry/ear_clipping.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <random>
#include <vector>

namespace ff {
namespace {

using Eigen::Vector3d;
using Corners = std::vector<Vector3d>;

double area_of(const Vector3d& a, const Vector3d& b, const Vector3d& c) {
    return (b - a).cross(c - a).z() / 2;
}

/// Whether a place is inside by the rule that a line to the outside crosses an odd number of edges.
bool is_inside(const Vector3d& place, const Corners& outline) {
    bool inside = false;
    for (std::size_t i = 0; i < outline.size(); ++i) {
        const Vector3d& a = outline[i];
        const Vector3d& b = outline[(i + 1) % outline.size()];
        if ((a.y() > place.y()) == (b.y() > place.y())) continue;
        if (place.x() < a.x() + (place.y() - a.y()) / (b.y() - a.y()) * (b.x() - a.x())) inside = !inside;
    }
    return inside;
}

/// Triangles cover an outline where their areas, all positive, add up to its own, and none lies outside.
void expect_covers(const Corners& outline) {
    const auto triangles = clip_ears(outline);
    ASSERT_FALSE(triangles.empty());
    double whole = 0;
    for (std::size_t i = 1; i + 1 < outline.size(); ++i) whole += area_of(outline[0], outline[i], outline[i + 1]);
    double sum = 0;
    for (const auto& [a, b, c] : triangles) {
        const double area = area_of(outline[a], outline[b], outline[c]);
        EXPECT_GT(area, 0);
        EXPECT_TRUE(is_inside((outline[a] + outline[b] + outline[c]) / 3, outline)) << a << ' ' << b << ' ' << c;
        sum += area;
    }
    EXPECT_NEAR(sum, whole, 1e-12 * std::abs(whole));
}

class RandomOutlines : public testing::TestWithParam<std::uint64_t> {
  protected:
    /// A star around the middle of the unit square, counter-clockwise from its corner at the origin.
    Corners star() {
        const int corners = std::uniform_int_distribution(5, 12)(random_);
        Corners star{Vector3d::Zero()};
        for (int i = 0; i < corners; ++i) {
            const double turn = 0.05 + 0.9 * (i + between(0, 1)) / corners;
            const double angle = 2 * std::numbers::pi * (turn + 0.625);
            star.emplace_back(Vector3d(0.5, 0.5, 0) +
                              between(0.05, 0.5) * Vector3d(std::cos(angle), std::sin(angle), 0));
        }
        return star;
    }

  private:
    std::mt19937_64 random_{GetParam()};

    double between(double low, double high) { return std::uniform_real_distribution<double>(low, high)(random_); }
};

TEST_P(RandomOutlines, AreCoveredOnceFromAnyCorner) {
    Corners outline = star();
    for (std::size_t i = 0; i < outline.size(); ++i) {
        expect_covers(outline);
        std::rotate(outline.begin(), outline.begin() + 1, outline.end());
    }
}

TEST_P(RandomOutlines, MayTouchThemselvesAtACorner) {
    Corners outline = star();
    for (const Vector3d& corner : star()) outline.push_back(-corner);
    for (std::size_t i = 0; i < outline.size(); ++i) {
        expect_covers(outline);
        std::rotate(outline.begin(), outline.begin() + 1, outline.end());
    }
}

TEST_P(RandomOutlines, MayHaveHolesThatTouchThemAtACorner) {
    const Corners hole = star();
    Corners outline{{0, 0, 0}, {2, -0.5, 0}, {2, 2, 0}, {-0.5, 2, 0}, {0, 0, 0}};
    outline.insert(outline.end(), hole.rbegin(), hole.rend() - 1);
    for (std::size_t i = 0; i < outline.size(); ++i) {
        expect_covers(outline);
        std::rotate(outline.begin(), outline.begin() + 1, outline.end());
    }
}

INSTANTIATE_TEST_SUITE_P(, RandomOutlines, testing::Range<std::uint64_t>(0, 30));

TEST(EarClipping, RefusesEdgesThatCrossEachOther) {
    EXPECT_TRUE(clip_ears({{0, 0, 0}, {3, 0, 0}, {0, 1, 0}, {2, 1, 0}}).empty());
}

}  // namespace
}  // namespace ff
