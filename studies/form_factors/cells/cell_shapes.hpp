#pragma once

#include "core/geometry/scene.hpp"
#include "core/geometry/surface_map.hpp"
#include "samplers/grids/gauss_legendre.hpp"
#include "studies/form_factors/cells/part_bounds.hpp"

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
    /// Places in the square, each with the area that it stands for where `xy` is uniform: spread evenly over a
    /// triangle whose first corner is also the last, or over the square.
    [[nodiscard]] std::pair<Eigen::Vector2d, double> random_place(const Eigen::Vector2d& xy) const;
    /// Upper bound of that area.
    [[nodiscard]] double most_area() const;
    /// Across its longer sides.
    [[nodiscard]] std::array<Quadrilateral, 2> halves() const;
    /// Of the image in a plane. Its size is such that two places are no farther apart than this, times their distance
    /// in the square over the farthest there.
    [[nodiscard]] PartExtent extent() const;

  private:
    [[nodiscard]] bool is_triangle() const { return corner[0] == corner[3]; }
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

    /// Upper bound of the stretch in a part of the rectangle.
    [[nodiscard]] double most_stretch(const Quadrilateral& part) const;

    /// Of what a part of the rectangle stands for.
    [[nodiscard]] PartExtent extent(const Quadrilateral& part, const Eigen::Vector3d& origin) const;

  private:
    SurfaceMap map_;
    double area_;
    double turn_ = 0;  ///< of the normal at most, per length in the rectangle
    Eigen::Vector2d size_ = Eigen::Vector2d::Zero();
};

}  // namespace ff::studies::form_factors
