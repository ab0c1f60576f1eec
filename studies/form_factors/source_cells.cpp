#include "studies/form_factors/source_cells.hpp"

#include "studies/form_factors/source_part.hpp"

#include "core/formulas/polygon_exchange.hpp"
#include "core/geometry/shaft.hpp"
#include "core/geometry/surface_map.hpp"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <queue>

namespace ff::studies {
namespace {

using Eigen::Vector3d;

/// Points in all that a tolerance of so much of the source is worth; fewer are never taken.
constexpr double least_points = 4096;
constexpr double at_tolerance = 2e-4;
/// Points in all that an exchange area of so many tolerances is worth; of small ones it takes fewer.
constexpr double points_per_tolerance = 4;
constexpr double least_points_of_small = 64;
constexpr double most_points = 0x1p24;

/// Of none of n points, Clopper and Pearson's upper bound is about this over n.
constexpr double unmet_points = 3.7;

/// Shares of what matters. Parts are divided until what points may miss in a smooth cell is fine, and until what they
/// may miss in all others together is within what is wanted, where that takes no longer than one test of a shaft for so
/// many points. What is left of cells that are not even smooth enough gets points of its own.
constexpr double fine_share = 0.05;
constexpr double smooth_share = 0.25;
constexpr double wanted_share = 0.1;
constexpr double points_per_test = 4;
constexpr double least_tests = 6144;
constexpr double tests_per_point = 0.1875;  ///< instead, where points are sized by what can pass
constexpr std::size_t most_cells = 4096;

/// Points for cells that are not smooth, beside those on the whole source.
constexpr double most_rough = 0.25;

/// A part of the source and what is known of it.
struct Part {
    SourceCell cell;
    PartExtent extent;
    double weight = 0;  ///< what points could miss in it
    double unmet = 0;   ///< the same, as an exchange area at the expected number of points
    std::uint32_t node = 0;
};

/// By the theorem of Brunn and Minkowski: docs/statistics.md.
double power(bool curved) {
    return curved ? 1.25 : 1.5;
}

/// What places of a cell may hold that are due a share p of all points, of which the cell has `share`, over p^power.
double smooth_unmet(const SourceCell& cell, double share, bool curved) {
    return cell.area * cell.change * (curved ? 8.0 / 15 : 1.0 / 3) / std::pow(share, power(curved));
}

class Division {
  public:
    Division(const Surface& source, const Surface& target, const std::vector<const Surface*>& blockers,
             const std::optional<BoundedValue<double>>& whole, double wanted)
        : source_(source), is_polygon_(!corners(source.shape).empty()), origin_(middle(source)), wanted_(wanted) {
        const double area = ff::area(source.shape);
        points_ = std::clamp(least_points * at_tolerance * area / wanted, least_points, most_points);
        tests_left_ = static_cast<std::size_t>(least_tests + points_ / points_per_test);
        if (whole) {
            points_ = std::min(points_, std::max(points_per_tolerance * whole->value / wanted, least_points_of_small));
            tests_left_ = static_cast<std::size_t>(tests_per_point * points_);
        }
        target_ = in_front(moved(target));
        if (target_.empty()) return;
        target_normal_ = target.normal;
        for (std::uint32_t b = 0; b < blockers.size(); ++b) blockers_.push_back(relevant(moved(*blockers[b])));
        for (const ConvexPolygon& blocker : blockers_) add_rim(blocker);
        add_rim(target_);
    }

    SourceCells run() {
        SourceCells result;
        result.curved = !is_polygon_;
        result.due = due();
        if (target_.empty()) return result;
        add(whole_source());
        while (!parts_.empty() && is_worth_dividing()) halve_heaviest();
        result.umbra = umbra_;
        std::vector<Part> parts;
        for (; !parts_.empty(); parts_.pop()) parts.push_back(parts_.top());
        std::sort(parts.begin(), parts.end(), [](const Part& a, const Part& b) { return a.node < b.node; });
        for (const Part& part : parts) {
            if (is_polygon_) add_exchange(part, result.open);
            nodes_[part.node].cell = static_cast<std::int32_t>(result.mixed.size());
            result.mixed.push_back(part.cell);
        }
        result.nodes = nodes_;
        share_points(parts, result);
        return result;
    }

  private:
    struct Lighter {
        bool operator()(const Part& a, const Part& b) const {
            return a.weight != b.weight ? a.weight < b.weight : a.node < b.node;
        }
    };

    const Surface& source_;
    bool is_polygon_;
    Vector3d origin_;
    double wanted_;
    double points_ = 0;
    std::size_t tests_left_ = 0;
    ConvexPolygon target_;
    Vector3d target_normal_;
    std::vector<ConvexPolygon> blockers_;
    std::vector<Edge> edges_;                       ///< of blockers and target
    std::vector<std::vector<std::uint32_t>> rims_;  ///< of each blocker, then of the target
    std::priority_queue<Part, std::vector<Part>, Lighter> parts_;
    std::vector<SourceCells::Node> nodes_ = std::vector<SourceCells::Node>(1);
    double weight_ = 0;
    BoundedValue<double> umbra_;

    [[nodiscard]] ConvexPolygon moved(const Surface& surface) const {
        ConvexPolygon result = corners(surface.shape);
        for (Vector3d& corner : result) corner -= origin_;
        return result;
    }

    /// What lies below the horizon of a flat source neither sends nor hides anything.
    [[nodiscard]] ConvexPolygon in_front(const ConvexPolygon& polygon) const {
        return is_flat(source_.shape) ? clipped(polygon, source_.normal,
                                                extent(source_, source_.normal).high - source_.normal.dot(origin_))
                                      : polygon;
    }

    /// The part of a blocker that can stand between: before the target, and in the box around it and the source.
    [[nodiscard]] ConvexPolygon relevant(const ConvexPolygon& polygon) const {
        ConvexPolygon result = clipped(in_front(polygon), target_normal_, target_normal_.dot(target_.front()));
        for (Eigen::Index axis = 0; axis < 3; ++axis) {
            const Vector3d along = Vector3d::Unit(axis);
            const Extent own = extent(source_, along);
            double low = own.low - origin_[axis];
            double high = own.high - origin_[axis];
            for (const Vector3d& corner : target_) {
                low = std::min(low, corner[axis]);
                high = std::max(high, corner[axis]);
            }
            result = clipped(clipped(result, along, low), -along, -high);
        }
        return result;
    }

    Part whole_source() {
        Part part;
        for (std::uint32_t b = 0; b < blockers_.size(); ++b) {
            if (!blockers_[b].empty()) part.cell.blockers.push_back(b);
        }
        return part;
    }

    /// Edges that two bodies share count once.
    void add_rim(const ConvexPolygon& polygon) {
        std::vector<std::uint32_t> rim;
        for (std::size_t k = 0; k < polygon.size(); ++k) {
            const Edge edge{polygon[k], polygon[k + 1 == polygon.size() ? 0 : k + 1]};
            const double room = 1e-12 * (edge.b - edge.a).norm();
            const auto is_near = [&](const Vector3d& x, const Vector3d& y) { return (x - y).norm() <= room; };
            const auto same = std::find_if(edges_.begin(), edges_.end(), [&](const Edge& other) {
                return (is_near(edge.a, other.a) && is_near(edge.b, other.b)) ||
                       (is_near(edge.a, other.b) && is_near(edge.b, other.a));
            });
            rim.push_back(static_cast<std::uint32_t>(same - edges_.begin()));
            if (same == edges_.end()) edges_.push_back(edge);
        }
        rims_.push_back(std::move(rim));
    }

    /// Adds up how much factors can change and how much can be hidden.
    void find_bounds(Part& part) const {
        SourceCell& cell = part.cell;
        const auto height = [&](const ConvexPolygon& polygon) {
            if (!is_flat(source_.shape)) return HUGE_VAL;
            double most = 0;
            for (const Vector3d& corner : polygon)
                most = std::max(most, source_.normal.dot(corner - part.extent.centre));
            return most;
        };
        const double to_target = distance(part.extent.centre, target_) - part.extent.radius;
        cell.most_whole = ball_factor(ff::area(target_), to_target, height(target_));
        double hidden = 0;
        std::vector<std::uint32_t> edges = rims_.back();
        for (const std::uint32_t b : cell.blockers) {
            const double away = distance(part.extent.centre, blockers_[b]) - part.extent.radius;
            hidden += ball_factor(ff::area(blockers_[b]), away, height(blockers_[b]));
            edges.insert(edges.end(), rims_[b].begin(), rims_[b].end());
        }
        std::sort(edges.begin(), edges.end());
        edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
        double slope = 0;
        for (const std::uint32_t edge : edges) slope += slope_of(source_, part.extent, edges_[edge]);
        cell.most_hidden = std::min(cell.most_whole, hidden);
        cell.change = 2 * part.extent.turn + (slope < HUGE_VAL ? slope * part.extent.size : HUGE_VAL);
        const double most = is_polygon_ ? cell.most_hidden : cell.most_whole;
        const double share = cell.area / ff::area(source_.shape);
        const double unmet = smooth_unmet(cell, share, !is_polygon_) * std::pow(due(), power(!is_polygon_));
        part.unmet = unmet;
        part.weight = unmet <= fine_share * wanted_
                          ? 0
                          : std::min(cell.area * std::min(most, cell.change), unmet * share / due());
    }

    /// Share of the points that a set of places may be due and still be met by none.
    [[nodiscard]] double due() const { return unmet_points / points_; }

    /// Finds out about a part, and keeps it if it is to have points.
    void add(Part part) {
        SourceCell& cell = part.cell;
        cell.area = ff::area(source_.shape) * (cell.s1 - cell.s0) * (cell.t1 - cell.t0);
        part.extent = extent_of(source_, origin_, cell);
        const Shaft shaft(part.extent.hull, target_);
        std::vector<std::uint32_t> left;
        for (const std::uint32_t b : cell.blockers) {
            tests_left_ -= tests_left_ > 0 ? 1 : 0;
            if (shaft.keeps_clear_of(blockers_[b])) continue;
            if (is_polygon_ && shaft.is_closed_by(blockers_[b])) {
                add_exchange(part, umbra_);
                return;
            }
            left.push_back(b);
        }
        cell.blockers = std::move(left);
        if (is_polygon_ && cell.blockers.empty()) return;
        find_bounds(part);
        weight_ += part.weight;
        parts_.push(std::move(part));
    }

    [[nodiscard]] bool is_worth_dividing() const {
        return due() * weight_ > most_rough * wanted_share * wanted_ && tests_left_ > 0 && parts_.size() < most_cells &&
               parts_.top().weight > 0;
    }

    void halve_heaviest() {
        Part part = parts_.top();
        parts_.pop();
        weight_ -= part.weight;
        const auto halves = static_cast<std::uint32_t>(nodes_.size());
        nodes_[part.node] = {part.extent.s_longer, -1, halves};
        nodes_.resize(nodes_.size() + 2);
        for (const bool upper : {false, true}) {
            Part half = part;
            SourceCell& cell = half.cell;
            half.node = halves + (upper ? 1 : 0);
            double& low = part.extent.s_longer ? cell.s0 : cell.t0;
            double& high = part.extent.s_longer ? cell.s1 : cell.t1;
            (upper ? low : high) = (low + high) / 2;
            add(std::move(half));
        }
    }

    /// With nothing in between.
    void add_exchange(const Part& part, BoundedValue<double>& sum) const {
        Corners<double> from(part.extent.hull.begin(), part.extent.hull.end());
        const Vector3d across = (from[1] - from[0]).cross(from[2] - from[1]);
        if (across.dot(source_.normal) < 0) std::reverse(from.begin(), from.end());
        Corners<double> to(target_.begin(), target_.end());
        const Vector3d facing = (to[1] - to[0]).cross(to[2] - to[0]);
        if (facing.dot(target_normal_) < 0) std::reverse(to.begin(), to.end());
        const BoundedValue<double> exchange = polygon_exchange_area<double>(from, to);
        sum.value += exchange.value;
        sum.error += exchange.error;
    }

    /// In whole steps of the points' coordinates, so that shares are exact.
    void share_points(const std::vector<Part>& parts, SourceCells& cells) const {
        const auto weight_of = [&](const Part& part) { return part.unmet > smooth_share * wanted_ ? part.weight : 0; };
        double weight = 0;
        for (const Part& part : parts) weight += weight_of(part);
        if (weight > 0) cells.extra = most_rough;
        const double area = ff::area(source_.shape);
        double sum = 0;
        double before = 0;
        for (std::size_t c = 0; c < parts.size(); ++c) {
            SourceCell& cell = cells.mixed[c];
            if (weight > 0) sum += weight_of(parts[c]) / weight;
            const double end = std::min(1.0, std::round(sum * 0x1p32) * 0x1p-32);
            cell.first = before;
            cell.extra = end - before;
            cell.share = cell.area / area + cells.extra * cell.extra;
            before = end;
        }
    }
};

}  // namespace

SourceCells divide(const Surface& source, const Surface& target, const std::vector<const Surface*>& blockers,
                   const std::optional<BoundedValue<double>>& whole, double wanted) {
    return Division(source, target, blockers, whole, wanted).run();
}

const SourceCell* SourceCells::at(double s, double t) const {
    double s0 = 0, s1 = 1, t0 = 0, t1 = 1;
    std::uint32_t node = 0;
    while (nodes[node].halves != 0) {
        double& low = nodes[node].along_s ? s0 : t0;
        double& high = nodes[node].along_s ? s1 : t1;
        const double middle = (low + high) / 2;
        const bool upper = (nodes[node].along_s ? s : t) >= middle;
        (upper ? low : high) = middle;
        node = nodes[node].halves + (upper ? 1 : 0);
    }
    return nodes[node].cell < 0 ? nullptr : &mixed[static_cast<std::size_t>(nodes[node].cell)];
}

Unmet unmet(const SourceCells& cells, bool hidden) {
    Unmet result{.rough = 0, .smooth = 0, .power = power(cells.curved)};
    for (const SourceCell& cell : cells.mixed) {
        const double most = cell.area / cell.share * std::min(cell.change, hidden ? cell.most_hidden : cell.most_whole);
        const double smooth = smooth_unmet(cell, cell.share, cells.curved);
        if (smooth * std::pow(cells.due, result.power - 1) < most)
            result.smooth = std::max(result.smooth, smooth);
        else
            result.rough = std::max(result.rough, most);
    }
    return result;
}

}  // namespace ff::studies
