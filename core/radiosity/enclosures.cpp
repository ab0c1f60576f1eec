#include "core/radiosity/enclosures.hpp"

#include "core/exact/exact.hpp"
#include "core/radiosity/patch_factors.hpp"
#include "core/support/contract.hpp"
#include "core/visibility/mirrors.hpp"

#include <cmath>
#include <numbers>
#include <utility>

namespace ff {

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
    const Scene room = with_mirrors(box, {&box.faces.at(static_cast<std::size_t>(mirror)), 1});
    auto factors = exact_form_factors(room);
    if (!room.empty_box || !factors) return std::nullopt;
    return Enclosure{std::move(*factors), face_areas(room)};
}

}  // namespace ff
