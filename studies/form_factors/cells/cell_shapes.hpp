#pragma once

#include "core/geometry/scene.hpp"
#include "core/geometry/surface_map.hpp"
#include "samplers/grids/gauss_legendre.hpp"

#include <Eigen/Core>

#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>

namespace ff::studies::form_factors {

/// Gauss's rule and the polynomials through its nodes.
struct CellRule {
    static constexpr std::size_t most_nodes = 6;

    samplers::GaussRule gauss;

    explicit CellRule(std::uint32_t nodes) : gauss(samplers::gauss_rule(nodes)) {}

    [[nodiscard]] std::size_t size() const { return gauss.nodes.size(); }
    /// Weights of the nodes in the value of the polynomial at x.
    [[nodiscard]] std::array<double, most_nodes> weights_at(double x) const;
};

/// The image of the unit square in a quadrilateral; one of its corners may be that of two.
struct Quadrilateral {
    std::array<Eigen::Vector3d, 4> corner;

    [[nodiscard]] Eigen::Vector3d at(const Eigen::Vector2d& uv) const;
    /// Area of the image per area in the square.
    [[nodiscard]] double stretch(const Eigen::Vector2d& uv) const;
    /// Across its longer sides.
    [[nodiscard]] std::array<Quadrilateral, 2> halves() const;
};

/// A round surface, spread out on a rectangle in which places are as far apart as on the surface, roughly.
class RoundSource {
  public:
    explicit RoundSource(const Surface& surface);

    [[nodiscard]] const Eigen::Vector2d& size() const { return size_; }
    [[nodiscard]] SurfacePoint at(const Eigen::Vector3d& place) const;
    /// Area on the surface per area of the rectangle. Along a meridian places lie as the square root of s where it
    /// begins or ends in a point, and as a smooth function of the rectangle's first coordinate.
    [[nodiscard]] double stretch(const Eigen::Vector3d& place) const;

    /// The middle and the radius of a ball that holds what a part of the rectangle stands for.
    [[nodiscard]] std::pair<Eigen::Vector3d, double> ball_around(const Quadrilateral& part) const;

  private:
    SurfaceMap map_;
    double area_;
    Eigen::Vector2d size_ = Eigen::Vector2d::Zero();
};

}  // namespace ff::studies::form_factors
