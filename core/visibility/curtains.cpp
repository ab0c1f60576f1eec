#include "core/visibility/curtains.hpp"

#include <algorithm>

namespace ff {
namespace {

using Eigen::Vector3d;

/// Heights above a plane, and distances inside of an edge, count only where they exceed this share of the whole.
constexpr double clear_share = 1e-9;

/// A place inside of a convex set, beside its middle: lines between middles often meet edges.
Vector3d place_in(std::span<const Vector3d> hull) {
    Vector3d sum = Vector3d::Zero();
    double weights = 0;
    for (std::size_t k = 0; k < hull.size(); ++k) {
        const double weight = 1 / (3.1 + static_cast<double>(k));
        sum += weight * hull[k];
        weights += weight;
    }
    return sum / weights;
}

}  // namespace

Curtains::Curtains(const SharedEdges& edges, const std::vector<std::optional<Plate>>& plates)
    : edges_(edges), plates_(plates), asked_(plates.size(), 0), reached_(plates.size(), 0) {}

std::optional<int> Curtains::crossings(std::uint32_t wall, const Line& line) const {
    const Plate& plate = *plates_[wall];
    const double before = plate.normal.dot(line.begin - plate.corners.front());
    const double after = plate.normal.dot(line.end - plate.corners.front());
    const double room = clear_share * line.length;
    if ((before > room && after > room) || (before < -room && after < -room)) return 0;
    if (std::min(std::abs(before), std::abs(after)) <= room) return std::nullopt;
    const Vector3d place = line.begin + before / (before - after) * (line.end - line.begin);
    bool is_near_edge = false;
    for (const Plate::Edge& edge : plate.edges) {
        const double inside = edge.inward.dot(place - edge.corner);
        if (inside < -clear_share * plate.size) return 0;
        is_near_edge = is_near_edge || inside <= clear_share * plate.size;
    }
    if (is_near_edge) return std::nullopt;
    return before > 0 ? 1 : -1;
}

bool Curtains::is_apart(std::uint32_t wall, const End& end) const {
    const Plate& plate = *plates_[wall];
    const double room = edges_.corner_room();
    double low = 0;
    double high = 0;
    for (const Vector3d& corner : end.hull) {
        const double height = plate.normal.dot(corner - plate.corners.front());
        low = &corner == end.hull.data() ? height : std::min(low, height);
        high = &corner == end.hull.data() ? height : std::max(high, height);
    }
    if (low > room || high < -room) return true;
    const Eigen::AlignedBox3d box = box_around(plate.corners);
    return (box.min().array() > end.box.max().array() + room).any() ||
           (box.max().array() < end.box.min().array() - room).any();
}

bool Curtains::hide_all(std::span<const std::uint32_t> walls, const End& from, const End& to, double grain,
                        const std::function<bool(std::uint32_t)>& is_clear) {
    Line line{place_in(from.hull), place_in(to.hull)};
    const Vector3d apart = line.end - line.begin;
    line.length = apart.norm();
    if (from.normal.dot(apart) < 0 || to.normal.dot(apart) > 0) return false;
    const std::uint32_t question = ++count_;
    for (const std::uint32_t wall : walls) asked_[wall] = question;
    std::optional<Shaft> shaft;
    for (const std::uint32_t seed : walls) {
        if (!plates_[seed] || reached_[seed] > question || crossings(seed, line).value_or(0) == 0) continue;
        if (!shaft) shaft.emplace(from.hull, to.hull, grain);
        members_.assign(1, seed);
        const std::uint32_t curtain = ++count_;
        reached_[seed] = curtain;
        int times = 0;
        bool is_curtain = true;
        for (std::size_t k = 0; k < members_.size() && is_curtain; ++k) {
            const std::uint32_t wall = members_[k];
            const auto own = crossings(wall, line);
            is_curtain = own && is_apart(wall, from) && is_apart(wall, to);
            if (!is_curtain) break;
            times += *own;
            const std::uint32_t open = shaft->open_edges(*plates_[wall]);
            for (std::size_t edge = 0; edge < plates_[wall]->corners.size() && is_curtain; ++edge) {
                if ((open >> edge & 1U) == 0) continue;
                const std::uint32_t next = edges_.beyond(wall, edge);
                is_curtain = next != SharedEdges::none && (asked_[next] == question || is_clear(next));
                if (!is_curtain || asked_[next] != question || reached_[next] == curtain) continue;
                is_curtain = reached_[next] < question;  // what an earlier curtain reached did not form one
                reached_[next] = curtain;
                members_.push_back(next);
            }
        }
        if (is_curtain && times != 0) return true;
    }
    return false;
}

}  // namespace ff
