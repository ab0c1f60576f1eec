#include "studies/form_factors/form_factors.hpp"

#include "core/geometry/joined_surfaces.hpp"
#include "core/geometry/placement.hpp"
#include "core/support/error.hpp"
#include "core/visibility/mirrors.hpp"
#include "stats/error_rates/multiplicity.hpp"
#include "studies/form_factors/amendments.hpp"
#include "studies/form_factors/closure.hpp"
#include "studies/form_factors/matrix_builder.hpp"
#include "studies/form_factors/sample_pairs.hpp"

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
        throw UserError("--tolerance {:g} (from {:g}, the rounding of double precision, to 0.5). Try 1e-5.",
                        request.tolerance, least_tolerance);
    }
    if (!(request.relative >= 0 && request.relative < 1)) {
        throw UserError("--relative {:g} (a share of each factor, from 0 to below 1). Try 0.01.", request.relative);
    }
    if (!(request.drop >= 0 && request.drop < 1))
        throw UserError("--drop {:g} (a form factor, from 0 to below 1). Try 1e-6.", request.drop);
    if (!(request.level > 0.5 && request.level <= 1 - 1e-9)) {
        throw UserError("--level {:g} (above 0.5, at most 1 - 1e-9). Try 0.95.", request.level);
    }
}

void expect_possible(const Scene& scene, const FacePairs& geometry, const Request& request) {
    const bool needs_rays =
        request.cells ? !std::ranges::all_of(geometry.pairs, &FacePair::by_cells) : !geometry.pairs.empty();
    if (needs_rays && request.tolerance < least_tolerance_of_rays) {
        throw UserError(
            "--tolerance {:g}: some pairs of scene '{}' have to be sampled by rays (which are "
            "traced in single precision: {:g} is the least). Take a larger one.",
            request.tolerance, scene.name, least_tolerance_of_rays);
    }
}

/// Drops the pairs that are known to exchange little, now that they have been sampled.
void drop(Matrix& matrix, std::vector<DroppedExchange> dropped, double below) {
    std::erase_if(matrix.exchanges, [&](const FaceExchange& exchange) {
        if (exchange.from == exchange.to || exchange.high >= below * matrix.smaller_area(exchange)) return false;
        add_dropped(dropped, exchange.from, exchange.to, exchange.value, exchange.low, exchange.high);
        return true;
    });
    for (std::size_t face = 0; face < matrix.faces(); ++face) {
        const auto& [pairs, value, low, high] = dropped[face];
        const double area = matrix.areas[face];
        matrix.rows[face].dropped = {pairs, value / area, low / area, high / area};
        matrix.dropped += pairs;
    }
    // Only pairs of different faces are dropped: a factor of a face to itself is kept, however small.
    matrix.dropped /= 2;
}

/// Scales areas from the unit of the computation to that of the scene.
void scale_areas(Matrix& matrix, double unit) {
    for (double& area : matrix.areas) area *= unit;
    for (FaceExchange& exchange : matrix.exchanges) {
        for (double* value : {&exchange.value, &exchange.low, &exchange.high}) *value *= unit;
    }
}

}  // namespace

FaceExchange no_exchange(std::size_t from, std::size_t to) {
    return {.from = static_cast<std::uint32_t>(from),
            .to = static_cast<std::uint32_t>(to),
            .method = ExchangeMethod::none,
            .within = true};
}

double half_width(const FaceExchange& exchange) {
    return std::max(exchange.high - exchange.value, exchange.value - exchange.low);
}

namespace {

constexpr std::string_view no_time = "no time to sample it";
/// Reasons in the words of files of earlier versions.
constexpr std::array earlier_reasons{
    std::pair{"aligned rectangles with nothing in between", ExchangeReason::aligned},
    std::pair{"polygons with nothing in between", ExchangeReason::polygons},
    std::pair{"polygons far apart with nothing in between", ExchangeReason::far},
    std::pair{"less than the tolerance, whatever stands in between", ExchangeReason::small},
    std::pair{"polygons, something may stand in between", ExchangeReason::blocked},
    std::pair{"much may stand in between", ExchangeReason::many_blockers},
    std::pair{"with a disc or a sphere, nothing in between", ExchangeReason::round},
    std::pair{"round surfaces about one axis with nothing in between", ExchangeReason::coaxial},
    std::pair{"disc or sphere, and a flat surface, with nothing in between", ExchangeReason::round},
    std::pair{"the rays of its row do as well", ExchangeReason::blocked},  // pairs that cells serve now
};

}  // namespace

std::string_view method_of(const FaceExchange& exchange) {
    return name(exchange.method.value_or(ExchangeMethod::bounds));
}

std::string_view reason_of(const FaceExchange& exchange) {
    return exchange.method ? in_words(exchange.reason) : no_time;
}

bool set_method(FaceExchange& exchange, std::string_view method, std::string_view reason) {
    exchange.method.reset();
    if (reason == no_time) return method == name(ExchangeMethod::bounds);
    const auto earlier = std::ranges::find(earlier_reasons, reason, &std::pair<const char*, ExchangeReason>::first);
    if (earlier != earlier_reasons.end()) reason = in_words(earlier->second);
    const auto known_method = std::find(exchange_methods.begin(), exchange_methods.end(), method);
    const auto known_reason = std::find(exchange_reasons.begin(), exchange_reasons.end(), reason);
    if (known_method == exchange_methods.end() || known_reason == exchange_reasons.end()) return false;
    exchange.method = static_cast<ExchangeMethod>(known_method - exchange_methods.begin());
    exchange.reason = static_cast<ExchangeReason>(known_reason - exchange_reasons.begin());
    return true;
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
    const auto n = static_cast<Eigen::Index>(matrix.faces());
    Eigen::VectorXi sizes = Eigen::VectorXi::Zero(n);
    for (const FaceExchange& exchange : matrix.exchanges) {
        ++sizes[exchange.from];
        if (exchange.from != exchange.to) ++sizes[exchange.to];
    }
    Matrix::Sparse result(n, n);
    result.reserve(sizes);
    // Exchanges are in order, so that every row gets its columns in order.
    for (const FaceExchange& exchange : matrix.exchanges) {
        const auto i = static_cast<Eigen::Index>(exchange.from);
        const auto j = static_cast<Eigen::Index>(exchange.to);
        result.insert(i, j) = value(exchange) / matrix.areas[exchange.from];
        if (i != j) result.insert(j, i) = value(exchange) / matrix.areas[exchange.to];
    }
    result.makeCompressed();
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
    return static_cast<std::size_t>(std::ranges::count(exchanges, false, &FaceExchange::within));
}

bool rows_add_up(const Scene& scene) {
    return scene.closed &&
           std::ranges::all_of(scene.surfaces, [](const Surface& surface) { return is_of_face(surface); });
}

bool is_trusted(const Scene& scene, const Matrix& matrix, double tolerance) {
    if (!matrix.faults.empty()) return false;
    return !scene.closed || (!leaks(matrix, tolerance) && std::ranges::none_of(matrix.rows, &RowSum::excludes_one));
}

bool leaks(const Matrix& matrix, double tolerance) {
    return static_cast<double>(matrix.lost_rays) > tolerance * static_cast<double>(matrix.rays);
}

bool is_within(const Matrix& matrix, const FaceExchange& exchange, const Request& request) {
    const double factor = exchange.value / matrix.smaller_area(exchange);
    return !exchange.contradicted &&
           worst_half_width(matrix, exchange) <=
               std::max(request.tolerance_between(exchange.from, exchange.to), request.relative * factor);
}

double worst_half_width(const Matrix& matrix, const FaceExchange& exchange) {
    return half_width(exchange) / matrix.smaller_area(exchange);
}

Matrix find_matrix(const Scene& whole_scene, const Request& request) {
    expect_sense(request);
    if (!request.surroundings.empty()) expect_surroundings(whole_scene, request.surroundings);
    if (request.repair && request.surroundings.empty()) expect_repairable(whole_scene);
    const Placement placement = placement_of(whole_scene);
    const Scene scene = join_level_surfaces(placed(whole_scene, placement)).scene;
    Matrix matrix;
    matrix.surfaces = scene.surfaces.size();
    FacePairs geometry = examine_pairs(scene, request);
    allow_for_rounding(rounding_of_far_coordinates(whole_scene, placement) / placement.unit, scene, geometry);
    matrix.areas = geometry.areas;
    matrix.interrupted = request.stop != nullptr && *request.stop;
    if (!matrix.interrupted) expect_possible(scene, geometry, request);
    const std::size_t sampled = geometry.pairs.size();
    const double alpha = request.level_of == LevelOf::entry || sampled == 0
                             ? 1 - request.level
                             : stats::bonferroni_level(1 - request.level, sampled + matrix.faces());
    matrix.entry_level = 1 - alpha;

    std::vector<std::pair<std::uint64_t, std::uint64_t>> lost(matrix.faces());
    MatrixBuilder builder(matrix, geometry, request, alpha);
    std::exchange(geometry.known, {});  // they are in the matrix now
    if (sampled > 0 && !matrix.interrupted) {
        const SamplingOutcome outcome =
            sample_pairs(scene, geometry, request, alpha,
                         [&](std::size_t pair, const PairEstimate& estimate) { builder.take(pair, estimate); });
        matrix.samples = outcome.samples;
        matrix.rays = outcome.rays;
        matrix.lost_rays = outcome.lost;
        lost = outcome.lost_of_rows;
        matrix.interrupted = outcome.interrupted;
        matrix.left_out = outcome.left_out;
    }
    builder.end(farthest_coordinate(whole_scene) / placement.unit);
    if (!rows_add_up(whole_scene))
        for (RowSum& row : matrix.rows) row.off_one = 0;
    if (whole_scene.closed && !matrix.interrupted && matrix.left_out == 0)
        judge_closure(matrix, lost, rows_add_up(whole_scene), request);
    if (request.drop > 0) drop(matrix, geometry.dropped, request.drop);
    scale_areas(matrix, placement.unit * placement.unit);
    if (matrix.left_out == 0) add_masks(matrix, whole_scene);
    if (!request.surroundings.empty() && matrix.left_out == 0) add_surroundings(matrix);
    if (request.repair) matrix.repaired = repair(matrix);
    return matrix;
}

}  // namespace ff::studies::form_factors
