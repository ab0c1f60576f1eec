#include "core/formulas/polygon_factor.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include <array>
#include <cmath>
#include <random>
#include <vector>

namespace ff {
namespace {

using Eigen::Vector3d;

TEST(ArcTerms, AreAnglesTimesCosines) {
    std::mt19937_64 engine(1);
    const auto draw = [&](double low, double high) { return std::uniform_real_distribution(low, high)(engine); };
    const Vector3d normal = Vector3d(1, 2, 3).normalized();
    Arcs arcs;
    std::vector<double> expected;
    while (!arcs.is_full()) {
        const Vector3d a(draw(-1, 1), draw(-1, 1), draw(-1, 1));
        // Arcs of all sizes, from a right angle down to a billionth of one.
        const Vector3d b = a + std::exp(draw(-20, 1)) * Vector3d(draw(-1, 1), draw(-1, 1), draw(-1, 1));
        const Vector3d across = a.cross(b);
        expected.push_back(std::atan2(across.norm(), a.dot(b)) * across.normalized().dot(normal));
        arcs.add(a, b);
    }
    std::array<double, Arcs::capacity> terms{};
    find_arc_terms(arcs, normal, terms);
    for (std::size_t k = 0; k < expected.size(); ++k) EXPECT_NEAR(terms[k], expected[k], 1e-15) << k;
}

TEST(ArcTerms, AreZeroForArcsWithoutLength) {
    Arcs arcs;
    arcs.add({1, 2, 3}, {2, 4, 6});
    arcs.add({0, 0, 0}, {1, 0, 0});
    std::array<double, Arcs::capacity> terms{};
    find_arc_terms(arcs, Vector3d::UnitZ(), terms);
    EXPECT_EQ(arcs.size, 2u) << "what it is padded with does not count";
    EXPECT_EQ(terms[0], 0);
    EXPECT_EQ(terms[1], 0);
}

}  // namespace
}  // namespace ff
