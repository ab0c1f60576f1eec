#include "studies/form_factors/form_factors.hpp"

#include "core/geometry/joined_surfaces.hpp"
#include "core/geometry/placement.hpp"
#include "core/support/error.hpp"
#include "stats/error_rates/multiplicity.hpp"
#include "studies/form_factors/repair.hpp"
#include "studies/form_factors/rounds.hpp"
#include "studies/form_factors/sample_pairs.hpp"

#include <fmt/format.h>

#include <algorithm>
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

/// Rate at which some row of a closed scene is said not to add up to 1, though it does.
constexpr double false_alarm_of_rows = 1e-3;

/// The terms of a row's sum: those that are sampled, and by how much the others may be off at most.
struct RowTerms {
    SampledSum sum;
    double value = 0;  ///< clipped estimates
    double down = 0;
    double up = 0;
    double level = 0;  ///< the highest of its entries

    void add_known(double area, double low, double high) {
        value += area;
        sum.offset += area;
        down += area - low;
        up += high - area;
    }
    void add(const FaceExchange& exchange) { add_known(exchange.value, exchange.low, exchange.high); }
    void add(const FaceExchange& exchange, const FacePair& pair, const PairEstimate& estimate) {
        if (!estimate.sum || estimate.contradicted) return add(exchange);
        value += exchange.value;
        level = std::max(level, estimate.level);
        sum.offset += estimate.sum->offset;
        sum.offset_error += estimate.sum->offset_error;
        sum.terms.insert(sum.terms.end(), estimate.sum->terms.begin(), estimate.sum->terms.end());
        down += pair.bound + pair.resolution;
        up += pair.bound + pair.resolution;
    }
};

/// A row's sum: independent randomisations add up, bounds do.
RowSum row_sum(const Matrix& matrix, const RowTerms& terms, std::size_t row, double level, double farthest) {
    const double area = matrix.areas[row];
    const auto ends = [&](double at) {
        const EstimatedSum found = estimate_of(terms.sum, at);
        return std::pair((found.value - found.down - terms.down) / area, (found.value + found.up + terms.up) / area);
    };
    const auto [low, high] = ends(std::max(level, terms.level));
    const auto [least, most] = ends(1 - false_alarm_of_rows / static_cast<double>(matrix.faces()));
    // Coordinates in the file are rounded, and with them the edges of the row's face.
    const double rounding = std::max(1e-12, 16 * std::numeric_limits<double>::epsilon() * farthest / std::sqrt(area));
    const double value = terms.value / area;
    // No true sum is above 1; where the interval is, the scene is not what it should be, and the interval is shown.
    const double end = low > 1 + rounding ? high : std::min(1.0, high);
    return {value, std::min(value, std::max(0.0, low)), std::max(value, end),
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

/// All pairs of faces in order.
void add_exchanges(Matrix& matrix, const FacePairs& geometry, const std::vector<PairEstimate>& estimates,
                   const Request& request) {
    matrix.exchanges.reserve(geometry.known.size() + geometry.pairs.size());
    const auto add = [&](FaceExchange exchange) {
        exchange.within = is_within(matrix, exchange, request);
        matrix.exchanges.push_back(exchange);
    };
    auto known = geometry.known.begin();
    const auto add_known_before = [&](std::uint32_t from, std::uint32_t to) {
        for (; known != geometry.known.end() && std::pair(known->from, known->to) < std::pair(from, to); ++known)
            add(face_exchange(*known, std::min(matrix.areas[known->from], matrix.areas[known->to])));
    };
    for (std::size_t p = 0; p < geometry.pairs.size(); ++p) {
        add_known_before(geometry.pairs[p].from, geometry.pairs[p].to);
        add(face_exchange(geometry.pairs[p], estimates[p]));
    }
    constexpr auto end = std::numeric_limits<std::uint32_t>::max();
    add_known_before(end, end);
}

void add_rows(Matrix& matrix, const FacePairs& geometry, const std::vector<PairEstimate>& estimates, double level,
              double farthest) {
    std::vector<RowTerms> rows(matrix.faces());
    for (std::size_t row = 0; row < matrix.faces(); ++row)
        rows[row].add_known(geometry.dropped[row].value, geometry.dropped[row].low, geometry.dropped[row].high);
    std::vector<std::uint32_t> sampled;  // places of the pairs that are
    for (std::uint32_t e = 0; e < matrix.exchanges.size(); ++e) {
        const FaceExchange& exchange = matrix.exchanges[e];
        const std::size_t p = sampled.size();
        if (p < geometry.pairs.size() && geometry.pairs[p].from == exchange.from &&
            geometry.pairs[p].to == exchange.to) {
            sampled.push_back(e);
            continue;
        }
        rows[exchange.from].add(exchange);
        if (exchange.from != exchange.to) rows[exchange.to].add(exchange);
    }
    const auto pairs_of_rows = by_face(geometry.pairs, matrix.faces());
    for (std::size_t row = 0; row < matrix.faces(); ++row) {
        RowTerms terms = std::move(rows[row]);
        for (const std::uint32_t p : pairs_of_rows[row])
            terms.add(matrix.exchanges[sampled[p]], geometry.pairs[p], estimates[p]);
        matrix.rows.push_back(row_sum(matrix, terms, row, level, farthest));
    }
}

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

    std::vector<PairEstimate> estimates(sampled);
    if (sampled > 0 && !matrix.interrupted) {
        SamplingOutcome outcome =
            sample_pairs(scene, geometry, request, alpha, request.tolerance >= least_tolerance_of_rays);
        estimates = std::move(outcome.estimates);
        matrix.samples = outcome.samples;
        matrix.rays = outcome.rays;
        matrix.lost_rays = outcome.lost;
        matrix.interrupted = outcome.interrupted;
        matrix.left_out = outcome.left_out;
    }
    add_exchanges(matrix, geometry, estimates, request);
    add_rows(matrix, geometry, estimates, round_level(alpha, 0), farthest_coordinate(whole_scene) / placement.unit);
    if (request.drop > 0) drop(matrix, geometry.dropped, request.drop);
    scale_areas(matrix, placement.unit * placement.unit);
    if (request.repair) matrix.repaired = repair(matrix);
    return matrix;
}

}  // namespace ff::studies::form_factors
