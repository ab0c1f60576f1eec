#include "studies/form_factors/form_factors.hpp"

#include "core/geometry/joined_surfaces.hpp"
#include "core/geometry/placement.hpp"
#include "core/support/error.hpp"
#include "stats/error_rates/multiplicity.hpp"
#include "studies/form_factors/repair.hpp"
#include "studies/form_factors/rounds.hpp"
#include "studies/form_factors/row_sums.hpp"
#include "studies/form_factors/sample_pairs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

namespace ff::studies::form_factors {
namespace {

/// Rays are traced in single precision, and meet surfaces a little beside where they are.
constexpr double least_tolerance_of_rays = 1e-6;
/// The rounding of computations in double precision.
constexpr double least_tolerance = 1e-13;

void expect_sense(const Request& request) {
    if (!(request.tolerance >= least_tolerance && request.tolerance < 0.5)) {
        throw UserError(fmt::format("--tolerance {:g} (from {:g}, the rounding of double precision, to 0.5). Try 1e-5.",
                                    request.tolerance, least_tolerance));
    }
    if (!(request.relative >= 0 && request.relative < 1)) {
        throw UserError(
            fmt::format("--relative {:g} (a share of each factor, from 0 to below 1). Try 0.01.", request.relative));
    }
    if (!(request.drop >= 0 && request.drop < 1))
        throw UserError(fmt::format("--drop {:g} (a form factor, from 0 to below 1). Try 1e-6.", request.drop));
    if (!(request.level > 0.5 && request.level <= 1 - 1e-9)) {
        throw UserError(fmt::format("--level {:g} (above 0.5, at most 1 - 1e-9). Try 0.95.", request.level));
    }
}

void expect_possible(const Scene& scene, const FacePairs& geometry, const Request& request) {
    const bool needs_rays =
        std::any_of(geometry.pairs.begin(), geometry.pairs.end(), [](const FacePair& pair) { return !pair.by_points; });
    if (needs_rays && request.tolerance < least_tolerance_of_rays) {
        throw UserError(
            fmt::format("--tolerance {:g}: some pairs of scene '{}' have to be sampled by rays (which are "
                        "traced in single precision: {:g} is the least). Take a larger one.",
                        request.tolerance, scene.name, least_tolerance_of_rays));
    }
}

/// Clips an interval to what geometry allows, and the value to the interval.
void clip(FaceExchange& exchange, double least, double most) {
    exchange.clipped = exchange.value < least || exchange.value > most;
    exchange.low = std::clamp(exchange.low, least, most);
    exchange.high = std::clamp(exchange.high, least, most);
    exchange.value = std::clamp(exchange.value, exchange.low, exchange.high);
}

/// @param smaller  area of the smaller face
FaceExchange face_exchange(const KnownPair& pair, double smaller) {
    FaceExchange result;
    result.from = pair.from;
    result.to = pair.to;
    result.method = pair.method;
    result.reason = pair.reason;
    result.value = pair.value;
    result.low = pair.value - pair.bound;
    result.high = pair.value + pair.bound;
    clip(result, 0, smaller);
    return result;
}

FaceExchange face_exchange(const FacePair& pair, const PairEstimate& estimate) {
    FaceExchange result;
    result.from = pair.from;
    result.to = pair.to;
    result.reason = pair.reason;
    const double least = std::max(0.0, pair.known - pair.bound - pair.resolution);
    const double most = std::max(least, pair.most + pair.resolution);
    if (!estimate.sum) {
        // Nothing but geometry: it was stopped before the first round was over.
        result.low = least;
        result.high = pair.most;
        result.value = (result.low + result.high) / 2;
    } else {
        const EstimatedSum found = estimate_of(*estimate.sum, estimate.level);
        result.value = found.value;
        result.low = found.value - found.down - pair.bound - pair.resolution;
        result.high = found.value + found.up + pair.bound + pair.resolution;
        result.method = estimate.method;
        result.by_rays_of_row = pair.by_points && estimate.method == ExchangeMethod::rays;
        result.samples = estimate.samples;
        result.contradicted = estimate.contradicted;
        if (estimate.contradicted) {
            result.low = std::min(result.low, estimate.other.value - estimate.other.down);
            result.high = std::max(result.high, estimate.other.value + estimate.other.up);
        }
    }
    clip(result, least, most);
    return result;
}

/// Level of a row's interval at which some row of a closed scene is said not to add up to 1, though it does, in 0.001
/// of runs.
double alarm_level(std::size_t faces) {
    return 1 - 1e-3 / static_cast<double>(faces);
}

/// What is known of a row's sum apart from its sampled part, in form factors.
struct KnownSum {
    double value = 0;    ///< clipped estimates of all pairs
    double sampled = 0;  ///< of those of RowSums
    double down = 0;
    double up = 0;
};

/// A row's sum: independent randomisations add up, bounds do.
RowSum row_sum(const Matrix& matrix, const RowSums& sums, const KnownSum& known, std::size_t row, double level,
               double farthest) {
    const auto ends = [&](double at) {
        const EstimatedSum found = sums.at(row, at);
        const double value = known.value - known.sampled + found.value;
        return std::pair(value - found.down - known.down, value + found.up + known.up);
    };
    const auto [low, high] = ends(level);
    const auto [least, most] = ends(alarm_level(matrix.faces()));
    // Coordinates in the file are rounded, and with them the edges of the row's face.
    const double rounding =
        std::max(1e-12, 16 * std::numeric_limits<double>::epsilon() * farthest / std::sqrt(matrix.areas[row]));
    // No true sum is above 1; where the interval is, the scene is not what it should be, and the interval is shown.
    const double end = low > 1 + rounding ? high : std::min(1.0, high);
    return {known.value, std::min(known.value, std::max(0.0, low)), std::max(known.value, end),
            least > 1 + rounding || most < 1 - rounding};
}

/// Drops the pairs that are known to exchange little, now that they have been sampled.
void drop(Matrix& matrix, std::vector<DroppedExchange> dropped, double below) {
    std::erase_if(matrix.exchanges, [&](const FaceExchange& exchange) {
        if (exchange.from == exchange.to ||
            exchange.high >= below * std::min(matrix.areas[exchange.from], matrix.areas[exchange.to]))
            return false;
        add_dropped(dropped, exchange.from, exchange.to, exchange.value, exchange.low, exchange.high);
        return true;
    });
    for (std::size_t face = 0; face < matrix.faces(); ++face) {
        const auto& [pairs, value, low, high] = dropped[face];
        const double area = matrix.areas[face];
        matrix.rows[face].dropped = {pairs, value / area, low / area, high / area};
        matrix.dropped += pairs;
    }
    // No face of pairs that are dropped sees itself: a factor to itself that is that small is kept.
    matrix.dropped /= 2;
}

/// Scales areas from the unit of the computation to that of the scene.
void scale_areas(Matrix& matrix, double unit) {
    for (double& area : matrix.areas) area *= unit;
    for (FaceExchange& exchange : matrix.exchanges) {
        for (double* value : {&exchange.value, &exchange.low, &exchange.high}) *value *= unit;
    }
}

/// Whether an entry is as accurate as requested.
bool is_within(const Matrix& matrix, const FaceExchange& exchange, const Request& request) {
    const double factor = exchange.value / std::min(matrix.areas[exchange.from], matrix.areas[exchange.to]);
    return !exchange.contradicted &&
           worst_half_width(matrix, exchange) <=
               std::max(request.tolerance_between(exchange.from, exchange.to), request.relative * factor);
}

/// Puts the exchanges and sums of a matrix together, as estimates come in.
class MatrixBuilder {
  public:
    MatrixBuilder(Matrix& matrix, const FacePairs& geometry, const Request& request, double alpha)
        : matrix_(matrix),
          geometry_(geometry),
          request_(request),
          levels_{round_level(alpha, 0), round_level(alpha, 1)},
          sums_(geometry.areas, {levels_[0], levels_[1], alarm_level(geometry.faces())}),
          row_levels_(geometry.faces(), levels_[0]) {
        auto known = geometry.known.begin();
        const auto add_known_before = [&](std::uint32_t from, std::uint32_t to) {
            for (; known != geometry.known.end() && std::pair(known->from, known->to) < std::pair(from, to); ++known)
                matrix_.exchanges.push_back(
                    face_exchange(*known, std::min(matrix.areas[known->from], matrix.areas[known->to])));
        };
        matrix_.exchanges.reserve(geometry.known.size() + geometry.pairs.size());
        for (const FacePair& pair : geometry.pairs) {
            add_known_before(pair.from, pair.to);
            places_.push_back(static_cast<std::uint32_t>(matrix_.exchanges.size()));
            matrix_.exchanges.push_back(face_exchange(pair, {}));
        }
        constexpr auto end = std::numeric_limits<std::uint32_t>::max();
        add_known_before(end, end);
        is_summed_.assign(geometry.pairs.size(), false);
    }

    /// @param p  place in FacePairs::pairs
    void take(std::size_t p, const PairEstimate& estimate) {
        const FacePair& pair = geometry_.pairs[p];
        matrix_.exchanges[places_[p]] = face_exchange(pair, estimate);
        if (!estimate.sum || estimate.contradicted) return;
        is_summed_[p] = true;
        for_both(pair, [&](std::size_t face) {
            sums_.add(face, estimate);
            row_levels_[face] = std::max(row_levels_[face], estimate.level);
        });
    }

    /// When all have been taken that are going to be.
    void end(double farthest) {
        std::vector<KnownSum> rows(matrix_.faces());
        for (std::size_t face = 0; face < rows.size(); ++face) {
            const DroppedExchange& before = geometry_.dropped[face];
            add(rows[face], before.value, before.low, before.high, matrix_.areas[face]);
        }
        std::size_t p = 0;
        for (std::size_t e = 0; e < matrix_.exchanges.size(); ++e) {
            FaceExchange& exchange = matrix_.exchanges[e];
            exchange.within = is_within(matrix_, exchange, request_);
            const FacePair* pair = p < places_.size() && places_[p] == e ? &geometry_.pairs[p++] : nullptr;
            const bool is_summed = pair != nullptr && is_summed_[p - 1];
            for_both(exchange, [&](std::size_t face) {
                const double area = matrix_.areas[face];
                if (!is_summed) return add(rows[face], exchange.value, exchange.low, exchange.high, area);
                rows[face].value += exchange.value / area;
                rows[face].sampled += exchange.value / area;
                rows[face].down += (pair->bound + pair->resolution) / area;
                rows[face].up += (pair->bound + pair->resolution) / area;
            });
        }
        for (std::size_t face = 0; face < rows.size(); ++face)
            matrix_.rows.push_back(row_sum(matrix_, sums_, rows[face], face, row_levels_[face], farthest));
    }

  private:
    Matrix& matrix_;
    const FacePairs& geometry_;
    const Request& request_;
    std::array<double, 2> levels_;  ///< of a pair's interval after the first round, and after a later one
    RowSums sums_;
    std::vector<double> row_levels_;     ///< the highest of a row's entries
    std::vector<std::uint32_t> places_;  ///< of sampled pairs among the exchanges
    std::vector<bool> is_summed_;        ///< sampled pairs that are in `sums_`

    template <class Pair, class Use>
    static void for_both(const Pair& pair, const Use& use) {
        use(pair.from);
        if (pair.from != pair.to) use(pair.to);
    }
    static void add(KnownSum& row, double value, double low, double high, double area) {
        row.value += value / area;
        row.down += (value - low) / area;
        row.up += (high - value) / area;
    }
};

}  // namespace

FaceExchange no_exchange(std::size_t from, std::size_t to) {
    FaceExchange nothing;
    nothing.from = static_cast<std::uint32_t>(from);
    nothing.to = static_cast<std::uint32_t>(to);
    nothing.method = ExchangeMethod::none;
    nothing.within = true;
    return nothing;
}

double half_width(const FaceExchange& exchange) {
    return std::max(exchange.high - exchange.value, exchange.value - exchange.low);
}

FaceExchange Matrix::exchange(std::size_t a, std::size_t b) const {
    const auto [from, to] = std::minmax(a, b);
    const auto place = [](const FaceExchange& exchange) {
        return std::pair<std::size_t, std::size_t>(exchange.from, exchange.to);
    };
    const auto wanted = std::pair(from, to);
    const auto found = std::lower_bound(exchanges.begin(), exchanges.end(), wanted,
                                        [&](const FaceExchange& e, const auto& p) { return place(e) < p; });
    return found != exchanges.end() && place(*found) == wanted ? *found : no_exchange(from, to);
}

namespace {

/// A matrix with a value for both directions of each exchange that is listed. @param value  of an exchange area
template <class Value>
Matrix::Sparse both_ways(const Matrix& matrix, Value value) {
    std::vector<Eigen::Triplet<double>> entries;
    for (const FaceExchange& exchange : matrix.exchanges) {
        const auto i = static_cast<int>(exchange.from);
        const auto j = static_cast<int>(exchange.to);
        entries.emplace_back(i, j, value(exchange) / matrix.areas[exchange.from]);
        if (i != j) entries.emplace_back(j, i, value(exchange) / matrix.areas[exchange.to]);
    }
    const auto n = static_cast<Eigen::Index>(matrix.faces());
    Matrix::Sparse result(n, n);
    result.setFromTriplets(entries.begin(), entries.end());
    return result;
}

}  // namespace

Matrix::Sparse Matrix::factors() const {
    return both_ways(*this, [](const FaceExchange& exchange) { return exchange.value; });
}

Matrix::Sparse Matrix::half_widths() const {
    return both_ways(*this, &half_width);
}

std::size_t Matrix::missed() const {
    return static_cast<std::size_t>(std::count_if(exchanges.begin(), exchanges.end(),
                                                  [](const FaceExchange& exchange) { return !exchange.within; }));
}

bool is_trusted(const Scene& scene, const Matrix& matrix, double tolerance) {
    if (!matrix.faults.empty()) return false;
    if (!scene.closed && !scene.empty_box) return true;
    return !leaks(matrix, tolerance) &&
           std::none_of(matrix.rows.begin(), matrix.rows.end(), [](const RowSum& row) { return row.excludes_one; });
}

bool leaks(const Matrix& matrix, double tolerance) {
    constexpr double share_of_tolerance = 0.01;
    return static_cast<double>(matrix.lost_rays) > share_of_tolerance * tolerance * static_cast<double>(matrix.rays);
}

double worst_half_width(const Matrix& matrix, const FaceExchange& exchange) {
    return half_width(exchange) / std::min(matrix.areas[exchange.from], matrix.areas[exchange.to]);
}

Matrix find_matrix(const Scene& whole_scene, const Request& request) {
    expect_sense(request);
    if (request.repair) expect_repairable(whole_scene);
    const Placement placement = placement_of(whole_scene);
    const Scene scene = with_joined_surfaces(placed(whole_scene, placement));
    Matrix matrix;
    matrix.surfaces = scene.surfaces.size();
    FacePairs examined = examine_pairs(scene, request);
    allow_for_rounding(rounding_of_far_coordinates(whole_scene, placement) / placement.unit, scene, examined);
    const FacePairs geometry = std::move(examined);
    matrix.areas = geometry.areas;
    matrix.interrupted = request.stop != nullptr && *request.stop;
    if (!matrix.interrupted) expect_possible(scene, geometry, request);
    const std::size_t sampled = geometry.pairs.size();
    const double alpha = request.level_of == LevelOf::entry || sampled == 0
                             ? 1 - request.level
                             : stats::bonferroni_level(1 - request.level, sampled + matrix.faces());
    matrix.entry_level = 1 - alpha;

    MatrixBuilder builder(matrix, geometry, request, alpha);
    if (sampled > 0 && !matrix.interrupted) {
        const SamplingOutcome outcome =
            sample_pairs(scene, geometry, request, alpha, request.tolerance >= least_tolerance_of_rays,
                         [&](std::size_t pair, const PairEstimate& estimate) { builder.take(pair, estimate); });
        matrix.samples = outcome.samples;
        matrix.rays = outcome.rays;
        matrix.lost_rays = outcome.lost;
        matrix.interrupted = outcome.interrupted;
        matrix.left_out = outcome.left_out;
    }
    builder.end(farthest_coordinate(whole_scene) / placement.unit);
    if (request.drop > 0) drop(matrix, geometry.dropped, request.drop);
    scale_areas(matrix, placement.unit * placement.unit);
    if (request.repair) matrix.repaired = repair(matrix);
    return matrix;
}

}  // namespace ff::studies::form_factors
