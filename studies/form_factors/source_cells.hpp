#pragma once

#include "core/formulas/edge_integral.hpp"
#include "core/geometry/scene.hpp"
#include "studies/form_factors/sampled_share.hpp"

#include <cstdint>
#include <optional>
#include <vector>

namespace ff::studies {

/// A part of a surface from which neither all nor nothing of a target is known to be hidden.
struct SourceCell {
    double s0 = 0, s1 = 1, t0 = 0, t1 = 1;  ///< where it is, in the coordinates of core/geometry/surface_map.hpp
    double share = 1;                       ///< points in it, as a share of those on the whole source
    double first = 0;                       ///< of the points for rough cells those whose first coordinate is here ..
    double extra = 0;                       ///< .. or less than this above
    double area = 0;
    double most_hidden = 1;               ///< of the factor to the target from any place in it
    double most_whole = 1;                ///< of the factor with nothing in between
    double change = 0;                    ///< between two places of the cell a factor changes by at most this
    std::vector<std::uint32_t> blockers;  ///< indices of those that can stand in between
};

/// A surface divided by what geometry proves of its parts: from some all of the target is seen, from some a single
/// blocker hides all of it, and points are left for the rest. A part is divided as long as what points could miss there
/// may matter. Whatever the size of a blocker or of a hole, where its shadow can fall is found, not met by chance.
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
    BoundedValue<double> umbra;  ///< exchange area with nothing in between of the parts that see nothing of the target
    BoundedValue<double> open;   ///< and of `mixed`; both 0 of a curved source
    double due = 0;              ///< share of all points that places may be due and get none of, at the expected size
    bool curved = false;         ///< the source is

    /// The cell of a place; null where none is needed.
    [[nodiscard]] const SourceCell* at(double s, double t) const;

    /// Whether nothing was divided.
    [[nodiscard]] bool is_whole() const {
        return mixed.size() == 1 && mixed[0].s0 == 0 && mixed[0].s1 == 1 && mixed[0].t0 == 0 && mixed[0].t1 == 1;
    }
};

/// @param source    any surface; a curved one has no parts that are known
/// @param target    a polygon, like all blockers
/// @param whole     exchange area with nothing in between, where points are sized by it (PointEffort)
/// @param wanted    exchange area that matters
SourceCells divide(const Surface& source, const Surface& target, const std::vector<const Surface*>& blockers,
                   const std::optional<BoundedValue<double>>& whole, double wanted);

/// What points may have missed of an exchange area.
/// @param hidden  whether the hidden part is sampled, not what is seen
Unmet unmet(const SourceCells& cells, bool hidden);

}  // namespace ff::studies
