#pragma once

#include "studies/form_factors/cells/cell_shapes.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
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

}  // namespace ff::studies::form_factors
