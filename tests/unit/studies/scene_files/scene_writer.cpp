#include "studies/scene_files/scene_writer.hpp"

#include "core/configurations/built_in_scene.hpp"
#include "core/configurations/catalogue.hpp"
#include "core/geometry/scene.hpp"
#include "studies/scene_files/scene_file.hpp"

#include <gtest/gtest.h>

#include <cstddef>
#include <string>
#include <vector>

namespace ff::studies {
namespace {

/// The built-in scenes, a box and one with an occluder.
std::vector<Scene> scenes() {
    std::vector<Scene> all{built_in_scene("cube"), built_in_scene("box:2x1x0.5")};
    for (const std::string_view name : configuration_scene_names()) all.push_back(*configuration_scene(name));
    return all;
}

/// Areas, sides and names: the surfaces may come in another order within a face.
void expect_same(const Scene& read, const Scene& scene) {
    ASSERT_EQ(read.surfaces.size(), scene.surfaces.size()) << scene.name;
    EXPECT_EQ(read.faces, scene.faces);
    EXPECT_EQ(read.closed, scene.closed) << scene.name;
    for (int face = 0; face < static_cast<int>(scene.faces.size()); ++face) {
        EXPECT_NEAR(face_area(read, face), face_area(scene, face), 1e-12 * face_area(scene, face)) << scene.name;
        Eigen::Vector3d sides = Eigen::Vector3d::Zero();
        for (const Surface& surface : scene.surfaces) {
            if (surface.face == face) sides += surface.normal;
        }
        for (const Surface& surface : read.surfaces) {
            if (surface.face == face) sides -= surface.normal;
        }
        EXPECT_LT(sides.norm(), 1e-12) << scene.name << ", face " << face + 1;
    }
}

TEST(SceneWriter, WritesTomlThatReadsBackAsTheSameScene) {
    for (const Scene& scene : scenes())
        expect_same(make_scene(source_of_file("s.toml", toml_scene_text(scene))), scene);
}

TEST(SceneWriter, WritesPolygonsInBothFormatsOfPolygons) {
    std::size_t written = 0;
    for (const Scene& scene : scenes()) {
        if (!is_of_polygons(scene)) continue;
        ++written;
        expect_same(make_scene(source_of_file("s.obj", obj_text(scene))), scene);
        expect_same(make_scene(source_of_file("s.vs3", vs3_text(scene))), scene);
    }
    EXPECT_GE(written, 5u);
}

// Many programs do not read the relative indices of OBJ files.
TEST(SceneWriter, WritesEmissivitiesThatAreKnown) {
    Scene scene;
    scene.faces = {"floor", "roof"};
    for (const int face : {0, 1}) {
        const double height = face;
        scene.surfaces.push_back({Triangle{{0, 0, height}, {1, 0, height}, {1, 1, height}}, {0, 0, 1}, face});
    }
    const std::string text = vs3_text(scene, {0.9, std::nullopt});
    EXPECT_NE(text.find(" 0.9 floor\n"), std::string::npos) << text;
    EXPECT_NE(text.find(" 0.5 roof\n"), std::string::npos) << text;
}

TEST(SceneWriter, CountsTheCornersOfPolygonsFromOne) {
    const std::string text = obj_text(built_in_scene("cube"));
    EXPECT_EQ(text.find("f -"), std::string::npos);
    EXPECT_NE(text.find("f 1 2 3 4\n"), std::string::npos);
    EXPECT_NE(text.find("f 21 22 23 24\n"), std::string::npos);
}

TEST(SceneWriter, KeepsFacesOfSeveralSurfacesAndGrids) {
    const Scene scene =
        make_scene(source_of_file("s.toml",
                                  "[[surface]]\nshape = \"triangle\"\na = [0, 0, 0]\nb = [1, 0, 0]\nc = [0, 1, 0]\n"
                                  "face = \"floor\"\nflip = true\n[[surface]]\nshape = \"parallelogram\"\n"
                                  "corner = [0, 0, 1]\nedge_u = [1, 0, 0]\nedge_v = [0, 0.1, 0]\nface = \"top\"\n"
                                  "grid = [3, 2]\n[[surface]]\nshape = \"triangle\"\na = [1, 0, 0]\nb = [1, 1, 0]\n"
                                  "c = [0, 1, 0]\nface = \"floor\"\nflip = true\n"));
    expect_same(make_scene(source_of_file("s.obj", obj_text(scene))), scene);
    expect_same(make_scene(source_of_file("s.vs3", vs3_text(scene))), scene);
    const Scene read = make_scene(source_of_file("s.toml", toml_scene_text(scene)));
    expect_same(read, scene);
    EXPECT_EQ(read.surfaces.back().grid, scene.surfaces[1].grid);
}

TEST(SceneWriter, RefusesNamesThatPolygonFormatsCannotHold) {
    Scene scene = built_in_scene("cube");
    EXPECT_TRUE(is_of_polygons(scene));
    scene.faces[2] = "west wall";
    EXPECT_FALSE(is_of_polygons(scene));
    scene.faces[2] = "occluder";
    EXPECT_FALSE(is_of_polygons(scene));
}

}  // namespace
}  // namespace ff::studies
