#include "core/geometry/box_tree.hpp"
#include "core/geometry/line_meets.hpp"
#include "core/geometry/placement.hpp"
#include "core/geometry/surface_map.hpp"
#include "core/support/contract.hpp"
#include "core/tracing/rays.hpp"
#include "core/tracing/tracer.hpp"
#include "core/visibility/level_overlaps.hpp"
#include "core/visibility/mirrors.hpp"
#include "core/visibility/touching.hpp"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace ff {
namespace {

using Eigen::Vector3d;

/// Boxes around surfaces, enlarged by the width that rims are given in a second attempt, and by rounding.
std::vector<Eigen::AlignedBox3d> boxes_of(const std::vector<Surface>& surfaces) {
    std::vector<Eigen::AlignedBox3d> boxes;
    boxes.reserve(surfaces.size());
    for (const Surface& surface : surfaces) {
        Eigen::AlignedBox3d box = box_around(surface);
        const double largest = std::max(box.min().cwiseAbs().maxCoeff(), box.max().cwiseAbs().maxCoeff());
        const Vector3d room = Vector3d::Constant(8 * second_attempt * largest);
        boxes.emplace_back(box.min() - room, box.max() + room);
    }
    return boxes;
}

struct Found {
    std::uint32_t surface = no_surface;
    Meeting meeting;
    bool from_behind = false;
};

class DoubleTracer final : public Tracer {
  public:
    explicit DoubleTracer(const Scene& scene)
        : surfaces_(scene.surfaces),
          tree_(boxes_of(scene.surfaces)),
          closed_(scene.closed),
          faces_(scene.faces.size()),
          gap_(level_gap(scene)) {}

    [[nodiscard]] std::string_view name() const override { return "double"; }

    void shoot(std::uint32_t source, Grid grid, std::uint32_t patch, const PointBlock& block,
               std::span<std::uint64_t> hits) const override {
        FF_EXPECT(hits.size() == faces_ + 1);
        std::vector<Line> lines;
        generate_lines(surfaces_.at(source), grid, patch, block, lines);
        for (const Line& line : lines) {
            const Found found = find(line, source);
            if (found.surface == no_surface) {
                ++hits[faces_];
            } else if (is_received(found)) {
                ++hits[static_cast<std::size_t>(surfaces_[found.surface].face)];
            }
        }
    }

    void find_ends(const Surface& /*surface*/, std::uint32_t source, Grid grid, std::uint32_t patch,
                   const PointBlock& block, std::span<Hit> hits) const override {
        std::vector<Line> lines;
        generate_lines(surfaces_.at(source), grid, patch, block, lines);
        for (std::size_t i = 0; i < lines.size(); ++i) hits[i] = hit_of(lines[i], find(lines[i], source));
    }

    void trace(const RayBatch& rays, std::span<Hit> hits) const override {
        const RayPointers pointers = pointers_to(rays);
        const Surface& source = surfaces_[rays.source];
        for (std::size_t i = 0; i < rays.size(); ++i) {
            Line line = line_of(pointers, i);
            // A rounded origin lies a little beside its surface.
            if (is_flat(source.shape))
                line.origin += source.normal.dot(middle(source) - line.origin) * source.normal;
            else
                line.origin = on_curve(source, line.origin);
            hits[i] = hit_of(line, find(line, rays.source));
        }
    }

  private:
    static Vector3d on_curve(const Surface& surface, const Vector3d& place) {
        const SurfaceMap map(surface);
        const auto [s, t] = map.coordinates(place);
        return map.at(s, t).position;
    }

    [[nodiscard]] Found find(const Line& line, std::uint32_t source) const {
        const Found found = first_met(line, source, 0);
        if (found.surface != no_surface || !closed_) return found;
        const Vector3d nearer = second_attempt * (middle(surfaces_[source]) - line.origin);
        return first_met({line.origin + nearer, line.direction}, source, second_attempt);
    }

    /// Surfaces level with the source are not met.
    [[nodiscard]] Found first_met(const Line& line, std::uint32_t source, double rim) const {
        const Surface& from = surfaces_[source];
        Found first;
        tree_.along(line, [&](std::uint32_t index, double latest) {
            const Surface& surface = surfaces_[index];
            const bool begins = index == source && begins_on(surface, rim);
            const auto meeting = line_meets(line, surface, {.begins = begins}, rim);
            if (!meeting || (index != source && are_level(surface, from, meeting->time, line.direction))) return latest;
            const Found found{index, *meeting, meets_back(surface, meeting->outward, line.direction)};
            if (!comes_before(found, first, line.direction)) return latest;
            first = found;
            return meeting->time;
        });
        return first;
    }

    /// Whether two flat surfaces lie in one plane, given that a line takes this long from one to the other.
    [[nodiscard]] bool are_level(const Surface& a, const Surface& b, double time, const Vector3d& direction) const {
        return is_flat(a.shape) && is_flat(b.shape) && time * std::abs(b.normal.dot(direction)) <= gap_ &&
               are_parallel(a, b);
    }

    /// Whether a ray meets `a` before `b`. Of two surfaces in one plane, one that receives the ray comes before one
    /// that does not; otherwise the one that is listed first in the scene comes first.
    [[nodiscard]] bool comes_before(const Found& a, const Found& b, const Vector3d& direction) const {
        if (b.surface == no_surface) return true;
        const double later = a.meeting.time - b.meeting.time;
        if (!are_level(surfaces_[a.surface], surfaces_[b.surface], std::abs(later), direction)) return later < 0;
        return std::pair(!is_received(a), a.surface) < std::pair(!is_received(b), b.surface);
    }

    [[nodiscard]] bool is_received(const Found& found) const {
        return is_of_face(surfaces_[found.surface]) && !found.from_behind;
    }

    [[nodiscard]] Hit hit_of(const Line& line, const Found& found) const {
        if (found.surface == no_surface) return {};
        const auto [s, t] = SurfaceMap(surfaces_[found.surface]).coordinates(line.at(found.meeting.time));
        return {found.surface, static_cast<float>(s), static_cast<float>(t), is_received(found)};
    }

    std::vector<Surface> surfaces_;
    BoxTree tree_;
    bool closed_ = false;
    std::size_t faces_ = 0;
    double gap_ = 0;  ///< distances that may be due to rounding
};

/// Shares of the largest coordinate.
constexpr double narrow = 0x1p-9;
constexpr double near_flat = 0x1p-18;
constexpr double near_curved = 0x1p-7;
/// Sines of angles that are small.
constexpr double small_angle = 0x1p-4;
constexpr double small_angle_of_curves = 0x1p-3;
/// Surfaces cover each other if their common area exceeds this share of the smaller one's area. Adjacent surfaces seem
/// to cover less than that of each other, through rounding.
constexpr double least_share = 1e-6;
constexpr int lattice = 32;

bool has_narrow_face(const Scene& scene, const std::vector<Eigen::AlignedBox3d>& boxes, double largest) {
    std::vector<double> areas(scene.faces.size(), 0);
    std::vector<Eigen::AlignedBox3d> around(scene.faces.size());
    for (std::size_t i = 0; i < boxes.size(); ++i) {
        if (scene.surfaces[i].face < 0) continue;
        const auto face = static_cast<std::size_t>(scene.surfaces[i].face);
        areas[face] += area(scene.surfaces[i].shape);
        around[face].extend(boxes[i]);
    }
    for (std::size_t face = 0; face < areas.size(); ++face) {
        if (areas[face] > 0 && areas[face] < narrow * largest * around[face].diagonal().norm()) return true;
    }
    return false;
}

bool flat_ones_are_close(const Surface& a, const Surface& b, double distance) {
    if (a.normal.cross(b.normal).norm() > small_angle) return false;
    const Extent plane = extent(a, a.normal);
    const Extent other = extent(b, a.normal);
    if (other.low > plane.high + distance || other.high < plane.low - distance) return false;
    // Neighbours in one plane do not cover each other.
    return common_area(a, b) > least_share * std::min(area(a.shape), area(b.shape));
}

/// Whether some place of a surface has another right above or beneath it, nearly parallel.
bool comes_close(const Surface& surface, const Surface& other, double distance) {
    const SurfaceMap map(surface);
    for (int i = 0; i < lattice * lattice; ++i) {
        const int row = i / lattice;
        const SurfacePoint place = map.at((i % lattice + 0.5) / lattice, (row + 0.5) / lattice);
        for (const Vector3d& direction : {place.normal, Vector3d(-place.normal)}) {
            const auto meeting = line_meets({place.position, direction}, other);
            if (!meeting || meeting->time > distance) continue;
            const Vector3d normal = normal_at(other, place.position + meeting->time * direction);
            if (normal.cross(direction).norm() <= small_angle_of_curves) return true;
        }
    }
    return false;
}

}  // namespace

bool has_fine_detail(const Scene& scene) {
    const std::vector<Eigen::AlignedBox3d> boxes = boxes_around(scene.surfaces);
    const double largest = farthest_coordinate(scene);
    if (has_narrow_face(scene, boxes, largest)) return true;
    const BoxTree tree(boxes);
    for (std::uint32_t i = 0; i < boxes.size(); ++i) {
        const Surface& a = scene.surfaces[i];
        const bool is_curved = !is_flat(a.shape);
        const double room = (is_curved ? near_curved : near_flat) * largest;
        bool close = false;
        tree.within(boxes[i], room, [&](std::uint32_t j) {
            if (close || j == i) return;
            const Surface& b = scene.surfaces[j];
            if (is_curved) {
                close = comes_close(a, b, near_curved * largest) || comes_close(b, a, near_curved * largest);
            } else if (is_flat(b.shape) && j > i) {
                close = flat_ones_are_close(a, b, near_flat * largest);
            }
        });
        if (close) return true;
    }
    return false;
}

std::unique_ptr<Tracer> make_double_tracer(const Scene& scene) {
    return std::make_unique<DoubleTracer>(scene);
}

}  // namespace ff
