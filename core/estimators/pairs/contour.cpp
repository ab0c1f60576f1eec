#include "core/estimators/pairs/contour.hpp"

#include "core/estimators/pairs/patch_pairs.hpp"
#include "core/formulas/polygon_exchange.hpp"
#include "core/support/logarithm.hpp"
#include "core/visibility/facing.hpp"

#include <fmt/format.h>
#include <Eigen/Geometry>
#include <boost/math/quadrature/gauss_kronrod.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

namespace ff {
namespace {

using Eigen::Vector3d;

constexpr std::uint64_t edges_of_rim = 4;
using Rim = std::array<DirectedEdge<double>, edges_of_rim>;

/// The rim of a patch, counter-clockwise as seen from the side that it radiates to.
Rim rim(const PatchView& patch) {
    const std::array<Vector3d, edges_of_rim> corners = counter_clockwise(patch);
    Rim edges;
    for (std::size_t k = 0; k < edges_of_rim; ++k) edges[k] = {corners[k], corners[(k + 1) % edges_of_rim]};
    return edges;
}

std::string refusal_by_rims(const EstimatorInfo& info, const Scene& scene) {
    if (is_convex(scene)) return {};
    return refused(info, scene, "some of its surfaces lie behind the plane of another", "\"solid_angle\"");
}

/// Two edges whose distances count.
struct EdgePair {
    Vector3d from, along_from;
    Vector3d to, along_to;
    double product = 0;
};

/// What is known about two rims before any point is drawn: pairs of edges to sample, and the sum over those that
/// coincide.
struct RimPair {
    std::vector<EdgePair> sampled;
    double exact = 0;
    /// Square of the unit of length: a constant drops out of the sum over closed rims, but not out of its variance.
    double squared_unit = 1;
};

RimPair pair_up(const PatchPair& pair) {
    const Rim to = rim(pair.to);
    RimPair rims;
    rims.squared_unit = (pair.from.at(0.5, 0.5).position - pair.to.at(0.5, 0.5).position).squaredNorm();
    for (const auto& a : rim(pair.from)) {
        const Vector3d along_a = a.end - a.begin;
        for (const auto& b : to) {
            const Vector3d along_b = b.end - b.begin;
            const double product = along_a.dot(along_b);
            if (product == 0) continue;
            const double size = along_a.norm();
            const double apart = (a.begin - b.begin - along_b).norm() + (a.begin + along_a - b.begin).norm();
            if (apart > 1e-12 * size) {
                rims.sampled.push_back({a.begin, along_a, b.begin, along_b, product});
            } else {  // the mean of ln(size * |s - t|)
                rims.exact += product * (0.5 * logarithm(size * size / rims.squared_unit) - 1.5);
            }
        }
    }
    return rims;
}

double sum_over(const RimPair& rims, double s, double t) {
    double sum = rims.exact;
    for (const EdgePair& pair : rims.sampled) {
        const double squared = (pair.to + t * pair.along_to - pair.from - s * pair.along_from).squaredNorm();
        if (squared > 0) sum += 0.5 * pair.product * logarithm(squared / rims.squared_unit);
    }
    return sum;
}

using Kronrod = boost::math::quadrature::gauss_kronrod<double, 15>;
using Gauss = boost::math::quadrature::gauss<double, 7>;

constexpr std::uint64_t nodes = 15;

/// A part of an edge of the source, from one share of its length to another.
struct Panel {
    std::size_t edge = 0;
    double low = 0;
    double high = 1;
    double value = 0;
    double claim = 0;  ///< estimated error of the value, from the two rules
};

bool claims_less(const Panel& a, const Panel& b) {
    return a.claim < b.claim;
}

/// The contour integral between two patches.
class ContourIntegral {
  public:
    explicit ContourIntegral(const PatchPair& pair) : from_(rim(pair.from)), to_(rim(pair.to)) {
        for (std::size_t edge = 0; edge < edges_of_rim; ++edge) panels_.push_back(integrate(edge, 0, 1));
        std::make_heap(panels_.begin(), panels_.end(), claims_less);
    }

    /// Replaces the panel that claims most by its halves.
    void halve() {
        std::pop_heap(panels_.begin(), panels_.end(), claims_less);
        const Panel worst = panels_.back();
        panels_.pop_back();
        const double middle = (worst.low + worst.high) / 2;
        for (const auto& [low, high] : {std::pair(worst.low, middle), std::pair(middle, worst.high)}) {
            panels_.push_back(integrate(worst.edge, low, high));
            std::push_heap(panels_.begin(), panels_.end(), claims_less);
        }
    }

    [[nodiscard]] BoundedValue<double> sum() const {
        BoundedValue<double> sum;
        for (const Panel& panel : panels_) {
            sum.value += panel.value;
            sum.error += panel.claim;
        }
        return sum;
    }

  private:
    /// The integral over the rim of the target, from a place on an edge of the source; times the edge's length.
    [[nodiscard]] double inner(std::size_t edge, double share) const {
        const Vector3d along = from_[edge].end - from_[edge].begin;
        const Vector3d place = from_[edge].begin + share * along;
        double sum = 0;
        for (const DirectedEdge<double>& other : to_) {
            const Vector3d across = other.end - other.begin;
            const double length = across.norm();
            if (length > 0) sum += along.dot(across) / length * log_distance_integral(place, other);
        }
        return sum;
    }

    [[nodiscard]] Panel integrate(std::size_t edge, double low, double high) const {
        const double middle = (low + high) / 2;
        const double half = (high - low) / 2;
        double kronrod = 0;
        double gauss = 0;
        double size = 0;
        for (std::size_t k = 0; k < Kronrod::abscissa().size(); ++k) {
            const double x = half * Kronrod::abscissa()[k];
            const double left = inner(edge, middle - x);
            const double right = k == 0 ? 0 : inner(edge, middle + x);
            kronrod += Kronrod::weights()[k] * (left + right);
            size += Kronrod::weights()[k] * (std::abs(left) + std::abs(right));
            if (k % 2 == 0) gauss += Gauss::weights()[k / 2] * (left + right);
        }
        // No sum is more exact than its terms. @see [piessens1983]
        const double rounding = 50 * std::numeric_limits<double>::epsilon() * size;
        return {edge, low, high, half * kronrod, half * std::max(std::abs(kronrod - gauss), rounding)};
    }

    Rim from_;
    Rim to_;
    std::vector<Panel> panels_;  ///< a heap, the one that claims most first
};

}  // namespace

std::string Contour::refusal(const EstimatorOptions& /*options*/, const Scene& scene) {
    return refusal_by_rims(info, scene);
}

void Contour::observe(const EstimatorTask& task, Outcome& outcome, PatchTotals& /*totals*/) const {
    outcome.estimates =
        average_over_pairs(scene(), task, info.dimension, [](const PatchPair& pair, const WeightedBlock& block) {
            const RimPair rims = pair_up(pair);
            double sum = 0;
            for (std::size_t i = 0; i < block.size; ++i)
                sum += block.weight[i] * sum_over(rims, block.coordinate[0][i], block.coordinate[1][i]);
            return sum / (2 * std::numbers::pi * pair.from.area);
        });
}

std::string AdaptiveContour::refusal(const EstimatorOptions& /*options*/, const Scene& scene) {
    return refusal_by_rims(info, scene);
}

std::string AdaptiveContour::size_problem(std::uint64_t samples) {
    constexpr std::uint64_t least = edges_of_rim * nodes;
    constexpr std::uint64_t step = 2 * nodes;
    if (samples >= least && (samples - least) % step == 0) return {};
    const std::uint64_t below = samples < least ? 0 : samples - (samples - least) % step;
    const std::string others = below == 0 ? fmt::format("{}", least) : fmt::format("{} or {}", below, below + step);
    return fmt::format("(it takes {} evaluations for four edges, and {} for each halving). Try {}.", least, step,
                       others);
}

void AdaptiveContour::observe(const EstimatorTask& task, Outcome& outcome, PatchTotals& /*totals*/) const {
    const std::uint64_t halvings = (task.samples - edges_of_rim * nodes) / (2 * nodes);
    const auto averages = average_pair_values(
        scene(), task, [&](const PatchPair& pair, const Stream& /*stream*/) -> BoundedValue<double> {
            ContourIntegral integral(pair);
            for (std::uint64_t i = 0; i < halvings; ++i) integral.halve();
            const auto [value, error] = integral.sum();
            const double unit = 2 * std::numbers::pi * pair.from.area;
            return {value / unit, error / unit};
        });
    outcome.estimates = averages.factors;
    outcome.claims = averages.claims;
}

}  // namespace ff
