#include "core/formulas/disc_exchange.hpp"

#include "core/formulas/circle_rule.hpp"
#include "core/geometry/scene.hpp"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

namespace ff {
namespace {

using circles::Circle;
using circles::Frame;
using circles::PeriodicRule;
using Eigen::Vector3d;

/// Nodes of one rule times nodes of the other.
constexpr std::size_t most_pairs_of_nodes = 1u << 22;

/// A flat surface and its rim, which is either straight or round.
struct Flat {
    Vector3d normal;
    Vector3d place;  ///< in its plane
    std::vector<DirectedEdge<double>> edges;
    std::vector<Circle> circles;

    Flat(const Surface& surface, const Frame& frame) : normal(surface.normal) {
        if (const auto* disc = std::get_if<Disc>(&surface.shape)) {
            place = frame.moved(disc->centre);
            circles.emplace_back(place, normal, disc->outer_radius / frame.unit, 1);
            if (disc->inner_radius > 0) circles.emplace_back(place, normal, disc->inner_radius / frame.unit, -1);
            return;
        }
        const std::vector<Vector3d> around = corners_of<double>(surface);
        place = frame.moved(around.front());
        for (std::size_t k = 0; k < around.size(); ++k)
            edges.push_back({frame.moved(around[k]), frame.moved(around[(k + 1) % around.size()])});
    }

    [[nodiscard]] double length_of_rim() const {
        double sum = 0;
        for (const auto& edge : edges) sum += (edge.end - edge.begin).norm();
        for (const Circle& circle : circles) sum += 2 * std::numbers::pi * circle.radius;
        return sum;
    }

    [[nodiscard]] bool is_in_front_of(const Flat& other) const {
        const auto height = [&](const Vector3d& at) { return other.normal.dot(at - other.place); };
        double least = std::numeric_limits<double>::infinity();
        for (const auto& edge : edges) least = std::min(least, height(edge.begin));
        for (const Circle& circle : circles) {
            const double swing = std::hypot(other.normal.dot(circle.u), other.normal.dot(circle.v));
            least = std::min(least, height(circle.centre) - swing);
        }
        return least >= -Frame::rounding;
    }
};

double distance_to_edge(const Vector3d& place, const DirectedEdge<double>& edge) {
    const Vector3d along = edge.end - edge.begin;
    const double share = std::clamp((place - edge.begin).dot(along) / along.squaredNorm(), 0.0, 1.0);
    return (place - edge.begin - share * along).norm();
}

/// Lower bound of the distance of a circle from the rim of another surface.
double distance_of_rims(const Circle& circle, const Flat& other) {
    constexpr int places = 256;
    double least = Frame::farthest;
    for (int k = 0; k < places; ++k) {
        const Vector3d place = circle.at(2 * std::numbers::pi * k / places);
        for (const auto& edge : other.edges) least = std::min(least, distance_to_edge(place, edge));
        for (const Circle& across : other.circles) least = std::min(least, across.distance_to(place));
    }
    return least - std::numbers::pi / places * circle.radius;
}

/// A sum, and that of the sizes of its terms, by which rounding grows.
struct RimIntegral {
    Vector3d value = Vector3d::Zero();
    double size = 0;

    void add(const Vector3d& term) {
        value += term;
        size += term.norm();
    }
};

/// The integral of ln r along a rim, where r is the distance from a place. @param rules  of the rim's circles
RimIntegral integral_from(const Vector3d& place, const Flat& other, const std::vector<PeriodicRule>& rules) {
    RimIntegral result;
    for (const auto& edge : other.edges)
        result.add((edge.end - edge.begin).normalized() * log_distance_integral(place, edge));
    for (std::size_t c = 0; c < other.circles.size(); ++c) {
        const Circle& circle = other.circles[c];
        RimIntegral sum;
        for (std::size_t k = 0; k < rules[c].nodes; ++k) {
            const double theta = rules[c].angle(k);
            sum.add(std::log((circle.at(theta) - place).squaredNorm()) / 2 * circle.along(theta));
        }
        const double weight = 2 * std::numbers::pi / static_cast<double>(rules[c].nodes);
        result.value += circle.sign * weight * sum.value;
        result.size += weight * sum.size;
    }
    return result;
}

/// The exchange area of what one circle of a disc encloses and a flat surface.
std::optional<BoundedValue<double>> circle_exchange(const Circle& circle, const Flat& other, double wanted) {
    const double distance = distance_of_rims(circle, other);
    if (!(distance > 0)) return std::nullopt;
    // In half of the strip places move by at most half the distance, so that |r^2| lies between distance^2 / 4 and
    // (farthest + distance / 2)^2, with a positive real part. A constant added to the logarithm changes nothing.
    const double logarithm = (std::log(2 * Frame::farthest / distance + 1) + std::numbers::pi / 2) / 2;
    const auto rule_on = [&](const Circle& along, double opposite) {
        const double size = (along.radius + distance / 2) * opposite * logarithm;
        return PeriodicRule(along.half_strip(distance), size, wanted / 8);
    };
    const PeriodicRule rule = rule_on(circle, other.length_of_rim());
    if (rule.has_too_many_nodes()) return std::nullopt;
    BoundedValue<double> result{0, rule.error};
    std::vector<PeriodicRule> rules;
    for (const Circle& across : other.circles) {
        rules.push_back(rule_on(across, 2 * std::numbers::pi * circle.radius));
        result.error += rules.back().error;
        if (rules.back().has_too_many_nodes() || rule.nodes * rules.back().nodes > most_pairs_of_nodes)
            return std::nullopt;
    }
    double sum = 0;
    double sizes = 0;
    for (std::size_t k = 0; k < rule.nodes; ++k) {
        const double theta = rule.angle(k);
        const RimIntegral across = integral_from(circle.at(theta), other, rules);
        sum += circle.along(theta).dot(across.value);
        sizes += circle.radius * across.size;
    }
    // 1 / (2 pi) times the integral over the angle is the mean.
    const auto nodes = static_cast<double>(rule.nodes);
    result.value = sum / nodes;
    result.error += 16 * std::numeric_limits<double>::epsilon() * sizes / nodes;
    return result;
}

}  // namespace

std::optional<BoundedValue<double>> disc_exchange_area(const Surface& from, const Surface& to, double wanted) {
    if (!is_flat(from.shape) || !is_flat(to.shape)) return std::nullopt;
    if (!std::holds_alternative<Disc>(from.shape))
        return std::holds_alternative<Disc>(to.shape) ? disc_exchange_area(to, from, wanted) : std::nullopt;
    const Frame frame(from, to);
    const Flat disc(from, frame);
    const Flat other(to, frame);
    if (!disc.is_in_front_of(other) || !other.is_in_front_of(disc)) return std::nullopt;
    BoundedValue<double> sum;
    for (const Circle& circle : disc.circles) {
        const auto enclosed = circle_exchange(circle, other, frame.reduced(wanted) / 2);
        if (!enclosed) return std::nullopt;
        sum.value += circle.sign * enclosed->value;
        sum.error += enclosed->error;
    }
    return frame.restored(sum);
}

}  // namespace ff
