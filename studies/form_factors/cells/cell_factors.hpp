#pragma once

#include "core/exact/pair_exchange.hpp"
#include "core/geometry/scene.hpp"
#include "core/visibility/visible_polygon.hpp"
#include "studies/form_factors/cells/cell_shapes.hpp"
#include "studies/form_factors/cells/part_bounds.hpp"

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <vector>

namespace ff::studies::form_factors {

/// What is seen of the target from a place, and what is hidden of it.
enum Side : std::uint8_t { visible, hidden };
using Factors = std::array<double, 2>;

/// A part of the source with the factors at the nodes of a rule.
struct Cell {
    Quadrilateral shape;
    std::vector<std::uint32_t> blockers;  ///< that may hide something; none between lines, where all count
    std::vector<Factors> at_nodes;        ///< those of one u together
    Factors integral{};
    Factors left{};  ///< what is left between the nodes, as an exchange area
    // Upper bounds of the factor times the area, and of its change times a third of the area; 0 between lines.
    Factors jumps{};
    double change = 0;
    std::uint32_t places = 1;  ///< random ones in each randomisation

    /// What random places may miss, where they may miss a share u of it, is at most this times u^(3/2), and for
    /// three times the share (docs/statistics.md); and where it jumps, at most `jumps` times u.
    [[nodiscard]] double missed_smoothly(double u) const {
        return u < 1 ? change / (1 - std::sqrt(u)) : std::numeric_limits<double>::infinity();
    }
    /// @param u  with one place in each randomisation
    [[nodiscard]] double unmet(Side side, double u) const {
        u /= places;
        return std::min(jumps[side] * u, missed_smoothly(u) * u * std::sqrt(u));
    }
};

/// A surface that is integrated over, and a polygon past polygons.
struct CellPair {
    const Surface& source;  ///< the smaller polygon, or what is round
    const Surface& target;
    const PairExchange& exchange;
    FacedEnd source_end;
    double most = 0;  ///< upper bound of the exchange area
};

/// What places in cells of a source see of a target.
class CellFactors {
  public:
    explicit CellFactors(const CellPair& pair);

    /// The source where it is round.
    [[nodiscard]] const std::optional<RoundSource>& round() const { return round_; }
    /// Of the corners of cells on a polygon.
    [[nodiscard]] const Eigen::Vector3d& origin() const { return origin_; }
    [[nodiscard]] std::uint64_t evaluations() const { return evaluations_; }

    /// At places in a cell, given in its square; they live until the next call.
    /// @param some  whether the cell lists those that may hide something, else all may
    std::span<const Factors> at(const Cell& cell, std::span<const Eigen::Vector2d> places, bool some);

    /// Area that a place in a cell stands for, per area in its square.
    [[nodiscard]] double area_at(const Cell& cell, const Eigen::Vector2d& uv) const;

    struct RandomPlace {
        Eigen::Vector2d uv;
        double area = 0;  ///< that it stands for
    };
    /// @param xy  uniform in the unit square
    [[nodiscard]] RandomPlace random_place(const Cell& cell, const Eigen::Vector2d& xy) const;

    /// Notes what random places may miss in a cell. @param blockers  that may hide something from it
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
