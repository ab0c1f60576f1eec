#include "core/geometry/convex_polygon.hpp"
#include "core/geometry/surface_map.hpp"
#include "core/visibility/facing.hpp"
#include "core/visibility/occlusion.hpp"
#include "stats/basics/moments.hpp"
#include "stats/basics/resampling.hpp"
#include "studies/form_factors/form_factors.hpp"
#include "tests/support/repetitions.hpp"
#include "tests/support/statistical_assertions.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace ff::studies::form_factors {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

/// A room with bodies in it: boxes that stand on its floor or hang in the air, and meshes of triangles with dents, cut
/// through each other as they come; turned, of any size and anywhere. Each polygon is a face.
class RandomRoom {
  public:
    explicit RandomRoom(stats::Draws& draws)
        : draws_(draws), turn_(draws.uniform() < 0.8 ? any_turn() : Matrix3d::Identity()), unit_(any_unit()) {
        const Vector3d away = draws.uniform() < 0.3 ? Vector3d(30, -20, 10) : Vector3d::Zero();
        add_box({0, 0, 0}, {1, 1, 1}, Matrix3d::Identity(), Sides::inward);
        for (int bodies = static_cast<int>(between(1, 4)); bodies > 0; --bodies) {
            if (draws.uniform() < 0.5) {
                add_mesh({between(0.2, 0.8), between(0.2, 0.8), between(0.2, 0.8)}, between(0.1, 0.35));
                continue;
            }
            const bool stands = draws.uniform() < 0.5;
            const Vector3d low(between(0.1, 0.6), between(0.1, 0.6), stands ? 0 : between(0.1, 0.6));
            const Matrix3d turn = stands ? about_z() : any_turn();
            const Sides sides = stands ? Sides::but_the_bottom : Sides::outward;
            add_box(low, {between(0.05, 0.3), between(0.05, 0.3), between(0.05, 0.3)}, turn, sides);
        }
        for (Surface& surface : scene_.surfaces) place(surface, away);
        scene_.canonical = "random room";
    }

    [[nodiscard]] const Scene& scene() const { return scene_; }

  private:
    stats::Draws& draws_;
    Matrix3d turn_;
    double unit_;
    Scene scene_;

    double between(double low, double high) { return low + (high - low) * draws_.uniform(); }
    double any_unit() { return std::pow(10, std::floor(between(-6, 7))); }
    Matrix3d about_z() { return Eigen::AngleAxisd(between(0, 3), Vector3d::UnitZ()).toRotationMatrix(); }
    Matrix3d any_turn() {
        const Vector3d axis(between(-1, 1), between(-1, 1), between(0.1, 1));
        return Eigen::AngleAxisd(between(0, 3), axis.normalized()).toRotationMatrix();
    }

    void place(Surface& surface, const Vector3d& away) {
        const auto at = [&](const Vector3d& v) { return Vector3d(unit_ * (turn_ * v + away)); };
        if (auto* triangle = std::get_if<Triangle>(&surface.shape)) {
            *triangle = {at(triangle->a), at(triangle->b), at(triangle->c)};
        } else {
            auto& sides = std::get<Parallelogram>(surface.shape);
            sides = {at(sides.corner), unit_ * (turn_ * sides.edge_u), unit_ * (turn_ * sides.edge_v)};
        }
        const ConvexPolygon polygon = corners(surface.shape);
        surface.normal = (polygon[1] - polygon[0]).cross(polygon[2] - polygon[1]).normalized();
    }

    void add(const Shape& shape) {
        const int face = static_cast<int>(scene_.faces.size());
        scene_.faces.push_back(std::to_string(face));
        scene_.surfaces.push_back({shape, Vector3d::UnitZ(), face});
    }

    enum class Sides : std::uint8_t { inward, outward, but_the_bottom };

    void add_box(const Vector3d& low, const Vector3d& size, const Matrix3d& turn, Sides sides) {
        for (Eigen::Index axis = 0; axis < 3; ++axis) {
            for (const bool far : {false, true}) {
                Vector3d u = turn.col((axis + 1) % 3) * size[(axis + 1) % 3];
                Vector3d v = turn.col((axis + 2) % 3) * size[(axis + 2) % 3];
                if (sides == Sides::but_the_bottom && axis == 2 && !far) continue;
                if (far == (sides == Sides::inward)) std::swap(u, v);
                const Vector3d corner = far ? Vector3d(low + turn.col(axis) * size[axis]) : low;
                if (draws_.uniform() < 0.5) {
                    add(Parallelogram{corner, u, v});
                } else {
                    add(Triangle{corner, corner + u, corner + u + v});
                    add(Triangle{corner, corner + u + v, corner + v});
                }
            }
        }
    }

    void add_mesh(const Vector3d& centre, double size) {
        constexpr std::size_t meridians = 4;
        const Matrix3d turn = any_turn();
        const auto at = [&](const Vector3d& direction) {
            return Vector3d(centre + size * between(0.3, 1) * (turn * direction));
        };
        std::array<std::array<Vector3d, meridians>, 2> rings;
        for (std::size_t k = 0; k < meridians; ++k) {
            const double angle = 2 * std::numbers::pi * static_cast<double>(k) / meridians;
            rings[0][k] = at({std::cos(angle), std::sin(angle), 0.5});
            rings[1][k] = at({std::cos(angle), std::sin(angle), -0.5});
        }
        const Vector3d top = at({0, 0, 1});
        const Vector3d bottom = at({0, 0, -1});
        for (std::size_t k = 0; k < meridians; ++k) {
            const std::size_t next = (k + 1) % meridians;
            add(Triangle{top, rings[0][k], rings[0][next]});
            add(Triangle{bottom, rings[1][next], rings[1][k]});
            add(Triangle{rings[0][k], rings[1][k], rings[1][next]});
            add(Triangle{rings[0][k], rings[1][next], rings[0][next]});
        }
    }
};

/// An exchange area by lines between random places, with all surfaces in between.
struct ByLines {
    stats::Moments values;
    double most = 0;  ///< largest value that a line may count
};

ByLines by_lines(const Scene& scene, const Surface& from, const Surface& to, stats::Draws& draws, bool forgets_one) {
    constexpr int lines = 2000;
    std::vector<const Surface*> others;
    for (const Surface& surface : scene.surfaces) {
        if (&surface != &from && &surface != &to) others.push_back(&surface);
    }
    ByLines result;
    const SurfaceMap begins(from);
    const SurfaceMap ends(to);
    for (int k = 0; k < lines; ++k) {
        const SurfacePoint p = begins.at(draws.uniform(), draws.uniform());
        const SurfacePoint q = ends.at(draws.uniform(), draws.uniform());
        const Vector3d apart = q.position - p.position;
        const double square = apart.squaredNorm();
        const double open = std::max(0.0, apart.dot(p.normal)) * std::max(0.0, -apart.dot(q.normal)) /
                            (std::numbers::pi * square * square) * area(from.shape) * area(to.shape);
        result.most = std::max(result.most, open);
        const bool is_seen = open > 0 && (forgets_one || sees(p.position, from, q.position, to, others));
        result.values.add(is_seen ? open : 0);
    }
    result.most /= lines;
    return result;
}

struct ComparedRooms {
    std::uint64_t pairs = 0;
    std::uint64_t beyond = 0;
    std::uint64_t beyond_open = 0;  ///< were nothing in between
};

ComparedRooms compare_rooms(std::uint64_t seed, std::uint64_t rooms) {
    ComparedRooms result;
    for (std::uint64_t k = 0; k < rooms; ++k) {
        stats::Draws draws(derive_key(Seed{seed}, "random rooms"), stats::Resampling::simulation,
                           static_cast<std::uint32_t>(k));
        const RandomRoom room(draws);
        const Scene& scene = room.scene();
        Request request;
        request.tolerance = 5e-3;
        request.seed = Seed{k};
        const Matrix matrix = find_matrix(scene, request);
        for (int pair = 0; pair < 40; ++pair) {
            const auto count = static_cast<double>(scene.surfaces.size());
            const auto a = static_cast<std::size_t>(count * draws.uniform());
            const auto b = static_cast<std::size_t>(count * draws.uniform());
            const Surface& from = scene.surfaces[a];
            const Surface& to = scene.surfaces[b];
            const auto gap = box_around(from).exteriorDistance(box_around(to));
            const double size = std::sqrt(std::min(area(from.shape), area(to.shape)));
            if (a == b || !face_each_other(from, to) || gap < 0.3 * size) continue;
            const FaceExchange found = matrix.exchange(a, b);
            const auto is_beyond = [&](const ByLines& lines) {
                // Few lines may show that a little is seen, or none.
                const double rare = 8 * lines.most + 1e-5 * size * size;
                const double room_left = 5 * *lines.values.standard_error() + rare + 0.5 * (found.high - found.low);
                return *lines.values.mean() < found.low - room_left || *lines.values.mean() > found.high + room_left;
            };
            ++result.pairs;
            const bool beyond = is_beyond(by_lines(scene, from, to, draws, false));
            result.beyond += beyond;
            result.beyond_open += is_beyond(by_lines(scene, from, to, draws, true));
            if (beyond) fmt::print("room {}, faces {} and {}: {}\n", k, a, b, found.value);
        }
    }
    return result;
}

// Each line is tested by itself against all surfaces: nothing here knows of meshes, bodies, walls or shadows. Up to 2
// in 10 000 lie beyond what both ways may be off by; one in 20 would be noticed with probability 0.9, nightly one in
// 500.
TEST(FormFactorsInRandomRooms, AgreeWithLines) {
    const ComparedRooms compared = compare_rooms(1, test::repetitions(25, 2000));
    EXPECT_GT(compared.pairs, 150u);
    const double noticed = test::is_nightly() ? 0.002 : 0.05;
    EXPECT_TRUE(test::has_probability_at_most(compared.beyond, compared.pairs, 2e-4,
                                              {.alpha = 1e-4, .detects = noticed, .power = 0.9}));
    EXPECT_GT(compared.beyond_open, compared.pairs / 20) << "what stands in between is seen";
}

}  // namespace
}  // namespace ff::studies::form_factors
