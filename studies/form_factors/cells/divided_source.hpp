#pragma once

#include "studies/form_factors/cells/blocked_pair.hpp"
#include "studies/form_factors/cells/cell_factors.hpp"

#include <atomic>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace ff::studies::form_factors {

/// Where the division of a source ends.
struct CellLimits {
    double wanted = 0;                        ///< half width to reach
    double level = 0.95;                      ///< level of the interval with that half width
    std::uint64_t evaluations = 0;            ///< largest number of evaluations
    const std::atomic<bool>* stop = nullptr;  ///< set by another thread: nothing is divided any more
};

/// Most random places of a cell in a randomisation: where they may miss too much, a cell gets this many before it is
/// halved.
inline constexpr std::uint32_t most_places = 8;

/// A source in cells that are small enough for Gauss's rule, and for the random places that measure what the rule
/// leaves. It is cut first along lines at which the factor changes. It is not cut where that would make too many parts,
/// where so little is exchanged that a few places are enough, and where it is round: geometry then bounds what random
/// places may miss (`PartBounds`).
class DividedSource {
  public:
    DividedSource(const CellPair& pair, const CellLimits& limits);

    [[nodiscard]] CellFactors& factors() { return factors_; }
    [[nodiscard]] const std::vector<Cell>& cells() const { return cells_; }
    /// Number of random places of all cells in a randomisation.
    [[nodiscard]] std::uint64_t places() const { return places_; }
    /// Share of a cell that random places may miss, with one of them in each randomisation.
    [[nodiscard]] double unmet_share() const { return unmet_share_; }
    /// The side that is integrated: the smoother one.
    [[nodiscard]] Side side() const { return side_; }
    [[nodiscard]] bool is_cut() const { return !bounds_; }
    [[nodiscard]] bool is_fine_enough() const { return is_fine_enough_; }

    /// The factor at a place less the interpolant, times the area that the place stands for.
    [[nodiscard]] Factors left_at(const Cell& cell, const CellFactors::RandomPlace& place, Factors found) const;

  private:
    CellPair pair_;
    CellLimits limits_;
    CellFactors factors_;
    double unmet_share_;
    double tolerances_;  ///< size of the whole exchange area, or its upper bound, in tolerances
    const CellRule& rule_;
    std::optional<PartBounds> bounds_;  ///< empty where the source is cut
    std::vector<Cell> cells_;
    std::uint64_t places_ = 0;
    Side side_ = visible;
    double left_ = 0;  ///< what is left of that side, between the nodes of all cells
    bool is_fine_enough_ = false;
    std::vector<Eigen::Vector2d> uvs_;

    void begin();
    void begin_round_source();
    void begin_whole(const BlockedPair& pair, const std::vector<RimEdge>& rim);
    void add_polygon(const ConvexPolygon& part, std::span<const std::uint32_t> blockers);
    void add(const Quadrilateral& shape, std::span<const std::uint32_t> blockers);
    [[nodiscard]] Factors interpolated(const Cell& cell, const Eigen::Vector2d& uv) const;
    void judge();
    [[nodiscard]] double most_unmet(double left) const;
    [[nodiscard]] bool is_at_limit() const;
    [[nodiscard]] bool may_miss_too_much(const Cell& cell) const;
    bool take_more_places(Cell& cell);
    void refine();
};

}  // namespace ff::studies::form_factors
