#include "core/exact/exact.hpp"

#include "core/formulas/polygon_exchange.hpp"
#include "core/formulas/rectangle_formulas.hpp"
#include "core/geometry/convex_polygon.hpp"
#include "core/support/contract.hpp"
#include "core/visibility/mirrors.hpp"
#include "core/visibility/occlusion.hpp"

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

namespace ff {
namespace {

/// The part of `rectangle` in front of the plane of `viewer`, as heights above that plane.
/// @pre the planes are perpendicular
AxisInterval heights_above(const AlignedRectangle& viewer, const AlignedRectangle& rectangle) {
    const AxisInterval& extent = rectangle.extent[viewer.axis];
    const long double a = viewer.side * (extent.low - viewer.plane());
    const long double b = viewer.side * (extent.high - viewer.plane());
    return {std::max(0.0L, std::min(a, b)), std::max(0.0L, std::max(a, b))};
}

template <class Real>
Real parallel_pair(const AlignedRectangle& from, const AlignedRectangle& to) {
    const long double gap = from.side * (to.plane() - from.plane());
    if (gap <= 0 || from.side == to.side) return 0;
    const std::size_t x = (from.axis + 1) % 3;
    const std::size_t y = (from.axis + 2) % 3;
    return parallel_exchange_area<Real>(from.extent[x], from.extent[y], to.extent[x], to.extent[y], gap);
}

template <class Real>
Real perpendicular_pair(const AlignedRectangle& from, const AlignedRectangle& to) {
    const AxisInterval height_from = heights_above(to, from);
    const AxisInterval height_to = heights_above(from, to);
    if (height_from.high <= 0 || height_to.high <= 0) return 0;
    const std::size_t along = 3 - from.axis - to.axis;
    return perpendicular_exchange_area<Real>(from.extent[along], to.extent[along], height_from, height_to);
}

template <class Real>
Real exchange_area(const AlignedRectangle& from, const AlignedRectangle& to) {
    return from.axis == to.axis ? parallel_pair<Real>(from, to) : perpendicular_pair<Real>(from, to);
}

template <class Real>
std::optional<Real> exchange_area_of_rectangles(const Surface& from, const Surface& to) {
    const auto from_rectangle = aligned_rectangle(from);
    const auto to_rectangle = aligned_rectangle(to);
    if (!from_rectangle || !to_rectangle) return std::nullopt;
    return exchange_area<Real>(*from_rectangle, *to_rectangle);
}

/// A place that receives for a face.
struct Target {
    AlignedRectangle rectangle;
    int face = 0;
};

/// The surfaces of faces and their images in mirrors; empty if one is not a rectangle along the axes, or if images are
/// not known.
std::optional<std::vector<Target>> targets(const Scene& scene) {
    std::vector<Target> all;
    for (const Surface& surface : scene.surfaces) {
        if (!is_of_face(surface)) continue;
        const auto places = images(scene, surface);
        if (!places) return std::nullopt;
        for (const Surface& place : *places) {
            const auto rectangle = aligned_rectangle(place);
            if (!rectangle) return std::nullopt;
            all.push_back({*rectangle, surface.face});
        }
    }
    return all;
}

using Eigen::Vector3d;

/// Gives pairs of patches in the same relative position the same number. A pair is given by column and row of both
/// patches; its offset is a sum of these times the patches' edges, in which equal edges of the two count together.
class Offsets {
  public:
    /// @param from, to  one patch of each
    Offsets(const Parallelogram& from, Grid from_grid, const Parallelogram& to, Grid to_grid)
        : last_{from_grid.columns - 1, from_grid.rows - 1, to_grid.columns - 1, to_grid.rows - 1} {
        const std::array<Vector3d, 2> from_edges{from.edge_u, from.edge_v};
        const std::array<Vector3d, 2> to_edges{to.edge_u, to.edge_v};
        std::array<bool, 2> taken{};
        for (std::size_t i = 0; i < 2; ++i) {
            strides_[i] = size_;
            std::size_t values = last_[i] + 1;
            for (std::size_t j = 0; j < 2; ++j) {
                const int sign = equal(from_edges[i], to_edges[j]) - equal(from_edges[i], -to_edges[j]);
                if (sign == 0 || taken[j]) continue;
                taken[j] = true;
                values = last_[i] + last_[2 + j] + 1;
                // -a + b from -(last a) to (last b), or -a - b: equal offsets for equal a + b.
                strides_[2 + j] = size_;
                if (sign > 0) reversed_[2 + j] = true;
            }
            size_ *= values;
        }
        for (std::size_t j = 0; j < 2; ++j) {
            if (taken[j]) continue;
            strides_[2 + j] = size_;
            size_ *= last_[2 + j] + 1;
        }
    }

    [[nodiscard]] std::size_t size() const { return size_; }

    /// @param place  column and row of the first patch, column and row of the second
    [[nodiscard]] std::size_t number(const std::array<std::uint32_t, 4>& place) const {
        std::size_t number = 0;
        for (std::size_t k = 0; k < place.size(); ++k)
            number += strides_[k] * (reversed_[k] ? last_[k] - place[k] : place[k]);
        return number;
    }

  private:
    static bool equal(const Vector3d& a, const Vector3d& b) {
        return (a - b).norm() <= 4 * std::numeric_limits<double>::epsilon() * a.norm();
    }

    std::array<std::size_t, 4> strides_{};
    std::array<bool, 4> reversed_{};
    std::size_t size_ = 1;
    std::array<std::size_t, 4> last_;
};

BoundedValue<double> exchange_of(const Surface& from, const Surface& to) {
    if (const auto exact = exact_exchange_area(from, to)) return {*exact, 1e-15 * squared_extent(from, to)};
    return polygon_exchange_area<double>(corners_of<double>(from), corners_of<double>(to));
}

}  // namespace

std::optional<double> exact_exchange_area(const Surface& from, const Surface& to) {
    return exchange_area_of_rectangles<double>(from, to);
}

std::optional<double> extended_exchange_area(const Surface& from, const Surface& to) {
    const auto area = exchange_area_of_rectangles<long double>(from, to);
    return area ? std::optional(static_cast<double>(*area)) : std::nullopt;
}

double squared_extent(const Surface& from, const Surface& to) {
    return box_around(corners(from.shape)).merged(box_around(corners(to.shape))).diagonal().squaredNorm();
}

std::optional<double> exact_form_factor(const Scene& scene, int from_face, int to_face) {
    FF_EXPECT(from_face >= 0 && static_cast<std::size_t>(from_face) < scene.faces.size());
    FF_EXPECT(to_face >= 0 && static_cast<std::size_t>(to_face) < scene.faces.size());
    long double sum = 0;
    for (const Surface* from : surfaces_of(scene, from_face)) {
        for (const Surface* to : surfaces_of(scene, to_face)) {
            const auto places = images(scene, *to);
            if (!places) return std::nullopt;
            for (const Surface& place : *places) {
                const auto area = exchange_area_of_rectangles<long double>(*from, place);
                if (!area) return std::nullopt;
                sum += *area;
            }
        }
    }
    return static_cast<double>(sum / face_area(scene, from_face));
}

std::optional<Eigen::MatrixXd> exact_patch_to_face(const Scene& scene, Subdivision subdivision) {
    if (may_be_occluded(scene)) return std::nullopt;
    const auto all = targets(scene);
    if (!all) return std::nullopt;
    Eigen::MatrixXd factors = Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(subdivision.patches(scene)),
                                                    static_cast<Eigen::Index>(scene.faces.size()));
    Eigen::Index row = -1;
    for (const Surface& source : scene.surfaces) {
        const Grid grid = subdivision.of(source);
        for (std::uint32_t p = 0; p < grid.parts(); ++p) {
            ++row;
            if (!is_of_face(source)) continue;
            const Surface piece = patch(source, grid, p);
            const auto from = aligned_rectangle(piece);
            FF_ENSURE(from.has_value());
            for (const Target& target : *all) {
                factors(row, target.face) +=
                    static_cast<double>(exchange_area<long double>(*from, target.rectangle) / area(piece.shape));
            }
        }
    }
    return factors;
}

std::optional<Eigen::MatrixXd> exact_form_factors(const Scene& scene) {
    if (may_be_occluded(scene)) return std::nullopt;
    const auto faces = static_cast<int>(scene.faces.size());
    Eigen::MatrixXd factors(faces, faces);
    for (int from = 0; from < faces; ++from) {
        for (int to = 0; to < faces; ++to) {
            const auto factor = exact_form_factor(scene, from, to);
            if (!factor) return std::nullopt;
            factors(from, to) = *factor;
        }
    }
    return factors;
}

PatchExchange patch_exchange(const Surface& from, const Surface& to, Subdivision subdivision) {
    const Grid of_from = subdivision.of(from);
    const Grid of_to = subdivision.of(to);
    const Offsets offsets(patch(parallelogram(from), of_from, 0), of_from, patch(parallelogram(to), of_to, 0), of_to);
    std::vector<std::optional<double>> known(offsets.size());
    PatchExchange result;
    result.areas.resize(of_from.parts(), of_to.parts());
    for (std::uint32_t j = 0; j < of_to.parts(); ++j) {
        for (std::uint32_t i = 0; i < of_from.parts(); ++i) {
            auto& exchange =
                known[offsets.number({i % of_from.columns, i / of_from.columns, j % of_to.columns, j / of_to.columns})];
            if (!exchange) {
                const auto value = exchange_of(patch(from, of_from, i), patch(to, of_to, j));
                exchange = value.value;
                result.error = std::max(result.error, value.error);
                ++result.computed;
            }
            result.areas(i, j) = *exchange;
        }
    }
    return result;
}

}  // namespace ff
