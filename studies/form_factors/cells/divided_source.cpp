#include "studies/form_factors/cells/divided_source.hpp"

#include "core/geometry/surface_map.hpp"
#include "studies/form_factors/sampled_row.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace ff::studies::form_factors {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

/// The source is cut into so many parts at most, for each tolerance that the whole exchange area is large; into a few
/// anyway. With more of them, places that may miss something are fewer.
constexpr double parts_per_tolerance = 0.6;
constexpr double least_most_parts = 6;
constexpr double most_evaluations_of_part = 128;

/// A pair that exchanges at most this many tolerances is first tried without cutting the source.
constexpr double few_tolerances = 6;

/// Cells are halved until the remainders at places between the nodes, added up as independent errors, are this share of
/// the wanted half width. What random places may miss in a cell has to stay within the rest.
constexpr double left_of_wanted = 0.3;
constexpr double most_of_wanted = 0.95;
constexpr double width_of_left = 0.8;

/// Cells whose remainder is at least this share of the largest one are halved together.
constexpr double as_bad = 0.5;

/// Places in the unit square between the nodes of every rule.
constexpr std::array<std::array<double, 2>, 4> between_nodes{{{0.2, 0.3}, {0.7, 0.2}, {0.8, 0.7}, {0.3, 0.8}}};

/// The rule for an exchange area of this many tolerances.
const CellRule& rule_for(double tolerances) {
    static const std::array<CellRule, 4> rules{CellRule(2), CellRule(3), CellRule(4), CellRule(6)};
    return rules[tolerances < 10 ? 0 : tolerances < 1000 ? 1 : tolerances < 1e5 ? 2 : 3];
}

}  // namespace

DividedSource::DividedSource(const CellPair& pair, const CellLimits& limits)
    : pair_(pair),
      limits_(limits),
      factors_(pair_),
      unmet_share_(-std::log((1 - limits.level) / 2) / randomisations),
      tolerances_(pair.most / limits.wanted),
      rule_(rule_for(tolerances_)) {
    begin();
    for (judge(); !is_fine_enough_ && !is_at_limit(); judge()) refine();
}

void DividedSource::begin() {
    if (factors_.round()) return begin_round_source();
    const BlockedPair pair(pair_.source, pair_.target, pair_.exchange.blockers);
    if (pair.source.empty() || pair.target.empty()) return;
    const std::vector<RimEdge> rim = rim_of(pair);
    if (tolerances_ <= few_tolerances) {
        begin_whole(pair, rim);
        judge();
        if (is_fine_enough_) return;
        cells_.clear();
        places_ = 0;
        bounds_.reset();
    }
    const double most_parts = std::min(std::max(parts_per_tolerance * tolerances_, least_most_parts),
                                       static_cast<double>(limits_.evaluations) / most_evaluations_of_part);
    const std::vector<ConvexPolygon> parts = smooth_parts(pair, rim, static_cast<std::size_t>(most_parts));
    if (parts.empty()) return begin_whole(pair, rim);
    for (const ConvexPolygon& part : parts) add_polygon(part, {});
}

void DividedSource::begin_round_source() {
    constexpr int sectors = 4;
    bounds_.emplace(pair_.source, pair_.target, pair_.exchange.blockers, factors_.origin());
    const std::vector<std::uint32_t> blockers = bounds_->blockers();
    const auto [x, y] = std::pair(factors_.round()->size().x(), factors_.round()->size().y() / sectors);
    for (int k = 0; k < sectors; ++k)
        add({{Vector3d(0, k * y, 0), {x, k * y, 0}, {x, (k + 1) * y, 0}, {0, (k + 1) * y, 0}}}, blockers);
}

void DividedSource::begin_whole(const BlockedPair& pair, const std::vector<RimEdge>& rim) {
    bounds_.emplace(pair_.source, pair, rim, pair_.exchange.blockers.size());
    add_polygon(pair.source, bounds_->blockers());
}

void DividedSource::add_polygon(const ConvexPolygon& part, std::span<const std::uint32_t> blockers) {
    for (std::size_t k = 1; k + 1 < part.size(); k += 2)
        add({{part[0], part[k], part[k + 1], part[k + 2 == part.size() ? 0 : k + 2]}}, blockers);
}

Factors DividedSource::interpolated(const Cell& cell, const Vector2d& uv) const {
    const auto u = rule_.weights_at(uv.x());
    const auto v = rule_.weights_at(uv.y());
    const std::size_t size = rule_.size();
    Factors sum{};
    for (std::size_t i = 0; i < size; ++i) {
        for (std::size_t j = 0; j < size; ++j) {
            for (const Side side : {visible, hidden}) sum[side] += u[i] * v[j] * cell.at_nodes[i * size + j][side];
        }
    }
    return sum;
}

Factors DividedSource::left_at(const Cell& cell, const CellFactors::RandomPlace& place, Factors found) const {
    const Factors smooth = interpolated(cell, place.uv);
    for (const Side side : {visible, hidden}) found[side] = (found[side] - smooth[side]) * place.area;
    return found;
}

/// @param blockers  that may hide something from it, where the source is not cut
void DividedSource::add(const Quadrilateral& shape, std::span<const std::uint32_t> blockers) {
    Cell cell;
    cell.shape = shape;
    if (bounds_) factors_.bound(cell, *bounds_, blockers);
    const auto& [nodes, weights] = rule_.gauss;
    const std::size_t size = nodes.size();
    uvs_.clear();
    for (const double u : nodes) {
        for (const double v : nodes) uvs_.emplace_back(u, v);
    }
    for (const auto& [u, v] : between_nodes) uvs_.emplace_back(u, v);
    const std::span<const Factors> found = factors_.at(cell, uvs_, bounds_.has_value());
    cell.at_nodes.assign(found.begin(), found.begin() + static_cast<std::ptrdiff_t>(size * size));
    for (std::size_t k = 0; k < size * size; ++k) {
        const double weight = weights[k / size] * weights[k % size] * factors_.area_at(cell, uvs_[k]);
        for (const Side side : {visible, hidden}) cell.integral[side] += weight * found[k][side];
    }
    for (std::size_t k = size * size; k < uvs_.size(); ++k) {
        const Factors left = left_at(cell, {uvs_[k], factors_.area_at(cell, uvs_[k])}, found[k]);
        for (const Side side : {visible, hidden}) cell.left[side] = std::max(cell.left[side], std::abs(left[side]));
    }
    cells_.push_back(std::move(cell));
    ++places_;
}

/// Chooses the side that is nearer to what is wanted, and finds whether it is near enough.
void DividedSource::judge() {
    Factors left{};
    Factors unmet{};
    for (const Cell& cell : cells_) {
        for (const Side side : {visible, hidden}) {
            left[side] += cell.left[side] * cell.left[side];
            unmet[side] = std::max(unmet[side], cell.unmet(side, unmet_share_));
        }
    }
    const auto excess = [&](Side side) {
        const double all = std::sqrt(left[side]);
        return std::max(all / (left_of_wanted * limits_.wanted), unmet[side] / most_unmet(all));
    };
    side_ = pair_.exchange.area && excess(hidden) < excess(visible) ? hidden : visible;
    left_ = std::sqrt(left[side_]);
    is_fine_enough_ = excess(side_) <= 1;
}

/// @param left  between the nodes of all cells
double DividedSource::most_unmet(double left) const {
    return most_of_wanted * limits_.wanted - width_of_left * std::min(left, left_of_wanted * limits_.wanted);
}

/// The random places are still to be drawn.
bool DividedSource::is_at_limit() const {
    const bool is_stopped = limits_.stop != nullptr && *limits_.stop;
    return is_stopped || factors_.evaluations() + randomisations * places_ >= limits_.evaluations;
}

bool DividedSource::may_miss_too_much(const Cell& cell) const {
    return cell.unmet(side_, unmet_share_) > most_unmet(left_);
}

/// @return whether the largest number of places that a cell may have is enough
bool DividedSource::take_more_places(Cell& cell) {
    const std::uint32_t before = cell.places;
    while (may_miss_too_much(cell) && cell.places < most_places) ++cell.places;
    const bool are_enough = !may_miss_too_much(cell);
    if (!are_enough) cell.places = before;
    places_ += cell.places - before;
    return are_enough;
}

/// Halves the cells with the largest remainders, and those in which random places may miss too much.
void DividedSource::refine() {
    const bool leaves_too_much = left_ > left_of_wanted * limits_.wanted;
    double most = 0;
    for (const Cell& cell : cells_) most = std::max(most, cell.left[side_]);
    std::vector<Cell> before;
    std::swap(before, cells_);
    for (Cell& cell : before) {
        const bool is_bad = leaves_too_much && cell.left[side_] >= as_bad * most;
        const bool needs_more = is_bad || may_miss_too_much(cell);
        if (needs_more && !is_at_limit() && (is_bad || !take_more_places(cell))) {
            places_ -= cell.places;
            for (const Quadrilateral& half : cell.shape.halves()) add(half, cell.blockers);
        } else {
            cells_.push_back(std::move(cell));
        }
    }
}

}  // namespace ff::studies::form_factors
