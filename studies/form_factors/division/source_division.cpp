#include "studies/form_factors/division/source_division.hpp"

#include "studies/form_factors/division/rims.hpp"
#include "studies/form_factors/division/source_part.hpp"

#include "core/formulas/polygon_exchange.hpp"
#include "core/geometry/shaft.hpp"
#include "core/geometry/surface_map.hpp"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace ff::studies::form_factors {
namespace {

using Eigen::Vector3d;

/// Points in all that a tolerance of so much of the source is worth; fewer are never taken.
constexpr double least_points = 4096;
constexpr double at_tolerance = 2e-4;
/// Points in all that an exchange area of so many tolerances is worth; of small ones it takes fewer.
constexpr double points_per_tolerance = 4;
constexpr double least_points_of_small = 64;
constexpr double most_points_in_all = 0x1p24;

/// If none of n points meets a set of places, the upper Clopper-Pearson bound on the share of that set is about this
/// over n.
constexpr double unmet_points = 3.7;

/// Shares of what matters. Parts are divided until what points may miss in a smooth cell is fine, and until what they
/// may miss in all others together is within what is wanted, where that takes no longer than one test of a shaft for so
/// many points. What is left of cells that are not even smooth enough gets points of its own.
constexpr double fine_share = 0.05;
constexpr double smooth_share = 0.25;
constexpr double wanted_share = 0.1;
constexpr double points_per_test = 4;
constexpr double least_tests = 1024;
constexpr double tests_per_point = 0.1875;  ///< instead, where points are sized by what can pass
constexpr std::size_t most_cells = 4096;

/// Points for cells that are not smooth, beside those on the whole source.
constexpr double most_rough = 0.25;

/// A part of the source that is to have points, and what is known of it.
struct Part {
    SourceCell cell;
    double weight = 0;  ///< what points could miss in it
    double unmet = 0;   ///< the same, as an exchange area at the expected number of points
    std::uint32_t node = 0;
    bool s_longer = true;  ///< it is longer along s than along t
};

/// What a part of the source sees of the target.
enum class Sight : std::uint8_t { all, nothing, unknown, differs_within };

/// A polygon that something is known of.
struct Plate {
    ConvexPolygon corners;
    Vector3d normal;  ///< twice as long as the area is large
    double area = 0;

    explicit Plate(ConvexPolygon polygon)
        : corners(std::move(polygon)), normal(twice_area(corners)), area(normal.norm() / 2) {}
};

/// Points that are expected in all.
double points_for(double area, const std::optional<BoundedValue<double>>& whole, double wanted) {
    const double points = std::clamp(least_points * at_tolerance * area / wanted, least_points, most_points_in_all);
    return whole ? std::min(points, std::max(points_per_tolerance * whole->value / wanted, least_points_of_small))
                 : points;
}

class Division {
  public:
    Division(const Surface& source, const Surface& target, const std::vector<Blocker>& blockers,
             const std::optional<BoundedValue<double>>& whole, double wanted)
        : source_(source),
          map_(source),
          is_polygon_(!corners(source.shape).empty()),
          area_(ff::area(source.shape)),
          origin_(middle(source)),
          wanted_(wanted),
          points_(points_for(area_, whole, wanted)),
          tests_left_(
              static_cast<std::size_t>(whole ? tests_per_point * points_ : least_tests + points_ / points_per_test)),
          target_(in_front(moved(target))) {
        if (target_.corners.empty()) return;
        target_normal_ = target.normal;
        for (const Blocker& blocker : blockers) blockers_.emplace_back(relevant(moved(*blocker.surface)));
        rims_.emplace(source_, target_.corners);
        for (const Plate& blocker : blockers_) rims_->add_blocker(blocker.corners);
    }

    SourceCells run() {
        SourceCells result;
        result.curved = !is_polygon_;
        result.due = due();
        if (target_.corners.empty()) return result;
        add(whole_source());
        while (!parts_.empty() && is_worth_dividing()) halve_heaviest();
        std::sort(parts_.begin(), parts_.end(), [](const Part& a, const Part& b) { return a.node < b.node; });
        for (const Part& part : parts_) {
            nodes_[part.node].cell = static_cast<std::int32_t>(result.mixed.size());
            result.mixed.push_back(part.cell);
        }
        if (is_polygon_) add_up_exchange(result);
        result.nodes = std::move(nodes_);
        share_points(result);
        return result;
    }

  private:
    static bool is_lighter(const Part& a, const Part& b) {
        return a.weight != b.weight ? a.weight < b.weight : a.node < b.node;
    }

    const Surface& source_;
    SurfaceMap map_;
    bool is_polygon_;
    double area_;
    Vector3d origin_;
    double wanted_;
    double points_;
    std::size_t tests_left_;
    Plate target_;
    Vector3d target_normal_;
    std::vector<Plate> blockers_;
    std::optional<Rims> rims_;
    std::vector<Part> parts_;  ///< a heap, the heaviest first
    std::vector<SourceCells::Node> nodes_ = std::vector<SourceCells::Node>(1);
    std::vector<Sight> sight_ = {Sight::all};  ///< what each node sees of the target
    double weight_ = 0;

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
        ConvexPolygon result = clipped(in_front(polygon), target_normal_, target_normal_.dot(target_.corners.front()));
        for (Eigen::Index axis = 0; axis < 3; ++axis) {
            const Vector3d along = Vector3d::Unit(axis);
            const Extent own = extent(source_, along);
            double low = own.low - origin_[axis];
            double high = own.high - origin_[axis];
            for (const Vector3d& corner : target_.corners) {
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
            if (!blockers_[b].corners.empty()) part.cell.blockers.push_back(b);
        }
        return part;
    }

    /// An upper bound of the factor to a plate from any place of the part.
    [[nodiscard]] double most_from(const PartExtent& part, const Plate& plate) const {
        double height = is_flat(source_.shape) ? 0 : HUGE_VAL;
        for (const Vector3d& corner : plate.corners)
            height = std::max(height, source_.normal.dot(corner - part.centre));
        return ball_factor(plate.area, distance(part.centre, plate.corners, plate.normal) - part.radius, height);
    }

    /// Adds up how much factors can change and how much can be hidden.
    void find_bounds(Part& part, const PartExtent& extent) const {
        SourceCell& cell = part.cell;
        cell.most_whole = most_from(extent, target_);
        double hidden = 0;
        for (const std::uint32_t b : cell.blockers) hidden += most_from(extent, blockers_[b]);
        const double slope = rims_->slope(extent, cell.blockers);
        cell.most_hidden = std::min(cell.most_whole, hidden);
        cell.change = 2 * extent.turn + (slope < HUGE_VAL ? slope * extent.size : HUGE_VAL);
        const double most = is_polygon_ ? cell.most_hidden : cell.most_whole;
        const double share = cell.area / area_;
        part.unmet = smooth_unmet(cell, share, !is_polygon_) * std::pow(due(), power_of_unmet(!is_polygon_));
        part.weight = part.unmet <= fine_share * wanted_
                          ? 0
                          : std::min(cell.area * std::min(most, cell.change), part.unmet * share / due());
    }

    /// Share of the points that a set of places may be due and still be met by none.
    [[nodiscard]] double due() const { return unmet_points / points_; }

    /// Finds out about a part, and keeps it if it is to have points.
    void add(Part part) {
        SourceCell& cell = part.cell;
        cell.area = area_ * (cell.range.s1 - cell.range.s0) * (cell.range.t1 - cell.range.t0);
        const PartExtent extent = extent_of(source_, map_, origin_, cell.range);
        part.s_longer = extent.s_longer;
        Shaft shaft(extent.hull, target_.corners);
        Sight& sight = sight_[part.node];
        std::vector<std::uint32_t> left;
        for (const std::uint32_t b : cell.blockers) {
            tests_left_ -= tests_left_ > 0 ? 1 : 0;
            const ff::Plate blocker(blockers_[b].corners);
            const Shaft::Crossing crossing = shaft.crossed_by(blocker);
            if (crossing == Shaft::Crossing::none) continue;
            if (is_polygon_ && crossing == Shaft::Crossing::all) {
                sight = Sight::nothing;
                return;
            }
            if (!shaft.is_beside(blocker)) left.push_back(b);
        }
        cell.blockers = std::move(left);
        sight = is_polygon_ && cell.blockers.empty() ? Sight::all : Sight::unknown;
        if (sight == Sight::all) return;
        find_bounds(part, extent);
        weight_ += part.weight;
        parts_.push_back(std::move(part));
        std::push_heap(parts_.begin(), parts_.end(), is_lighter);
    }

    [[nodiscard]] bool is_worth_dividing() const {
        return due() * weight_ > most_rough * wanted_share * wanted_ && tests_left_ > 0 && parts_.size() < most_cells &&
               parts_.front().weight > 0;
    }

    void halve_heaviest() {
        std::pop_heap(parts_.begin(), parts_.end(), is_lighter);
        const Part part = std::move(parts_.back());
        parts_.pop_back();
        weight_ -= part.weight;
        const auto halves = static_cast<std::uint32_t>(nodes_.size());
        nodes_[part.node] = {part.s_longer, -1, halves};
        nodes_.resize(nodes_.size() + 2);
        sight_.resize(nodes_.size());
        for (const bool upper : {false, true}) {
            Part half;
            half.node = halves + (upper ? 1 : 0);
            half.cell.range = part.cell.range.half(part.s_longer, upper);
            half.cell.blockers = part.cell.blockers;
            add(std::move(half));
        }
    }

    /// Adds up what parts of the source would exchange with nothing in between, for the parts that see nothing of the
    /// target and for those with points. Parts of one kind that make up a larger part are taken as one.
    void add_up_exchange(SourceCells& cells) {
        for (std::size_t n = nodes_.size(); n-- > 0;) {
            const std::uint32_t half = nodes_[n].halves;
            if (half != 0) sight_[n] = sight_[half] == sight_[half + 1] ? sight_[half] : Sight::differs_within;
        }
        std::vector<std::pair<std::uint32_t, SourceRange>> left = {{0, {}}};
        while (!left.empty()) {
            const auto [n, range] = left.back();
            left.pop_back();
            const SourceCells::Node& node = nodes_[n];
            if (sight_[n] == Sight::differs_within) {
                for (const bool upper : {false, true})
                    left.emplace_back(node.halves + (upper ? 1 : 0), range.half(node.along_s, upper));
            } else if (sight_[n] != Sight::all) {
                BoundedValue<double>& sum = sight_[n] == Sight::nothing ? cells.umbra : cells.open;
                const BoundedValue<double> exchange = exchange_of(range);
                sum.value += exchange.value;
                sum.error += exchange.error;
            }
        }
    }

    /// The exchange of a part of the source with the target, with nothing in between.
    [[nodiscard]] BoundedValue<double> exchange_of(const SourceRange& range) const {
        Corners<double> from = extent_of(source_, map_, origin_, range).hull;
        turn_around(from, source_.normal);
        Corners<double> to = target_.corners;
        turn_around(to, target_normal_);
        return polygon_exchange_area<double>(std::move(from), std::move(to));
    }

    /// In whole steps of the points' coordinates, so that shares are exact.
    void share_points(SourceCells& cells) const {
        const auto weight_of = [&](const Part& part) { return part.unmet > smooth_share * wanted_ ? part.weight : 0; };
        double weight = 0;
        for (const Part& part : parts_) weight += weight_of(part);
        if (weight > 0) cells.extra = most_rough;
        double sum = 0;
        double before = 0;
        for (std::size_t c = 0; c < parts_.size(); ++c) {
            SourceCell& cell = cells.mixed[c];
            if (weight > 0) sum += weight_of(parts_[c]) / weight;
            const double end = std::min(1.0, std::round(sum * 0x1p32) * 0x1p-32);
            cell.first = before;
            cell.extra = end - before;
            cell.share = cell.area / area_ + cells.extra * cell.extra;
            before = end;
        }
    }
};

}  // namespace

SourceCells divide(const Surface& source, const Surface& target, const std::vector<Blocker>& blockers,
                   const std::optional<BoundedValue<double>>& whole, double wanted) {
    return Division(source, target, blockers, whole, wanted).run();
}

}  // namespace ff::studies::form_factors
