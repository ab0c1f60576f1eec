#pragma once

#include "core/exact/pair_exchange.hpp"
#include "core/geometry/fwd.hpp"
#include "core/geometry/surface_map.hpp"
#include "core/visibility/visible_polygon.hpp"
#include "samplers/grids/gauss_legendre.hpp"
#include "studies/form_factors/cells/part_bounds.hpp"

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <utility>
#include <vector>

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

/// The image of the unit square in a quadrilateral; two of its corners may coincide.
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
    /// Halves it across its longer sides.
    [[nodiscard]] std::array<Quadrilateral, 2> halves() const;
    /// Extent of the image in a plane. Its size is such that two places are no farther apart than this size, times
    /// their distance in the square over the largest distance there.
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

    /// Extent of the part of the surface that a part of the rectangle stands for.
    [[nodiscard]] PartExtent extent(const Quadrilateral& part, const Eigen::Vector3d& origin) const;

  private:
    SurfaceMap map_;
    double area_;
    double turn_ = 0;  ///< largest turn of the normal per length in the rectangle
    Eigen::Vector2d size_ = Eigen::Vector2d::Zero();
};

/// The parts of the target that a place sees and that are hidden from it.
enum Side : std::uint8_t { visible, hidden };
using Factors = std::array<double, 2>;

/// A part of the source with the factors at the nodes of a rule.
struct Cell {
    Quadrilateral shape;
    std::vector<std::uint32_t> blockers;  ///< blockers that may hide something; empty between lines, where all count
    std::vector<Factors> at_nodes;        ///< factors at the nodes, those of one u together
    Factors integral{};
    Factors left{};  ///< what is left between the nodes, as an exchange area
    // Upper bounds of the factor times the area, and of its change times a third of the area; 0 between lines.
    Factors jumps{};
    double change = 0;
    std::uint32_t places = 1;  ///< random places in each randomisation

    /// If random places miss a share u, what lies there is at most this times u^(3/2), at levels up to three times that
    /// share as well (docs/statistics.md); where the factor jumps, at most `jumps` times u.
    [[nodiscard]] double missed_smoothly(double u) const {
        return u < 1 ? change / (1 - std::sqrt(u)) : std::numeric_limits<double>::infinity();
    }
    /// @param u  with one place in each randomisation
    [[nodiscard]] double unmet(Side side, double u) const {
        u /= places;
        return std::min(jumps[side] * u, missed_smoothly(u) * u * std::sqrt(u));
    }
};

/// A surface that is integrated over, and a polygon that it sees past other polygons.
struct CellPair {
    const Surface& source;  ///< the smaller polygon, or the round surface
    const Surface& target;
    const PairExchange& exchange;
    FacedEnd source_end;
    double most = 0;  ///< upper bound of the exchange area
};

/// The factors from places in cells of a source to what they see of a target.
class CellFactors {
  public:
    explicit CellFactors(const CellPair& pair);

    /// The source where it is round.
    [[nodiscard]] const std::optional<RoundSource>& round() const { return round_; }
    /// Corners of cells on a polygon are relative to this place.
    [[nodiscard]] const Eigen::Vector3d& origin() const { return origin_; }
    [[nodiscard]] std::uint64_t evaluations() const { return evaluations_; }

    /// The factors at places in a cell, which are given in its square; they are valid until the next call.
    /// @param some  whether the cell lists the blockers that may hide something; otherwise all may
    std::span<const Factors> at(const Cell& cell, std::span<const Eigen::Vector2d> places, bool some);

    /// Area that a place in a cell stands for, per area in its square.
    [[nodiscard]] double area_at(const Cell& cell, const Eigen::Vector2d& uv) const;

    struct RandomPlace {
        Eigen::Vector2d uv;
        double area = 0;  ///< area that it stands for
    };
    /// @param xy  uniform in the unit square
    [[nodiscard]] RandomPlace random_place(const Cell& cell, const Eigen::Vector2d& xy) const;

    /// Notes what random places may miss in a cell. @param blockers  those that may hide something from it
    void bound(Cell& cell, const PartBounds& bounds, std::span<const std::uint32_t> blockers) const;

  private:
    const Surface& source_;
    std::optional<RoundSource> round_;
    Eigen::Vector3d origin_;
    VisiblePolygon target_;
    std::uint64_t evaluations_ = 0;
    std::vector<Eigen::Vector3d> positions_;
    std::vector<VisiblePolygon::Factors> seen_;
    std::vector<Factors> factors_;

    [[nodiscard]] double round_stretch(const Cell& cell, const Eigen::Vector2d& uv) const {
        return round_ ? round_->stretch(cell.shape.at(uv)) : 1;
    }
};

}  // namespace ff::studies::form_factors
