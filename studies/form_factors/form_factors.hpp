#pragma once

#include "core/exact/exchange_method.hpp"
#include "core/geometry/fwd.hpp"
#include "studies/form_factors/request.hpp"

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace ff::studies::form_factors {

/// Matrices of more faces are written without geometric zeros, and nothing takes memory quadratic in their number.
inline constexpr std::size_t most_dense_faces = 4096;

/// Number of unordered pairs of this many faces, including each face with itself.
std::size_t pairs_of(std::size_t faces);

/// The positions in a list of the pairs of each face, ordered by the other face.
/// @param pairs  with members `from` and `to`, in the order (0,0), (0,1), .., (1,1), ..
template <class Pairs>
std::vector<std::vector<std::uint32_t>> by_face(const Pairs& pairs, std::size_t faces) {
    std::vector<std::vector<std::uint32_t>> result(faces);
    for (std::size_t p = 0; p < pairs.size(); ++p) {
        result[pairs[p].from].push_back(static_cast<std::uint32_t>(p));
        if (pairs[p].from != pairs[p].to) result[pairs[p].to].push_back(static_cast<std::uint32_t>(p));
    }
    return result;
}

/// The exchange area of two faces, with an interval.
struct FaceExchange {
    std::uint32_t from = 0;  ///< at most `to`
    std::uint32_t to = 0;
    double value = 0;
    double low = 0;
    double high = 0;
    std::uint64_t samples = 0;  ///< rays, or evaluations in cells, of the round that gave the interval
    /// The most expensive method that its surfaces needed; empty where there was no time to sample, so that the
    /// interval is the geometric bound.
    std::optional<ExchangeMethod> method;
    ExchangeReason reason = ExchangeReason::turned_away;  ///< why it needed that method
    bool clipped = false;                                 ///< geometric limits are narrower than the samples' interval
    bool within = false;                                  ///< the interval meets the tolerance, in both directions
    bool contradicted = false;  ///< an independent randomisation disagrees; the interval contains both

    [[nodiscard]] bool is_sampled() const { return !method || *method >= ExchangeMethod::cells; }
};

/// The total of what a face exchanges with others that is not kept pair by pair.
struct DroppedExchange {
    std::uint64_t pairs = 0;
    double value = 0;
    double low = 0;
    double high = 0;
};

struct RowSum {
    double value = 0;
    double low = 0;
    double high = 0;
    bool excludes_one = false;  ///< it misses the 1 of a closed scene, by more than the tolerance
    DroppedExchange dropped{};  ///< its part that is not kept pair by pair, in factors
    /// How much the sum misses 1 by, at a level at which some row of a closed scene does so by chance in 0.001 of runs.
    double off_one = 0;
};

/// The values behind the estimate of a sampled pair.
struct PairRandomisations {
    std::uint32_t from = 0;  ///< at most `to`
    std::uint32_t to = 0;
    /// The face that the rays start from. Values of one randomisation share points where this face is the same; all
    /// others are independent.
    std::optional<std::uint32_t> rays_of;
    std::array<float, randomisations> values{};  ///< values of the factor from `from` to `to`
    float hidden = 0;                            ///< part of the factor's half width that the values do not show
};

struct RepairedFactors {
    Eigen::SparseMatrix<double, Eigen::RowMajor> factors;
    bool possible = false;
    double closure_before = 0, closure_after = 0;  ///< largest |row sum - 1|
    double largest_change = 0;
    std::size_t from = 0, to = 0;  ///< its position
    std::size_t outside = 0;       ///< repaired entries outside their intervals
};

/// Two faces that cannot see each other.
FaceExchange no_exchange(std::size_t from, std::size_t to);

/// The larger half of an interval.
double half_width(const FaceExchange& exchange);

/// The most expensive method that a pair of faces needed; "bounds" where there was no time for one.
std::string_view method_of(const FaceExchange& exchange);

/// The reason for that method.
std::string_view reason_of(const FaceExchange& exchange);

/// The inverse: sets the method and the reason of an exchange from these words. @return false for unknown words
bool set_method(FaceExchange& exchange, std::string_view method, std::string_view reason);

/// Form factors between the faces of a scene. Reciprocal by construction: both directions share one exchange area.
struct Matrix {
    std::vector<double> areas;  ///< area of each face, in squared units of length
    std::size_t surfaces = 0;   ///< number of surfaces that were left after level ones were joined
    /// (0,0), (0,1), .., (1,1), .. without the pairs that cannot see each other, which exchange exactly nothing, and
    /// without those that are dropped.
    std::vector<FaceExchange> exchanges;
    std::vector<RowSum> rows;
    std::vector<PairRandomisations> randomisations;  ///< in the order of `exchanges`, if requested; not stored
    double entry_level = 0;                          ///< confidence level of each interval by itself
    std::uint64_t samples = 0;                       ///< samples in all rounds
    std::uint64_t lost_rays = 0;                     ///< rays that met nothing in a closed scene
    double leak = 0;  ///< share of a row that leaves a closed scene through gaps, if that is at most the tolerance
    std::uint64_t rays = 0;
    bool interrupted = false;
    std::uint64_t dropped = 0;  ///< number of dropped pairs
    std::size_t left_out = 0;   ///< rows that are sampled by another shard: the matrix is not whole
    std::optional<RepairedFactors> repaired;
    /// What is wrong with the scene (SceneDoubts::faults): intervals hold for the scene as read, which is not what was
    /// meant. Found by callers that have the scene file; not stored.
    std::vector<std::string> faults;

    [[nodiscard]] std::size_t faces() const { return areas.size(); }
    [[nodiscard]] std::size_t pairs() const { return pairs_of(faces()); }
    /// The exchange of a pair of faces in either order, listed or not.
    [[nodiscard]] FaceExchange exchange(std::size_t a, std::size_t b) const;
    using Sparse = Eigen::SparseMatrix<double, Eigen::RowMajor>;
    [[nodiscard]] Sparse factors() const;
    /// The larger halves of all intervals.
    [[nodiscard]] Sparse half_widths() const;
    /// Area of the smaller of its faces.
    [[nodiscard]] double smaller_area(const FaceExchange& exchange) const {
        return std::min(areas[exchange.from], areas[exchange.to]);
    }
    [[nodiscard]] std::size_t missed() const;  ///< pairs of faces that are not within the tolerance
};

/// Whether each row of the true factors adds up to 1: nothing leaves the scene, and all of its surfaces belong to
/// faces.
bool rows_add_up(const Scene& scene);

/// Whether the matrix as a whole is plausible: the scene has no fault, and a closed one has no leak and no row that
/// cannot add up to 1.
bool is_trusted(const Scene& scene, const Matrix& matrix, double tolerance);

/// Whether an entry is as accurate as requested.
bool is_within(const Matrix& matrix, const FaceExchange& exchange, const Request& request);

/// Whether the share of lost rays exceeds the tolerance.
bool leaks(const Matrix& matrix, double tolerance);

/// The larger half of a pair's interval, as a form factor of its smaller face.
double worst_half_width(const Matrix& matrix, const FaceExchange& exchange);

/// Computes the matrix: exactly where geometry allows it, by sampling elsewhere (docs/form-factors.md). Surfaces of a
/// face are joined first where possible (core/geometry/joined_surfaces.hpp).
/// @throws UserError
Matrix find_matrix(const Scene& scene, const Request& request);

}  // namespace ff::studies::form_factors
