#include "core/visibility/occluders.hpp"

#include "core/geometry/surface_map.hpp"
#include "core/visibility/facing.hpp"
#include "core/visibility/occlusion.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <random>

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

/// Walls of tiles and single plates of any size, some of them along the axes, anywhere in a unit cube.
Scene random_scene(std::mt19937& engine) {
    std::uniform_real_distribution<double> coordinate(0, 1);
    const auto place = [&] { return Vector3d(coordinate(engine), coordinate(engine), coordinate(engine)); };
    const auto edge = [&] {
        if (coordinate(engine) < 0.5) return Vector3d(place() - Vector3d(0.5, 0.5, 0.5));
        Vector3d along = Vector3d::Zero();
        along[static_cast<Eigen::Index>(3 * coordinate(engine))] = coordinate(engine) - 0.5;
        return along;
    };
    Scene scene;
    while (scene.surfaces.size() < 24) {
        const Vector3d u = edge();
        const Vector3d v = edge() * (coordinate(engine) < 0.3 ? 0.05 : 1);
        if (u.cross(v).norm() < 1e-4) continue;
        add_tiles(scene, place(), u, v, coordinate(engine) < 0.3 ? 2 : 1);
    }
    return scene;
}

/// What lines between two surfaces show.
struct Seen {
    std::size_t lines = 0;
    std::size_t hidden = 0;
    std::size_t differences = 0;     ///< hidden by the scene and not by the occluders, or the other way round
    std::size_t seen_of_hidden = 0;  ///< lines with nothing in between where all were said to be hidden
};

/// @param dropped  leave the last occluder out
Seen look(const Scene& scene, std::mt19937& engine, bool dropped) {
    const Occluders occluders(scene);
    std::uniform_real_distribution<double> coordinate(0, 1);
    Seen seen;
    for (std::size_t a = 0; a < scene.surfaces.size(); ++a) {
        for (std::size_t b = 0; b < scene.surfaces.size(); ++b) {
            const Surface& from = scene.surfaces[a];
            const Surface& to = scene.surfaces[b];
            if (a == b || !face_each_other(from, to)) continue;
            Occluders::Between between = occluders.between(a, b);
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
                    seen.differences += clear != sees(p.position, from, q.position, to, between.occluders) ? 1u : 0u;
            }
        }
    }
    return seen;
}

Seen look_at_scenes(bool dropped) {
    std::mt19937 engine(20);
    Seen all;
    for (int i = 0; i < 300; ++i) {
        const Seen seen = look(random_scene(engine), engine, dropped);
        all.lines += seen.lines;
        all.hidden += seen.hidden;
        all.differences += seen.differences;
        all.seen_of_hidden += seen.seen_of_hidden;
    }
    return all;
}

// Among some hundred thousand lines in 300 scenes none is hidden by what has been left out.
TEST(Occluders, HideWhatAllSurfacesHide) {
    const Seen seen = look_at_scenes(false);
    EXPECT_GT(seen.lines, 200'000u);
    EXPECT_GT(seen.hidden, 50'000u);
    EXPECT_EQ(seen.differences, 0u);
    EXPECT_EQ(seen.seen_of_hidden, 0u);
}

TEST(Occluders, AreMissedWhereOneIsLeftOut) {
    EXPECT_GT(look_at_scenes(true).differences, 1000u);
}

TEST(Occluders, AreSeldomMoreThanTheCautiousTestFinds) {
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

TEST(Occluders, AreWallsWhateverFacesTheirTilesAre) {
    Scene scene;
    add_tiles(scene, {0, 0, 0}, {1, 0, 0}, {0, 1, 0}, 1);
    add_tiles(scene, {0, 0, 2}, {0, 1, 0}, {1, 0, 0}, 1);
    add_tiles(scene, {-1, -1, 1}, {3, 0, 0}, {0, 3, 0}, 8);
    const Occluders occluders(scene);
    EXPECT_EQ(occluders.surfaces().size(), 3u);
    EXPECT_TRUE(occluders.between(0, 1).all_hidden) << "by 64 tiles, none of which does alone";
    const std::size_t tile = 2 + 8 * 4 + 4;
    EXPECT_TRUE(occluders.between(1, tile).occluders.empty()) << "a tile does not stand before its own wall";
}

}  // namespace
}  // namespace ff
