#include "studies/form_factors/cells/cell_factors.hpp"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace ff::studies::form_factors {

using Eigen::Vector2d;
using Eigen::Vector3d;

std::array<double, CellRule::most_nodes> CellRule::weights_at(double x) const {
    std::array<double, most_nodes> result;
    result.fill(1);
    for (std::size_t i = 0; i < size(); ++i) {
        for (std::size_t j = 0; j < size(); ++j) {
            if (j != i) result[i] *= (x - gauss.nodes[j]) / (gauss.nodes[i] - gauss.nodes[j]);
        }
    }
    return result;
}

Vector3d Quadrilateral::at(const Vector2d& uv) const {
    const auto [u, v] = std::pair(uv.x(), uv.y());
    return (1 - u) * (1 - v) * corner[0] + u * (1 - v) * corner[1] + u * v * corner[2] + (1 - u) * v * corner[3];
}

double Quadrilateral::stretch(const Vector2d& uv) const {
    const Vector3d along_u = (1 - uv.y()) * (corner[1] - corner[0]) + uv.y() * (corner[2] - corner[3]);
    const Vector3d along_v = (1 - uv.x()) * (corner[3] - corner[0]) + uv.x() * (corner[2] - corner[1]);
    return along_u.cross(along_v).norm();
}

std::array<Quadrilateral, 2> Quadrilateral::halves() const {
    const auto& [a, b, c, d] = corner;
    const bool along_u = (b - a).norm() + (c - d).norm() >= (d - a).norm() + (c - b).norm();
    if (along_u) {
        const Vector3d low = (a + b) / 2;
        const Vector3d high = (d + c) / 2;
        return {Quadrilateral{{a, low, high, d}}, Quadrilateral{{low, b, c, high}}};
    }
    const Vector3d left = (a + d) / 2;
    const Vector3d right = (b + c) / 2;
    return {Quadrilateral{{a, b, right, left}}, Quadrilateral{{left, right, c, d}}};
}

std::pair<Vector2d, double> Quadrilateral::random_place(const Vector2d& xy) const {
    if (is_triangle()) return {{std::sqrt(xy.x()), xy.y()}, stretch({0.5, 0.5})};
    return {xy, stretch(xy)};
}

double Quadrilateral::most_area() const {
    if (is_triangle()) return stretch({0.5, 0.5});
    return std::max({stretch({0, 0}), stretch({0, 1}), stretch({1, 0}), stretch({1, 1})});
}

PartExtent Quadrilateral::extent() const {
    PartExtent result;
    result.centre = Vector3d::Zero();
    for (std::size_t k = 0; k < corner.size(); ++k) {
        result.centre += corner[k] / static_cast<double>(corner.size());
        if (corner[k] != corner[k == 0 ? 3 : k - 1]) result.hull.push_back(corner[k]);
    }
    for (const Vector3d& a : result.hull) {
        result.radius = std::max(result.radius, (a - result.centre).norm());
        for (const Vector3d& b : result.hull) result.size = std::max(result.size, (a - b).norm());
    }
    const auto& [a, b, c, d] = corner;
    constexpr double rounding = 1e-12;
    const bool is_affine = is_triangle() || (a - b + c - d).norm() <= rounding * result.size;
    if (!is_affine) result.size = std::max((b - a).norm(), (c - d).norm()) + std::max((d - a).norm(), (c - b).norm());
    return result;
}

RoundSource::RoundSource(const Surface& surface) : map_(surface), area_(area(surface.shape)) {
    const auto along = [&](double s0, double t0, double s1, double t1) {
        return (map_.at(s1, t1).position - map_.at(s0, t0).position).norm();
    };
    for (int k = 0; k < 8; ++k) {
        const double low = k / 8.0;
        const double high = low + 0.125;
        size_.x() += along(low, 0, high, 0);
        size_.y() += std::max({along(0, low, 0, high), along(0.5, low, 0.5, high), along(1, low, 1, high)});
    }
    if (const auto* zone = std::get_if<SphereZone>(&surface.shape)) turn_ = 1 / zone->radius;
    if (std::holds_alternative<Frustum>(surface.shape)) turn_ = 2 * std::numbers::pi / size_.y();
}

SurfacePoint RoundSource::at(const Vector3d& place) const {
    const double u = place.x() / size_.x();
    return map_.at(u * u * (3 - 2 * u), place.y() / size_.y());
}

double RoundSource::stretch(const Vector3d& place) const {
    const double u = place.x() / size_.x();
    return area_ * 6 * u * (1 - u) / (size_.x() * size_.y());
}

double RoundSource::most_stretch(const Quadrilateral& part) const {
    // It is a concave function of the first coordinate, and largest in the middle of the rectangle.
    const auto [low, high] = std::minmax(part.corner[0].x(), part.corner[2].x());
    return stretch({std::clamp(size_.x() / 2, low, high), 0, 0});
}

PartExtent RoundSource::extent(const Quadrilateral& part, const Vector3d& origin) const {
    // Places are at most this many times as far apart as in the rectangle: along a meridian the square root of 3 where
    // it ends in a point, and a little more as the rectangle was measured along chords.
    constexpr double farther_along = 1.8;
    constexpr double farther_around = 1.2;
    PartExtent result;
    result.centre = at(part.at({0.5, 0.5})).position - origin;
    const Vector3d across = part.corner[2] - part.corner[0];
    result.size = std::hypot(farther_along * across.x(), farther_around * across.y());
    result.radius = result.size / 2;
    result.turn = std::min(2.0, turn_ * result.size);
    for (const int corner : {0, 1, 2, 3, 4, 5, 6, 7}) {
        const Vector3d side((corner & 1) != 0 ? 1 : -1, (corner & 2) != 0 ? 1 : -1, (corner & 4) != 0 ? 1 : -1);
        result.hull.emplace_back(result.centre + result.radius * side);
    }
    return result;
}

CellFactors::CellFactors(const CellPair& pair)
    : source_(pair.source),
      origin_(middle(pair.source)),
      target_(pair.target, pair.exchange.blockers, pair.source_end) {
    if (!is_polygon(source_.shape)) round_.emplace(source_);
}

std::span<const Factors> CellFactors::at(const Cell& cell, std::span<const Vector2d> places, bool some) {
    evaluations_ += places.size();
    seen_.resize(places.size());
    if (round_) {
        for (std::size_t k = 0; k < places.size(); ++k) {
            const SurfacePoint place = round_->at(cell.shape.at(places[k]));
            seen_[k] = target_.from(place.position, place.normal, cell.blockers);
        }
    } else {
        positions_.clear();
        for (const Vector2d& uv : places) positions_.emplace_back(origin_ + cell.shape.at(uv));
        if (some)
            target_.find(positions_, source_.normal, cell.blockers, seen_);
        else
            target_.find(positions_, source_.normal, seen_);
    }
    factors_.clear();
    for (const VisiblePolygon::Factors& seen : seen_) factors_.push_back({seen.visible, seen.whole - seen.visible});
    return factors_;
}

double CellFactors::area_at(const Cell& cell, const Vector2d& uv) const {
    return cell.shape.stretch(uv) * round_stretch(cell, uv);
}

CellFactors::RandomPlace CellFactors::random_place(const Cell& cell, const Vector2d& xy) const {
    const auto [uv, area] = cell.shape.random_place(xy);
    return {uv, area * round_stretch(cell, uv)};
}

void CellFactors::bound(Cell& cell, const PartBounds& bounds, std::span<const std::uint32_t> blockers) const {
    PartBounds::Bounds found = bounds.of(round_ ? round_->extent(cell.shape, origin_) : cell.shape.extent(), blockers);
    const double area = cell.shape.most_area() * (round_ ? round_->most_stretch(cell.shape) : 1);
    cell.blockers = std::move(found.blockers);
    cell.jumps = {area * found.visible, area * found.hidden};
    cell.change = area * found.change / 3;
}

}  // namespace ff::studies::form_factors
