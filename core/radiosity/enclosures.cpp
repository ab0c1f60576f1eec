#include "core/radiosity/enclosures.hpp"

#include "core/contract.hpp"
#include "core/exact.hpp"

#include <cmath>
#include <numbers>
#include <vector>

namespace ff {
namespace {

/// What a surface looks like in a mirror.
Surface reflected(const Surface& surface, const Surface& mirror) {
    const Eigen::Vector3d& n = mirror.normal;
    const auto turned = [&](const Eigen::Vector3d& v) { return Eigen::Vector3d(v - 2 * n.dot(v) * n); };
    Surface image = surface;
    parallelogram(image).corner =
        parallelogram(mirror).corner + turned(parallelogram(surface).corner - parallelogram(mirror).corner);
    parallelogram(image).edge_u = turned(parallelogram(surface).edge_u);
    parallelogram(image).edge_v = turned(parallelogram(surface).edge_v);
    image.normal = turned(surface.normal);
    return image;
}

}  // namespace

Enclosure cavity(double area, double opening) {
    FF_EXPECT(opening > 0 && opening <= area);
    Enclosure enclosure{Eigen::MatrixXd(2, 2), Eigen::Vector2d(area, opening)};
    enclosure.factors << 1 - opening / area, opening / area, 1, 0;
    return enclosure;
}

Enclosure closed_cylinder(double radius, double height) {
    FF_EXPECT(radius > 0 && height > 0);
    const double slenderness = height / (2 * radius);
    // 1 + 2 h^2 - 2 h sqrt(1 + h^2) = (sqrt(1 + h^2) - h)^2, without cancellation.
    const double across = 1 / (std::hypot(1.0, slenderness) + slenderness);
    const double ends = across * across;
    const double disk = std::numbers::pi * radius * radius;
    const double wall = 2 * std::numbers::pi * radius * height;
    const double to_end = (1 - ends) * disk / wall;
    Enclosure enclosure{Eigen::MatrixXd(3, 3), Eigen::Vector3d(disk, disk, wall)};
    enclosure.factors << 0, ends, 1 - ends,  //
        ends, 0, 1 - ends,                   //
        to_end, to_end, 1 - 2 * to_end;
    return enclosure;
}

std::optional<Enclosure> box_with_mirror(const Scene& box, int mirror) {
    if (!box.empty_box) return std::nullopt;
    std::vector<Surface> faces = box.surfaces;
    const Surface glass = faces.at(static_cast<std::size_t>(mirror));
    faces.erase(faces.begin() + mirror);
    const auto n = static_cast<Eigen::Index>(faces.size());
    Enclosure enclosure{Eigen::MatrixXd(n, n), Eigen::VectorXd(n)};
    for (Eigen::Index i = 0; i < n; ++i) {
        const Surface& from = faces[static_cast<std::size_t>(i)];
        enclosure.areas[i] = area(from.shape);
        for (Eigen::Index j = 0; j < n; ++j) {
            const Surface& to = faces[static_cast<std::size_t>(j)];
            // A line to an image goes through the mirror: box and image together are convex.
            const auto by_mirror = exact_exchange_area(from, reflected(to, glass));
            const auto straight = i == j ? std::optional(0.0) : exact_exchange_area(from, to);
            if (!by_mirror || !straight) return std::nullopt;
            enclosure.factors(i, j) = (*straight + *by_mirror) / enclosure.areas[i];
        }
    }
    return enclosure;
}

}  // namespace ff
