#include "core/visibility/occluders.hpp"

#include "core/geometry/surface_map.hpp"
#include "core/visibility/facing.hpp"
#include "core/visibility/occlusion.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <numbers>
#include <random>
#include <utility>

namespace ff {
namespace {

using Eigen::Vector3d;

Surface parallelogram_of(const Vector3d& corner, const Vector3d& u, const Vector3d& v, int face) {
    return {Parallelogram{corner, u, v}, u.cross(v).normalized(), face};
}

/// Tiles of one wall, each a face of its own.
void add_tiles(Scene& scene, const Vector3d& corner, const Vector3d& u, const Vector3d& v, int n) {
    for (int i = 0; i < n; ++i) {
        for (int j = 0; j < n; ++j) {
            scene.surfaces.push_back(parallelogram_of(corner + i * u / n + j * v / n, u / n, v / n,
                                                      static_cast<int>(scene.surfaces.size())));
        }
    }
}

/// A box with its radiating sides outside, or inside; up to two of its sides are missing, some are tiled.
void add_box(Scene& scene, std::mt19937& engine, const Vector3d& corner, const std::array<Vector3d, 3>& edges) {
    std::uniform_int_distribution<int> side(0, 11);
    const std::array<int, 2> missing = {side(engine), side(engine)};
    const bool outward = side(engine) > 2;
    for (int k = 0; k < 6; ++k) {
        if (k == missing[0] || (k == missing[1] && side(engine) < 3)) continue;
        const auto axis = static_cast<std::size_t>(k / 2);
        Vector3d u = edges[(axis + 1) % 3];
        Vector3d v = edges[(axis + 2) % 3];
        const bool far = k % 2 == 1;
        if ((u.cross(v).dot(edges[axis]) > 0) != (far == outward)) std::swap(u, v);
        add_tiles(scene, far ? Vector3d(corner + edges[axis]) : corner, u, v, side(engine) < 2 ? 2 : 1);
    }
}

/// A closed mesh of triangles around a centre, with dents and peaks; it radiates outwards, or inwards as a cave does.
void add_mesh(Scene& scene, std::mt19937& engine, const Vector3d& centre, double size) {
    std::uniform_real_distribution<double> radius(0.2, 1);
    const bool outward = radius(engine) < 0.8;
    constexpr int meridians = 5;
    const auto turn = Eigen::AngleAxisd(10 * radius(engine), Vector3d(radius(engine), 0.3, -0.4).normalized());
    std::vector<Vector3d> rows;  // two rings between the poles
    for (const double height : {0.5, -0.5}) {
        for (int k = 0; k < meridians; ++k) {
            const double angle = 2 * std::numbers::pi * k / meridians;
            rows.emplace_back(radius(engine) * Vector3d(std::cos(angle), std::sin(angle), height));
        }
    }
    const Vector3d top(0, 0, radius(engine));
    const Vector3d bottom(0, 0, -radius(engine));
    const auto add = [&](const Vector3d& a, const Vector3d& b, const Vector3d& c) {
        Triangle triangle{centre + size * (turn * a), centre + size * (turn * b), centre + size * (turn * c)};
        if (!outward) std::swap(triangle.b, triangle.c);
        const Vector3d normal = (triangle.b - triangle.a).cross(triangle.c - triangle.a).normalized();
        scene.surfaces.push_back({triangle, normal, static_cast<int>(scene.surfaces.size())});
    };
    for (std::size_t k = 0; k < meridians; ++k) {
        const std::size_t next = (k + 1) % meridians;
        add(top, rows[k], rows[next]);
        add(rows[k], rows[meridians + k], rows[meridians + next]);
        add(rows[k], rows[meridians + next], rows[next]);
        add(bottom, rows[meridians + next], rows[meridians + k]);
    }
}

/// Walls of tiles, boxes, meshes and single plates of any size, some of them along the axes, anywhere in a unit cube.
Scene random_scene(std::mt19937& engine, std::size_t surfaces = 24) {
    std::uniform_real_distribution<double> coordinate(0, 1);
    const auto place = [&] { return Vector3d(coordinate(engine), coordinate(engine), coordinate(engine)); };
    const auto edge = [&] {
        if (coordinate(engine) < 0.5) return Vector3d(place() - Vector3d(0.5, 0.5, 0.5));
        Vector3d along = Vector3d::Zero();
        along[static_cast<Eigen::Index>(3 * coordinate(engine))] = coordinate(engine) - 0.5;
        return along;
    };
    Scene scene;
    while (scene.surfaces.size() < surfaces) {
        if (coordinate(engine) < 0.05) {
            add_mesh(scene, engine, place(), coordinate(engine) < 0.5 ? 0.2 : 0.7);
            continue;
        }
        if (coordinate(engine) < 0.25) {
            const double size = coordinate(engine) < 0.5 ? 0.3 : 0.8;
            const std::array<Vector3d, 3> edges = {edge(), edge(), size * edge()};
            const double thinnest = std::min({edges[0].norm(), edges[1].norm(), edges[2].norm()});
            if (std::abs(edges[0].cross(edges[1]).dot(edges[2])) > 0.05 * thinnest * thinnest * thinnest)
                add_box(scene, engine, place() - (edges[0] + edges[1] + edges[2]) / 2, edges);
            continue;
        }
        const Vector3d u = edge();
        const Vector3d v = edge() * (coordinate(engine) < 0.3 ? 0.05 : 1);
        if (u.cross(v).norm() < 1e-4) continue;
        add_tiles(scene, place(), u, v, coordinate(engine) < 0.3 ? 2 : 1);
    }
    return scene;
}

/// The result of lines between two surfaces.
struct Seen {
    std::size_t lines = 0;
    std::size_t hidden = 0;
    std::size_t differences = 0;     ///< hidden by the scene and not by the occluders, or the other way round
    std::size_t seen_of_hidden = 0;  ///< lines with nothing in between where all were said to be hidden
};

/// The pairs that visits find, the smaller index first; pairs that are wholly hidden from each other are missing.
std::map<std::pair<std::uint32_t, std::uint32_t>, Occluders::Between> visited(const Occluders& occluders) {
    std::map<std::pair<std::uint32_t, std::uint32_t>, Occluders::Between> found;
    for (const Occluders::Visit& visit : occluders.visits(64)) {
        occluders.see(visit, [&](std::uint32_t a, std::uint32_t b, const Occluders::Between& between) {
            EXPECT_LT(a, b);
            EXPECT_TRUE(found.emplace(std::pair(a, b), between).second) << a << " and " << b << " were met twice";
        });
    }
    return found;
}

/// Whether no occluder that has to be tested stands between two places.
bool sees_past(const Vector3d& p, const Surface& from, const Vector3d& q, const Surface& to,
               const std::vector<Blocker>& blockers) {
    std::vector<const Surface*> facing;
    for (const auto& [surface, faces] : blockers) {
        const Vector3d& seen_from = faces == FacedEnd::to ? q : p;
        const bool faces_it =
            faces == FacedEnd::either || surface->normal.dot(seen_from - corners(surface->shape).front()) > 0;
        if (faces_it) facing.push_back(surface);
    }
    return sees(p, from, q, to, facing);
}

/// @param dropped  leave the last occluder out
Seen look(const Scene& scene, std::mt19937& engine, bool dropped) {
    const Occluders occluders(scene);
    const auto found = visited(occluders);
    std::uniform_real_distribution<double> coordinate(0, 1);
    Seen seen;
    for (std::size_t a = 0; a < scene.surfaces.size(); ++a) {
        for (std::size_t b = 0; b < scene.surfaces.size(); ++b) {
            const Surface& from = scene.surfaces[a];
            const Surface& to = scene.surfaces[b];
            if (a == b || !face_each_other(from, to)) continue;
            const auto pair =
                found.find({static_cast<std::uint32_t>(std::min(a, b)), static_cast<std::uint32_t>(std::max(a, b))});
            Occluders::Between between;
            between.all_hidden = pair == found.end();
            // Both ways of asking have to hold.
            if (a < b && pair != found.end()) between = pair->second;
            if (a > b) between = occluders.between(a, b);
            if (dropped && !between.occluders.empty()) between.occluders.pop_back();
            std::vector<const Surface*> all;
            for (const Surface& surface : scene.surfaces) {
                if (&surface != &from && &surface != &to) all.push_back(&surface);
            }
            for (int k = 0; k < 10; ++k) {
                const SurfacePoint p = SurfaceMap(from).at(coordinate(engine), coordinate(engine));
                const SurfacePoint q = SurfaceMap(to).at(coordinate(engine), coordinate(engine));
                const Vector3d apart = q.position - p.position;
                if (apart.dot(p.normal) < 1e-6 || apart.dot(q.normal) > -1e-6) continue;
                ++seen.lines;
                const bool clear = sees(p.position, from, q.position, to, all);
                seen.hidden += clear ? 0u : 1u;
                if (between.all_hidden)
                    seen.seen_of_hidden += clear ? 1u : 0u;
                else
                    seen.differences +=
                        clear != sees_past(p.position, from, q.position, to, between.occluders) ? 1u : 0u;
            }
        }
    }
    return seen;
}

Seen look_at_scenes(bool dropped) {
    std::mt19937 engine(20);
    Seen all;
    for (int i = 0; i < 300; ++i) {
        const Seen seen = look(random_scene(engine, i % 50 == 0 ? 120 : 24), engine, dropped);
        all.lines += seen.lines;
        all.hidden += seen.hidden;
        all.differences += seen.differences;
        all.seen_of_hidden += seen.seen_of_hidden;
    }
    return all;
}

// Among some hundred thousand lines in 300 scenes, none is hidden only by a surface that was left out.
TEST(Occluders, HideAllThatTheSurfacesHide) {
    const Seen seen = look_at_scenes(false);
    EXPECT_GT(seen.lines, 200'000u);
    EXPECT_GT(seen.hidden, 50'000u);
    EXPECT_EQ(seen.differences, 0u);
    EXPECT_EQ(seen.seen_of_hidden, 0u);
}

// A lamp flush under the lid of a closed box lights the bottom of the box, not the floor below it.
TEST(Occluders, HideSurfacesInThePlaneOfASideOfABody) {
    Scene scene;
    add_tiles(scene, {0, 0, 0}, {1, 0, 0}, {0, 1, 0}, 1);
    add_tiles(scene, {.4, .4, .7}, {0, .2, 0}, {.2, 0, 0}, 1);
    const Vector3d low(.2, .2, .3);
    const Vector3d high(.8, .8, .7);
    const Vector3d x(.6, 0, 0);
    const Vector3d y(0, .6, 0);
    const Vector3d z(0, 0, .4);
    for (const auto& [u, v] : {std::pair(y, x), std::pair(z, y), std::pair(x, z)}) add_tiles(scene, low, u, v, 1);
    for (const auto& [u, v] : {std::pair(x, y), std::pair(y, z), std::pair(z, x)}) add_tiles(scene, high, -u, -v, 1);
    const Occluders occluders(scene);
    EXPECT_TRUE(occluders.between(0, 1).all_hidden || occluders.between(0, 1).occluders.size() >= 5);
}

// A cave with a body in it: only what the body turns to a wall hides anything from it.
TEST(Occluders, FaceOneEndInAMesh) {
    std::mt19937 engine(3);
    Scene scene;
    add_tiles(scene, {-2, -2, -3}, {4, 0, 0}, {0, 4, 0}, 1);
    add_tiles(scene, {-2, -2, 3}, {0, 4, 0}, {4, 0, 0}, 1);
    add_mesh(scene, engine, {0, 0, 0}, 1);
    const Occluders occluders(scene);
    const auto between = occluders.between(0, 1).occluders;
    EXPECT_GT(between.size(), 3u);
    EXPECT_LT(between.size(), 20u) << "some are seen from behind by all of the floor";
    for (const Blocker& blocker : between) EXPECT_EQ(blocker.faces, FacedEnd::from);
}

TEST(Occluders, CheckNoticesAMissingOccluder) {
    EXPECT_GT(look_at_scenes(true).differences, 1000u);
}

TEST(Occluders, RarelyExceedOccludersOfTheCautiousTest) {
    std::mt19937 engine(21);
    std::size_t fewer = 0;
    std::size_t more = 0;  // a wall that reaches into the lines where none of its tiles does
    for (int i = 0; i < 100; ++i) {
        const Scene scene = random_scene(engine);
        const Occluders occluders(scene);
        for (std::size_t a = 0; a < scene.surfaces.size(); ++a) {
            for (std::size_t b = 0; b < a; ++b) {
                const std::size_t cautious = possible_blockers(scene, scene.surfaces[a], scene.surfaces[b]).size();
                const std::size_t found = occluders.between(a, b).occluders.size();
                fewer += found < cautious ? 1u : 0u;
                more += found > cautious ? 1u : 0u;
            }
        }
    }
    EXPECT_GT(fewer, 1000u);
    EXPECT_LT(100 * more, fewer);
}

TEST(Occluders, AreWholeWallsWhateverFacesTheirTilesBelongTo) {
    Scene scene;
    add_tiles(scene, {0, 0, 0}, {1, 0, 0}, {0, 1, 0}, 1);
    add_tiles(scene, {0, 0, 2}, {0, 1, 0}, {1, 0, 0}, 1);
    add_tiles(scene, {-1, -1, 1}, {3, 0, 0}, {0, 3, 0}, 8);
    const Occluders occluders(scene);
    EXPECT_EQ(occluders.walls().size(), 3u);
    EXPECT_TRUE(occluders.between(0, 1).all_hidden) << "by 64 tiles, none of which does alone";
    const std::size_t tile = 2 + 8 * 4 + 4;
    EXPECT_TRUE(occluders.between(1, tile).occluders.empty()) << "a tile does not stand before its own wall";
}

/// The unit square from `corner` on, divided into tiles that are smaller the nearer they are to it. The last is the
/// smallest, and lies at the corner.
void add_tiles_towards_corner(Scene& scene, const Vector3d& corner, const Vector3d& u, const Vector3d& v,
                              int halvings) {
    double size = 1;
    const auto add = [&](const Vector3d& at, double along_u, double along_v) {
        const auto face = static_cast<int>(scene.surfaces.size());
        scene.surfaces.push_back(parallelogram_of(at, along_u * u, along_v * v, face));
    };
    for (int k = 0; k < halvings; ++k) {
        size /= 2;
        add(corner + size * v, 2 * size, size);
        add(corner + size * u, size, size);
    }
    add(corner, size, size);
}

TEST(Occluders, AreFoundBesideTheSmallestTileOfAWall) {
    Scene scene;
    constexpr int halvings = 30;
    add_tiles_towards_corner(scene, {0, 0, 0}, {1, 0, 0}, {0, 1, 0}, halvings);
    const std::size_t floor_tile = scene.surfaces.size() - 1;
    add_tiles_towards_corner(scene, {0, 0, 0}, {0, 1, 0}, {0, 0, 1}, halvings);
    const std::size_t wall_tile = scene.surfaces.size() - 1;
    const double size = std::ldexp(1.0, -halvings);
    const double height = 3e-3 * size;  // 3e-12 of the walls, which is not level with them
    scene.surfaces.push_back(parallelogram_of({0, 0, height}, {size, 0, 0}, {0, size, 0}, no_face));
    const Occluders occluders(scene);
    ASSERT_EQ(occluders.walls().size(), 3u) << "each wall is one occluder";
    EXPECT_EQ(occluders.between(floor_tile, wall_tile).occluders.size(), 1u);
}

// A sheet so little above a floor that it lies in its plane but for rounding hides nothing of it, be it looked at for
// single tiles or for all of them at once; a little higher it hides everything.
TEST(Occluders, HideNothingInThePlaneOfAnEnd) {
    for (const double gap : {2e-14, 3e-13, 1e-9}) {
        Scene scene;
        add_tiles(scene, {0, 0, 0}, {1, 0, 0}, {0, 1, 0}, 4);
        add_tiles(scene, {0, 0, 1}, {0, 1, 0}, {1, 0, 0}, 4);
        scene.surfaces.push_back(parallelogram_of({-1, -1, gap}, {3, 0, 0}, {0, 3, 0}, no_face));
        const Occluders occluders(scene);
        const auto found = visited(occluders);
        for (std::uint32_t floor = 0; floor < 16; ++floor) {
            for (std::uint32_t ceiling = 16; ceiling < 32; ++ceiling) {
                const auto pair = found.find({floor, ceiling});
                EXPECT_EQ(pair == found.end(), gap > 1e-12) << gap;
                EXPECT_TRUE(pair == found.end() || pair->second.occluders.empty());
                EXPECT_EQ(occluders.between(floor, ceiling).all_hidden, gap > 1e-12);
            }
        }
    }
}

// A side of a body that lies on a wall may lie in front of it by rounding, and still exchanges nothing with it.
TEST(Occluders, DoNotFaceEachOtherInOnePlane) {
    for (const double gap : {-1e-15, 1e-15, 5e-13, 1e-9}) {
        Scene scene;
        scene.surfaces.push_back(parallelogram_of({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, 0));
        scene.surfaces.push_back(parallelogram_of({0.2, 0.3, gap}, {0, 1e-5, 0}, {1e-5, 0, 0}, 1));
        EXPECT_EQ(Occluders(scene).face_each_other(0, 1), gap > 1e-12) << gap;
    }
}

}  // namespace
}  // namespace ff
