#include "studies/form_factors/cells/cell_shapes.hpp"

#include <Eigen/Geometry>

#include <algorithm>
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
}

SurfacePoint RoundSource::at(const Vector3d& place) const {
    const double u = place.x() / size_.x();
    return map_.at(u * u * (3 - 2 * u), place.y() / size_.y());
}

double RoundSource::stretch(const Vector3d& place) const {
    const double u = place.x() / size_.x();
    return area_ * 6 * u * (1 - u) / (size_.x() * size_.y());
}

std::pair<Vector3d, double> RoundSource::ball_around(const Quadrilateral& part) const {
    const Vector3d middle = at(part.at({0.5, 0.5})).position;
    double radius = 0;
    for (const double u : {0.0, 0.5, 1.0}) {
        for (const double v : {0.0, 0.5, 1.0})
            radius = std::max(radius, (at(part.at({u, v})).position - middle).norm());
    }
    constexpr double between = 1.2;  // what lies between those places may be a little farther from the middle
    return {middle, between * radius};
}

}  // namespace ff::studies::form_factors
