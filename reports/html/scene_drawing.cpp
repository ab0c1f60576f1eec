#include "reports/html/scene_drawing.hpp"

#include "core/geometry/surface_map.hpp"
#include "core/support/overloaded.hpp"
#include "core/visibility/mirrors.hpp"
#include "reports/templates/mustache.hpp"

#include <fmt/format.h>
#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <variant>
#include <vector>

namespace ff::reports {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;
using Line = std::vector<Vector2d>;

constexpr std::size_t most_surfaces = 2000;
constexpr int ring_segments = 36;
constexpr int spokes = 4;  // lines between rings
constexpr double drawing_width = 240;
constexpr double drawing_margin = 12;

/// Directions to the right and up in the drawing, for a view from azimuth 35 and elevation 25 degrees: no edge of a
/// cube hides another one.
const double azimuth = 35 * std::numbers::pi / 180;
const double elevation = 25 * std::numbers::pi / 180;
const Vector3d right(-std::sin(azimuth), std::cos(azimuth), 0);
const Vector3d up(-std::sin(elevation) * std::cos(azimuth), -std::sin(elevation) * std::sin(azimuth),
                  std::cos(elevation));

/// y downwards as in SVG.
Vector2d project(const Vector3d& place) {
    return {right.dot(place), -up.dot(place)};
}

Line outline(const std::vector<Vector3d>& corners) {
    Line line;
    for (const Vector3d& corner : corners) line.push_back(project(corner));
    line.push_back(line.front());
    return line;
}

/// Around a round surface at s.
Line ring(const SurfaceMap& map, double s) {
    Line line;
    for (int i = 0; i <= ring_segments; ++i)
        line.push_back(project(map.at(s, i % ring_segments / double{ring_segments}).position));
    return line;
}

/// A line from one rim of a round surface to the other.
Line spoke(const SurfaceMap& map, double t, int steps) {
    Line line;
    for (int i = 0; i <= steps; ++i) line.push_back(project(map.at(i / static_cast<double>(steps), t).position));
    return line;
}

std::vector<Line> lines_of(const Surface& surface) {
    const SurfaceMap map(surface);
    std::vector<Line> lines;
    const auto round = [&](const std::vector<double>& rings, int steps) {
        for (const double s : rings) lines.push_back(ring(map, s));
        for (int i = 0; steps > 0 && i < spokes; ++i) lines.push_back(spoke(map, i / double{spokes}, steps));
    };
    std::visit(Overloaded{[&](const Parallelogram&) { lines.push_back(outline(corners(surface.shape))); },
                          [&](const Triangle&) { lines.push_back(outline(corners(surface.shape))); },
                          [&](const Disc& disc) {
                              round(disc.inner_radius > 0 ? std::vector{0.0, 1.0} : std::vector{1.0}, 0);
                          },
                          [&](const Frustum&) {
                              round({0.0, 1.0}, 1);
                          },
                          [&](const SphereZone&) {
                              round({0.0, 0.5, 1.0}, ring_segments / 2);
                          }},
               surface.shape);
    return lines;
}

/// The lines that are drawn for one surface.
struct Drawn {
    const Surface* surface = nullptr;
    std::vector<Line> lines;
};

/// The box around all lines.
struct DrawingFrame {
    Vector2d low = Vector2d::Constant(std::numeric_limits<double>::infinity());
    Vector2d high = -low;

    void add(const Vector2d& point) {
        low = low.cwiseMin(point);
        high = high.cwiseMax(point);
    }
    /// Units of the drawing in one of the scene: the larger side is `drawing_width`.
    [[nodiscard]] double scale() const {
        const double size = (high - low).maxCoeff();
        return size > 0 ? drawing_width / size : 1;
    }
    [[nodiscard]] Vector2d at(const Vector2d& point) const {
        return (point - low) * scale() + Vector2d::Constant(drawing_margin);
    }
};

/// The largest surface of each face, which bears its label.
std::vector<const Surface*> largest_surfaces(const Scene& scene) {
    std::vector<const Surface*> largest(scene.faces.size());
    for (const Surface& surface : scene.surfaces) {
        if (!is_of_face(surface)) continue;
        const Surface*& own = largest[static_cast<std::size_t>(surface.face)];
        if (own == nullptr || area(surface.shape) > area(own->shape)) own = &surface;
    }
    return largest;
}

}  // namespace

std::string scene_drawing(const Scene& scene) {
    std::vector<Drawn> drawn;
    DrawingFrame frame;
    const std::size_t step = (scene.surfaces.size() + most_surfaces - 1) / most_surfaces;
    for (std::size_t i = 0; i < scene.surfaces.size(); i += step) {
        drawn.push_back({&scene.surfaces[i], lines_of(scene.surfaces[i])});
        for (const Line& line : drawn.back().lines) {
            for (const Vector2d& point : line) frame.add(point);
        }
    }
    const Vector2d size = frame.at(frame.high) + Vector2d::Constant(drawing_margin);
    std::string out = fmt::format(
        "<svg class=\"scene\" role=\"img\" aria-label=\"line drawing of {}\" viewBox=\"0 0 {:.1f} {:.1f}\" "
        "width=\"{:.0f}\" height=\"{:.0f}\" fill=\"none\" stroke=\"currentColor\">",
        escape_html(scene.name), size.x(), size.y(), size.x(), size.y());
    for (const Drawn& each : drawn) {
        for (const Line& line : each.lines) {
            out +=
                !is_of_face(*each.surface) ? R"(<polyline stroke-dasharray="3 2" points=")" : R"(<polyline points=")";
            for (std::size_t i = 0; i < line.size(); ++i) {
                const Vector2d at = frame.at(line[i]);
                out += fmt::format("{}{:.1f},{:.1f}", i == 0 ? "" : " ", at.x(), at.y());
            }
            out += "\"/>";
        }
    }
    const auto largest = largest_surfaces(scene);
    for (std::size_t face = 0; face < std::min(largest.size(), most_surfaces); ++face) {
        const Vector2d at = frame.at(project(middle(*largest[face])));
        out += fmt::format(
            "<text x=\"{:.1f}\" y=\"{:.1f}\" fill=\"currentColor\" stroke=\"none\" font-size=\"10\" "
            "text-anchor=\"middle\">{}</text>",
            at.x(), at.y(), escape_html(scene.faces[face]));
    }
    return out + "</svg>";
}

}  // namespace ff::reports
