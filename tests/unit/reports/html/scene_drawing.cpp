#include "reports/html/scene_drawing.hpp"

#include "core/configurations/built_in_scene.hpp"
#include "core/geometry/scene.hpp"

#include <gtest/gtest.h>

#include <pugixml.hpp>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <sstream>
#include <string>

namespace ff::reports {
namespace {

pugi::xml_document parse_svg(const std::string& svg) {
    pugi::xml_document document;
    EXPECT_TRUE(document.load_string(svg.c_str())) << svg;
    return document;
}

std::size_t count(const pugi::xml_document& document, const char* element) {
    const auto all = document.child("svg").children(element);
    return static_cast<std::size_t>(std::distance(all.begin(), all.end()));
}

TEST(SceneDrawing, HasAnOutlineForEverySurfaceAndALabelForEveryFace) {
    const auto document = parse_svg(scene_drawing(built_in_scene("nested_cubes")));
    EXPECT_EQ(count(document, "polyline"), 12u);
    EXPECT_EQ(count(document, "text"), 12u);
}

TEST(SceneDrawing, HasRingsAndLinesForRoundSurfaces) {
    // A wall: two rims and four lines; two discs: a rim each.
    EXPECT_EQ(count(parse_svg(scene_drawing(built_in_scene("cylinder_wall"))), "polyline"), 8u);
    EXPECT_EQ(count(parse_svg(scene_drawing(built_in_scene("concentric_spheres"))), "polyline"), 14u);
}

TEST(SceneDrawing, DashesSurfacesWithoutAFace) {
    const auto document = parse_svg(scene_drawing(built_in_scene("squares_blocked")));
    std::size_t dashed = 0;
    for (const auto& line : document.child("svg").children("polyline"))
        dashed += line.attribute("stroke-dasharray") ? 1u : 0u;
    EXPECT_EQ(dashed, 1u);
}

TEST(SceneDrawing, StaysInsideItsFrameAndFillsIt) {
    for (const char* name : {"cube", "l_shaped_room", "sphere_caps", "box:1x1x1e-6", "box:1e9x1e9x1e9"}) {
        const auto document = parse_svg(scene_drawing(built_in_scene(name)));
        std::istringstream frame(document.child("svg").attribute("viewBox").value());
        double left = 0, top = 0, width = 0, height = 0;
        frame >> left >> top >> width >> height;
        EXPECT_GT(std::max(width, height), 240) << name;
        for (const auto& line : document.child("svg").children("polyline")) {
            std::istringstream points(line.attribute("points").value());
            double x = 0, y = 0;
            for (char comma = 0; points >> x >> comma >> y;) {
                EXPECT_TRUE(x >= 0 && x <= width && y >= 0 && y <= height) << name << " " << x << " " << y;
            }
        }
    }
}

TEST(SceneDrawing, EscapesLabels) {
    Scene scene = built_in_scene("cube");
    scene.faces[0] = "<a & \"b\">";
    const auto document = parse_svg(scene_drawing(scene));
    EXPECT_STREQ(document.child("svg").child("text").child_value(), "<a & \"b\">");
}

}  // namespace
}  // namespace ff::reports
