#include "core/visibility/shadow_edges.hpp"

#include "core/support/contract.hpp"

#include <Eigen/Geometry>

#include <algorithm>
#include <numeric>
#include <utility>

namespace ff {
namespace {

using Eigen::Vector3d;

/// Room for rounding, in roundings of coordinates.
constexpr double roundings_of_plane = 8;

/// The outline may stay open by this share of the target's distance: what is seen is wrong by less then.
constexpr double open_outline = 1e-11;

double size_of(const Vector3d& v) {
    return v.lpNorm<1>();
}

std::size_t count_corners(std::span<const ConvexPolygon> polygons) {
    std::size_t sum = 0;
    for (const ConvexPolygon& polygon : polygons) sum += polygon.size();
    return sum;
}

}  // namespace

ShadowEdges::ShadowEdges(std::span<const ConvexPolygon> polygons, double rounding)
    : rounding_(rounding), rows_(EdgeTable<double>::rows_for(count_corners(polygons))) {
    for (const ConvexPolygon& polygon : polygons) {
        Plane& plane = planes_.emplace_back();
        first_.push_back(first_.back() + static_cast<std::uint32_t>(polygon.size()));
        if (polygon.empty()) continue;
        const Vector3d along = twice_area(polygon);
        plane.normal = along.normalized();
        plane.corner = polygon.front();
        plane.room = roundings_of_plane * rounding;
        // The direction of the normal is as uncertain as the corners are, beside the polygon's breadth.
        plane.tilt = plane.room * length_around(polygon) / along.norm();
    }
    edges_.resize(edge_ends::count * rows_);
    owner_.resize(rows_);
    const EdgeTable<double> table{edges_.data(), rows_};
    std::size_t edge = 0;
    for (std::uint32_t p = 0; p < polygons.size(); ++p) {
        for (std::size_t k = 0; k < polygons[p].size(); ++k, ++edge) {
            owner_[edge] = p;
            table.set(edge_ends::ax, edge, polygons[p][k]);
            table.set(edge_ends::bx, edge, next_corner(polygons[p], k));
        }
    }
    find_twins();
}

/// Two edges are twins where their ends are the same to the bit, and no third edge has them. Others only take more
/// time.
void ShadowEdges::find_twins() {
    const EdgeTable<const double> table{edges_.data(), rows_};
    const std::uint32_t edges = first_.back();
    twin_.resize(edges);
    twin_sense_.resize(edges);
    std::iota(twin_.begin(), twin_.end(), 0U);
    const Vector3d askew(1, 0.7548776662466927, 0.5698402909980532);  // few edges are abreast in this direction
    std::vector<std::pair<double, std::uint32_t>> by_middle;
    for (std::uint32_t k = 0; k < edges; ++k)
        by_middle.emplace_back(askew.dot(table.vector(edge_ends::ax, k) + table.vector(edge_ends::bx, k)), k);
    std::sort(by_middle.begin(), by_middle.end());
    const auto sense_of = [&](std::uint32_t one, std::uint32_t other) {
        const Vector3d a = table.vector(edge_ends::ax, one);
        const Vector3d b = table.vector(edge_ends::bx, one);
        const Vector3d other_a = table.vector(edge_ends::ax, other);
        const Vector3d other_b = table.vector(edge_ends::bx, other);
        return a == other_a && b == other_b ? Side{1} : a == other_b && b == other_a ? Side{-1} : Side{0};
    };
    for (auto begin = by_middle.begin(); begin != by_middle.end();) {
        const auto end =
            std::find_if(begin, by_middle.end(), [&](const auto& each) { return each.first != begin->first; });
        for (auto one = begin; one != end; ++one) {
            std::uint32_t same = 0;
            for (auto other = begin; other != end; ++other) {
                const Side sense = other == one ? Side{0} : sense_of(one->second, other->second);
                if (sense == 0) continue;
                ++same;
                twin_[one->second] = other->second;
                twin_sense_[one->second] = sense;
            }
            if (same > 1) twin_[one->second] = one->second;
        }
        begin = end;
    }
}

ShadowEdges::Sees ShadowEdges::find(const Vector3d& place, std::span<const Side> sides,
                                    std::span<const Vector3d> target, const Vector3d& target_normal,
                                    Scratch& scratch) const {
    FF_EXPECT(sides.size() == planes_.size());
    const double rounding = roundings_of_plane * rounding_;
    TargetVectors target_corners;
    TargetVectors target_sides;
    for (std::size_t k = 0; k < target.size(); ++k) {
        const Vector3d side = next_corner(target, k).cross(target[k]);
        target_corners.push_back({target[k], size_of(target[k])});
        target_sides.push_back({side, size_of(side)});
    }
    scratch.outline.clear();
    scratch.edges.resize(seen_edge::count * rows_, boost::container::default_init);
    const EdgeTable<double> seen{scratch.edges.data(), rows_};
    if (!std::equal(sides.begin(), sides.end(), scratch.sides.begin(), scratch.sides.end())) {
        scratch.sides.assign(sides.begin(), sides.end());
        for (std::size_t k = 0; k < rows_; ++k) seen(seen_edge::side, k) = k < first_.back() ? sides[owner_[k]] : 0;
    }
    see_edges({edges_.data(), rows_}, place, rounding, target_corners, target_sides, seen);
    const Sees sees = find_shadows(sides, scratch);
    if (sees != Sees::part) return sees;

    // The target has the highest rank.
    const auto target_rank = static_cast<std::uint32_t>(scratch.shadows.size());
    for (std::size_t k = 0; k < target.size(); ++k) {
        const double length = target_corners[k].length;
        const double next = next_corner(target_corners, k).length;
        scratch.candidates.push_back({static_cast<std::uint32_t>(scratch.cuts.size()), target_rank});
        scratch.cuts.push_back({target_sides[k].vector, target[k], next_corner(target, k), rounding * (length + next),
                                rounding * length * next});
    }
    scratch.ends.push_back(static_cast<std::uint32_t>(scratch.cuts.size()));
    if (outline(target, target_normal, scratch)) return scratch.outline.empty() ? Sees::nothing : Sees::part;
    scratch.outline.clear();
    return Sees::unclear;
}

/// Finds the shadows that hide a part of the target, with the edges that part it, and those that may be part of the
/// outline.
ShadowEdges::Sees ShadowEdges::find_shadows(std::span<const Side> sides, Scratch& scratch) const {
    const EdgeTable<const double> seen{scratch.edges.data(), rows_};
    auto& [outline, edges, same_sides, shadows, cuts, ends, candidates, rows] = scratch;
    shadows.clear();
    cuts.clear();
    ends.clear();
    candidates.clear();
    constexpr int both = reaches_inside + reaches_outside;
    const auto position_of = [&](std::uint32_t k) { return static_cast<int>(seen(seen_edge::position, k)); };
    for (std::uint32_t p = 0; p < planes_.size(); ++p) {
        if (sides[p] == 0 || first_[p] == first_[p + 1]) continue;
        int common = ~0;
        bool reaches_target = true;
        bool is_clear = true;
        for (std::uint32_t k = first_[p]; k < first_[p + 1]; ++k) {
            const int position = position_of(k);
            common &= position;
            reaches_target = reaches_target && (position & both) != reaches_outside;
            is_clear = is_clear && (position & both) != 0;
        }
        if (common >= first_beyond || !reaches_target) continue;
        const std::size_t before = cuts.size();
        for (std::uint32_t k = first_[p]; k < first_[p + 1]; ++k) {
            const int position = position_of(k);
            if ((position & both) != both) continue;
            const std::uint32_t next = k + 1 == first_[p + 1] ? first_[p] : k + 1;
            // Between two shadows that meet at an edge, on opposite sides of it, there is no outline.
            const Side twin_side = twin_[k] == k ? Side{0} : sides[owner_[twin_[k]]];
            const bool is_inner = twin_side != 0 && twin_side * twin_sense_[k] == -sides[p];
            const bool is_beyond = (position & position_of(next)) >= first_beyond;
            if (!is_inner && !is_beyond)
                candidates.push_back(
                    {static_cast<std::uint32_t>(cuts.size()), static_cast<std::uint32_t>(shadows.size())});
            cuts.push_back({seen.vector(seen_edge::nx, k), seen.vector(seen_edge::ax, k),
                            seen.vector(seen_edge::ax, next), seen(seen_edge::by_distance, k),
                            seen(seen_edge::fixed, k)});
        }
        if (cuts.size() == before) return is_clear ? Sees::nothing : Sees::unclear;
        shadows.push_back(p);
        ends.push_back(static_cast<std::uint32_t>(cuts.size()));
    }
    return shadows.empty() ? Sees::all : Sees::part;
}

/// Joins what is left of the edges that may be part of the outline. @return whether the outline is closed
bool ShadowEdges::outline(std::span<const Vector3d> target, const Vector3d& target_normal, Scratch& scratch) {
    const auto& candidates = scratch.candidates;
    const auto& cuts = scratch.cuts;
    const auto& ends = scratch.ends;
    const std::size_t rows = EdgeTable<double>::rows_for(candidates.size());
    scratch.candidate_rows.resize((outline_edge::count + 2 * ends.size()) * rows, boost::container::default_init);
    const EdgeTable<double> table{scratch.candidate_rows.data(), rows};
    for (std::size_t i = 0; i < rows; ++i) {
        const Scratch::Candidate& each = candidates[std::min(i, candidates.size() - 1)];
        const SeenEdge& edge = cuts[each.cut];
        table.set(outline_edge::ax, i, edge.a);
        table.set(outline_edge::bx, i, edge.b);
        table.set(outline_edge::nx, i, edge.normal);
        table(outline_edge::by_distance, i) = edge.by_distance;
        table(outline_edge::fixed, i) = edge.fixed;
        table(outline_edge::rank, i) = each.rank;
    }
    const EdgeTable<double> inside{table.at(outline_edge::count, 0), rows};
    cover_edges({table.data, rows}, {cuts.data(), cuts.size()}, {ends.data(), ends.size()}, inside);

    const std::size_t target_rank = scratch.shadows.size();
    const double height = target_normal.dot(target.front());
    const auto in_target = [&](const Vector3d& v) -> Vector3d { return v * (height / target_normal.dot(v)); };
    Vector3d open = Vector3d::Zero();
    double farthest = 0;
    for (const Vector3d& corner : target) farthest = std::max(farthest, size_of(corner));
    using Span = std::pair<double, double>;
    boost::container::small_vector<Span, 32> hidden;
    for (std::size_t i = 0; i < candidates.size(); ++i) {
        const auto span_inside = [&](std::size_t rank) {
            const auto column = static_cast<int>(2 * rank);
            return Span(inside(column, i), inside(column + 1, i));
        };
        const std::uint32_t own = candidates[i].rank;
        const Span all = own == target_rank ? Span(0, 1) : span_inside(target_rank);
        if (!(all.first < all.second)) continue;
        hidden.clear();
        for (std::size_t rank = 0; rank < target_rank; ++rank) {
            const Span span = span_inside(rank);
            if (rank != own && span.first < span.second) hidden.push_back(span);
        }
        std::sort(hidden.begin(), hidden.end());
        hidden.emplace_back(all.second, all.second);
        const SeenEdge& edge = cuts[candidates[i].cut];
        double from = all.first;
        for (const Span& span : hidden) {
            const double to = std::min(span.first, all.second);
            if (from < to) {
                Arc arc{edge.a + from * (edge.b - edge.a), edge.a + to * (edge.b - edge.a)};
                if (own == target_rank) {
                    open += arc.end - arc.begin;
                } else {
                    if (scratch.sides[scratch.shadows[own]] == front) std::swap(arc.begin, arc.end);
                    open += in_target(arc.end) - in_target(arc.begin);
                }
                scratch.outline.push_back(arc);
            }
            from = std::max(from, span.second);
        }
    }
    return size_of(open) <= open_outline * farthest;
}

}  // namespace ff
