#include "core/geometry/round_ends.hpp"

#include <algorithm>
#include <cmath>
#include <variant>

namespace ff {

std::vector<RoundEnd> round_ends(const Shape& shape) {
    std::vector<RoundEnd> ends;
    if (const auto* frustum = std::get_if<Frustum>(&shape)) {
        const Eigen::Vector3d along = frustum->axis.normalized();
        ends = {{frustum->base, frustum->base_radius, along},
                {frustum->base + frustum->axis, frustum->top_radius, -along}};
    } else if (const auto* zone = std::get_if<SphereZone>(&shape)) {
        const auto end = [&](double height, const Eigen::Vector3d& inwards) {
            return RoundEnd{zone->centre + height * zone->radius * zone->axis,
                            zone->radius * std::sqrt(std::max(0.0, 1 - height * height)), inwards};
        };
        ends = {end(zone->low, zone->axis), end(zone->high, -zone->axis)};
    }
    std::erase_if(ends, [](const RoundEnd& end) { return end.radius == 0; });
    return ends;
}

}  // namespace ff
