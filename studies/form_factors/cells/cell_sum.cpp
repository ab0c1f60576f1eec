#include "studies/form_factors/cells/cell_sum.hpp"

#include "core/geometry/surface_map.hpp"
#include "core/visibility/visible_polygon.hpp"
#include "samplers/grids/gauss_legendre.hpp"
#include "studies/form_factors/cells/blocked_pair.hpp"
#include "studies/form_factors/cells/cell_shapes.hpp"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <numeric>
#include <span>

namespace ff::studies::form_factors {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

/// Evaluations that cells may take before any random ones, for each tolerance that the whole exchange area is large:
/// fewer than points would take. Of small ones they may take some anyway.
constexpr double evaluations_per_tolerance = 8;
constexpr double least_evaluations = 16384;
constexpr double least_evaluations_of_many = 512;  ///< where there are many pairs
constexpr double most_evaluations = 1 << 18;

/// Cells are halved until what is left at places between the nodes is so much of what is wanted, added up as
/// independent errors.
constexpr double left_of_wanted = 0.4;

/// In scenes of many pairs: where the most that is left of any cell, in all cells, is no more than this share of what
/// is wanted, one random place in a random cell stands for all cells in each randomisation.
constexpr double pooled_left = 0.1;

/// Places in the unit square between the nodes of every rule.
constexpr std::array<std::array<double, 2>, 4> between_nodes{{{0.2, 0.3}, {0.7, 0.2}, {0.8, 0.7}, {0.3, 0.8}}};

/// What is seen of the target from a place, and what is hidden of it.
enum Side : std::uint8_t { visible, hidden };
using Factors = std::array<double, 2>;

/// A surface and a polygon past polygons.
struct CellTask {
    const Surface& source;  ///< is integrated over: the smaller polygon, or what is round
    const Surface& target;
    const PairExchange& exchange;
    FacedEnd source_end;
    double most = 0;    ///< upper bound of it
    double wanted = 0;  ///< half width
    PointEffort effort = PointEffort::full;
    Stream stream;  ///< its random numbers; each randomisation is a trial of its own
};

/// The rule for an exchange area of so many tolerances.
const CellRule& rule_for(double tolerances) {
    static const std::array<CellRule, 4> rules{CellRule(2), CellRule(3), CellRule(4), CellRule(6)};
    return rules[tolerances < 10 ? 0 : tolerances < 1000 ? 1 : tolerances < 1e5 ? 2 : 3];
}

/// A cell with the factors at the nodes of a rule.
struct Cell {
    Quadrilateral shape;
    std::vector<Factors> at_nodes;  ///< those of one u together
    Factors integral{};
    Factors left{};  ///< what is left between the nodes, as an exchange area
};

class Cells {
  public:
    explicit Cells(const CellTask& task)
        : task_(task),
          target_(task_.target, task_.exchange.blockers, task_.source_end),
          tolerances_(task_.most / task_.wanted),
          rule_(rule_for(tolerances_)) {}

    std::optional<CellSum> run() {
        const double least = task_.effort == PointEffort::full ? least_evaluations : least_evaluations_of_many;
        const double allowed = std::clamp(evaluations_per_tolerance * tolerances_, least, most_evaluations);
        if (corners(task_.source.shape).empty()) {
            if (!task_.exchange.blockers.empty() || !divide_round_source(allowed)) return std::nullopt;
        } else {
            const BlockedPair pair(task_.source, task_.target, task_.exchange.blockers);
            if (pair.source.empty() || pair.target.empty()) return CellSum{};
            if (!divide_polygon(pair, allowed)) return std::nullopt;
        }
        while (!is_good_enough()) {
            if (static_cast<double>(evaluations_) > allowed) return std::nullopt;
            halve_worst();
        }
        return estimate();
    }

  private:
    CellTask task_;
    std::optional<RoundSource> round_;
    Vector3d origin_ = Vector3d::Zero();  ///< of the corners of cells
    VisiblePolygon target_;
    double tolerances_;  ///< that the whole exchange area is large, or may be
    const CellRule& rule_;
    std::vector<Cell> cells_;
    std::uint64_t evaluations_ = 0;
    Side side_ = visible;  ///< which is integrated
    std::vector<Vector2d> uvs_;
    std::vector<Vector3d> places_;
    std::vector<VisiblePolygon::Factors> seen_;
    std::vector<Factors> factors_;

    /// @return whether there are few enough parts
    bool divide_polygon(const BlockedPair& pair, double allowed) {
        origin_ = pair.origin;
        const auto of_cell = static_cast<double>(rule_.size() * rule_.size() + between_nodes.size() + randomisations);
        const std::vector<ConvexPolygon> parts = smooth_parts(pair, static_cast<std::size_t>(allowed / of_cell));
        for (const ConvexPolygon& part : parts) {
            for (std::size_t k = 1; k + 1 < part.size(); k += 2)
                add({{part[0], part[k], part[k + 1], part[k + 2 == part.size() ? 0 : k + 2]}});
        }
        return !parts.empty();
    }

    /// Cells that are small beside their distance from the target, or see so little of it that it does not matter.
    /// @return whether they are few enough
    bool divide_round_source(double allowed) {
        constexpr int sectors = 4;
        round_.emplace(task_.source);
        const auto [x, y] = std::pair(round_->size().x(), round_->size().y() / sectors);
        std::vector<Quadrilateral> waiting;
        for (int k = 0; k < sectors; ++k)
            waiting.push_back({{Vector3d(0, k * y, 0), {x, k * y, 0}, {x, (k + 1) * y, 0}, {0, (k + 1) * y, 0}}});
        while (!waiting.empty()) {
            const Quadrilateral shape = waiting.back();
            waiting.pop_back();
            if (static_cast<double>(evaluations_) > allowed) return false;
            if (sees_evenly(shape)) {
                add(shape);
            } else {
                for (const Quadrilateral& half : shape.halves()) waiting.push_back(half);
            }
        }
        return true;
    }

    /// Whether no peak of the factor can be overlooked by the nodes in a cell of a round source.
    [[nodiscard]] bool sees_evenly(const Quadrilateral& shape) const {
        constexpr double of_distance = 0.5;
        constexpr double little = 0.05;
        const ConvexPolygon polygon = outline(task_.target);
        const auto [middle, radius] = round_->ball_around(shape);
        const double near = std::max(0.0, distance(middle, polygon, task_.target.normal) - radius);
        if (2 * radius <= of_distance * near) return true;
        const double most = std::min(1.0, area(task_.target.shape) / (std::numbers::pi * near * near));
        return most * std::numbers::pi * radius * radius <= little * task_.wanted;
    }

    /// At places in a cell, given in its square; they live until the next call.
    std::span<const Factors> factors(const Quadrilateral& shape, std::span<const Vector2d> places) {
        evaluations_ += places.size();
        seen_.resize(places.size());
        if (round_) {
            for (std::size_t k = 0; k < places.size(); ++k) {
                const SurfacePoint place = round_->at(shape.at(places[k]));
                seen_[k] = target_.from(place.position, place.normal);
            }
        } else {
            places_.clear();
            for (const Vector2d& uv : places) places_.emplace_back(origin_ + shape.at(uv));
            target_.find(places_, task_.source.normal, seen_);
        }
        factors_.clear();
        for (const VisiblePolygon::Factors& seen : seen_) factors_.push_back({seen.visible, seen.whole - seen.visible});
        return factors_;
    }

    [[nodiscard]] Factors interpolated(const Cell& cell, const Vector2d& uv) const {
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

    /// Area of the source that a place in the square of a cell stands for.
    [[nodiscard]] double stretch(const Quadrilateral& shape, const Vector2d& uv) const {
        return shape.stretch(uv) * (round_ ? round_->stretch(shape.at(uv)) : 1);
    }

    /// What the interpolant leaves at a place, times the area that the place stands for.
    [[nodiscard]] Factors left_at(const Cell& cell, const Vector2d& uv, Factors found) const {
        const Factors smooth = interpolated(cell, uv);
        const double area = stretch(cell.shape, uv);
        for (const Side side : {visible, hidden}) found[side] = (found[side] - smooth[side]) * area;
        return found;
    }

    void add(const Quadrilateral& shape) {
        Cell& cell = cells_.emplace_back();
        cell.shape = shape;
        const auto& [nodes, weights] = rule_.gauss;
        const std::size_t size = nodes.size();
        uvs_.clear();
        for (const double u : nodes) {
            for (const double v : nodes) uvs_.emplace_back(u, v);
        }
        for (const auto& [u, v] : between_nodes) uvs_.emplace_back(u, v);
        const std::span<const Factors> found = factors(shape, uvs_);
        cell.at_nodes.assign(found.begin(), found.begin() + static_cast<std::ptrdiff_t>(size * size));
        for (std::size_t k = 0; k < size * size; ++k) {
            const double weight = weights[k / size] * weights[k % size] * stretch(shape, uvs_[k]);
            for (const Side side : {visible, hidden}) cell.integral[side] += weight * found[k][side];
        }
        for (std::size_t k = size * size; k < uvs_.size(); ++k) {
            const Factors left = left_at(cell, uvs_[k], found[k]);
            for (const Side side : {visible, hidden}) cell.left[side] = std::max(cell.left[side], std::abs(left[side]));
        }
    }

    /// Chooses the part of which less is left.
    bool is_good_enough() {
        Factors squares{};
        for (const Cell& cell : cells_) {
            for (const Side side : {visible, hidden}) squares[side] += cell.left[side] * cell.left[side];
        }
        side_ = task_.exchange.area && squares[hidden] < squares[visible] ? hidden : visible;
        return std::sqrt(squares[side_]) <= left_of_wanted * task_.wanted;
    }

    void halve_worst() {
        const auto worst = std::max_element(
            cells_.begin(), cells_.end(), [&](const Cell& a, const Cell& b) { return a.left[side_] < b.left[side_]; });
        const auto halves = worst->shape.halves();
        cells_.erase(worst);
        for (const Quadrilateral& half : halves) add(half);
    }

    /// Adds what is left at random places, each standing for so many cells. @return the largest that was met
    double add_left(std::uint32_t cell, double cells, std::span<const std::uint32_t> trials,
                    std::vector<double>& means) {
        uvs_.clear();
        for (const std::uint32_t r : trials) {
            Stream stream = task_.stream;
            stream.trial = r;
            const Words words = philox(stream, cell, Purpose::coordinates);
            uvs_.emplace_back((words[0] + 0.5) * 0x1p-32, (words[1] + 0.5) * 0x1p-32);
        }
        double most = cells_[cell].left[side_] * cells;
        const std::span<const Factors> found = factors(cells_[cell].shape, uvs_);
        for (std::size_t k = 0; k < trials.size(); ++k) {
            const double left = left_at(cells_[cell], uvs_[k], found[k])[side_] * cells;
            means[trials[k]] += left;
            most = std::max(most, std::abs(left));
        }
        return most;
    }

    /// One random cell of each randomisation stands for all of them. @return the largest that was met
    double add_left_of_some(std::vector<double>& means) {
        std::array<std::uint64_t, randomisations> cell{};
        for (std::uint32_t r = 0; r < randomisations; ++r) {
            Stream stream = task_.stream;
            stream.trial = r;
            cell[r] = (philox(stream, 0, Purpose::coordinates)[2] * std::uint64_t{cells_.size()}) >> 32;
        }
        double most = 0;
        std::vector<std::uint32_t> trials;
        for (std::uint32_t c = 0; c < cells_.size(); ++c) {
            trials.clear();
            for (std::uint32_t r = 0; r < randomisations; ++r) {
                if (cell[r] == c) trials.push_back(r);
            }
            most = std::max(most, add_left(c, static_cast<double>(cells_.size()), trials, means));
        }
        return most;
    }

    CellSum estimate() {
        SampledShare share;
        share.means.assign(randomisations, 0.0);
        double integral = 0;
        double largest = 0;
        for (const Cell& cell : cells_) {
            integral += cell.integral[side_];
            largest = std::max(largest, cell.left[side_]);
        }
        const auto count = static_cast<double>(cells_.size());
        double squares = 0;
        if (task_.effort == PointEffort::sized && count > 1 && count * largest <= pooled_left * task_.wanted) {
            const double most = add_left_of_some(share.means);
            squares = most * most;
        } else {
            std::vector<std::uint32_t> all(randomisations);
            std::iota(all.begin(), all.end(), 0U);
            for (std::uint32_t c = 0; c < cells_.size(); ++c) {
                const double most = add_left(c, 1, all, share.means);
                squares += most * most;
            }
        }
        // Where no point of a cell has been, no more is left than anywhere else in it.
        share.points = randomisations;
        share.unmet = {.rough = std::sqrt(squares)};
        CellSum result;
        const double sign = side_ == hidden ? -1 : 1;
        result.sum.offset = sign * integral + (side_ == hidden ? task_.exchange.area->value : 0);
        result.sum.offset_error = side_ == hidden ? task_.exchange.area->error : 0;
        result.sum.terms.push_back({sign, std::move(share)});
        result.evaluations = evaluations_;
        return result;
    }
};

}  // namespace

std::optional<CellSum> cell_sum(const Scene& scene, const FacePair& pair, PointEffort effort, double wanted,
                                StreamKey key) {
    CellSum result;
    result.sum.offset = pair.known;
    const double share = wanted / std::sqrt(static_cast<double>(pair.sampled.size()));
    for (const SampledPair& sampled : pair.sampled) {
        const Surface* source = &scene.surfaces[sampled.from];
        const Surface* target = &scene.surfaces[sampled.to];
        const bool has_smaller_target = area(target->shape) < area(source->shape);
        const auto is_round = [](const Surface* surface) { return corners(surface->shape).empty(); };
        if (is_round(target) || (!is_round(source) && has_smaller_target)) std::swap(source, target);
        if (is_round(target)) return std::nullopt;
        const FacedEnd source_end = source == &scene.surfaces[sampled.from] ? FacedEnd::from : FacedEnd::to;
        const std::optional<BoundedValue<double>>& whole = sampled.exchange.area;
        const double most = whole ? whole->value : std::min(area(source->shape), area(target->shape));
        const Stream stream{.key = key, .trial = 0, .source = sampled.from, .target = sampled.to + 1};
        auto found =
            Cells({*source, *target, sampled.exchange, source_end, most, share / sampled.times, effort, stream}).run();
        if (!found) return std::nullopt;
        result.evaluations += found->evaluations;
        result.sum.offset += sampled.times * found->sum.offset;
        result.sum.offset_error += sampled.times * found->sum.offset_error;
        for (SampledSum::Term& term : found->sum.terms) {
            term.scale *= sampled.times;
            result.sum.terms.push_back(std::move(term));
        }
    }
    return result;
}

}  // namespace ff::studies::form_factors
