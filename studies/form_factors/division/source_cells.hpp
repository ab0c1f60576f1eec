#pragma once

#include "core/formulas/edge_integral.hpp"
#include "studies/form_factors/division/sampled_share.hpp"

#include <cstdint>
#include <vector>

namespace ff::studies::form_factors {

/// A part of a surface, in the coordinates of core/geometry/surface_map.hpp.
struct SourceRange {
    double s0 = 0, s1 = 1, t0 = 0, t1 = 1;

    [[nodiscard]] double middle(bool along_s) const { return along_s ? (s0 + s1) / 2 : (t0 + t1) / 2; }
    [[nodiscard]] SourceRange half(bool along_s, bool upper) const;
};

/// A part of a surface from which the target is neither known to be fully hidden nor fully visible.
struct SourceCell {
    SourceRange range;
    double share = 1;  ///< its points as a share of those on the whole source
    double first = 0;  ///< extra points for rough cells fall here if their first coordinate is from this ..
    double extra = 0;  ///< .. to less than this above it
    double area = 0;
    double most_hidden = 1;  ///< upper bound of what is hidden of the factor to the target, from any place in it
    double most_whole = 1;   ///< upper bound of the factor with nothing in between
    double change = 0;       ///< upper bound of a factor's change between two places of the cell
    std::vector<std::uint32_t> blockers;  ///< indices of possible obstacles
};

/// A surface divided by what geometry proves about its parts: some see all of the target, from some a single blocker
/// hides all of it, and points are left for the rest. A part is divided as long as what points could miss there may
/// matter. Whatever the size of a blocker or a hole, its possible shadow is found systematically, not hit by chance.
struct SourceCells {
    /// The tree of halves.
    struct Node {
        bool along_s = false;
        std::int32_t cell = -1;    ///< index in `mixed` where it is not divided; -1 where no points are needed
        std::uint32_t halves = 0;  ///< index of the lower one, which the upper one follows; 0 where it is not divided
    };
    std::vector<Node> nodes;  ///< the first is the source
    std::vector<SourceCell> mixed;
    double extra = 0;            ///< points for rough cells beside those on the whole source, as a share of these
    BoundedValue<double> umbra;  ///< unoccluded exchange area of the parts that see nothing of the target
    BoundedValue<double> open;   ///< and that of `mixed`; both are 0 for a curved source
    double due = 0;              ///< share of points that places may be entitled to and still get none
    bool curved = false;         ///< whether the source is curved

    /// The cell of a place; null where no points are needed.
    [[nodiscard]] const SourceCell* at(double s, double t) const;

    /// Whether the source is undivided.
    [[nodiscard]] bool is_whole() const { return nodes.size() == 1 && !mixed.empty(); }
};

/// What points may have missed grows as this power of a share of them, by Brunn and Minkowski: docs/statistics.md.
double power_of_unmet(bool curved);

/// Upper bound of the exchange from places of a cell entitled to a share p of all points, divided by p^power; the cell
/// has `share` of the points.
double smooth_unmet(const SourceCell& cell, double share, bool curved);

/// Upper bound of what points may have missed of an exchange area.
/// @param hidden  whether the hidden part is sampled instead of the visible one
UnmetBound unmet(const SourceCells& cells, bool hidden);

}  // namespace ff::studies::form_factors
