#pragma once

#include "core/scene.hpp"
#include "core/stream.hpp"
#include "studies/form_factors/face_pairs.hpp"

#include <Eigen/Core>

#include <atomic>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace ff::studies {

/// What the level of intervals is said of.
enum class LevelOf {
    entry,   ///< each entry's by itself
    matrix,  ///< all entries and row sums at once
};

/// What `ffstudy form_factors` is asked for.
struct FormFactorRequest {
    double tolerance = 1e-5;  ///< of every entry: the larger half of its interval
    double level = 0.95;
    LevelOf level_of = LevelOf::entry;
    Seed seed;
    std::uint64_t max_samples = 1'000'000'000;  ///< rays and points together
    bool repair = false;
    unsigned threads = 1;
    const std::atomic<bool>* stop = nullptr;  ///< set by another thread: what is known then is the result
};

/// The exchange area of two faces (from <= to), with an interval.
struct FaceExchange {
    double value = 0;
    double low = 0;
    double high = 0;
    std::optional<ExchangeMethod> sampled_by;  ///< points or rays
    std::uint64_t samples = 0;                 ///< of the round that the interval is from
    bool clipped = false;                      ///< geometry allows less than the samples do
    bool within = false;                       ///< the tolerance, in both directions
    bool contradicted = false;                 ///< an independent randomisation says otherwise; the interval holds both
};

struct RowSum {
    double value = 0;
    double low = 0;
    double high = 0;
    bool excludes_one = false;  ///< at a level at which some row of a closed scene does so by chance in 0.001 of runs
};

struct RepairedFactors {
    Eigen::MatrixXd factors;
    bool possible = false;
    double closure_before = 0, closure_after = 0;  ///< largest |row sum - 1|
    double largest_change = 0;
    std::size_t from = 0, to = 0;  ///< where it is
    std::size_t outside = 0;       ///< repaired entries outside their intervals
};

/// Form factors between the faces of a scene. Reciprocal by construction: both directions share one exchange area.
struct FormFactorMatrix {
    FacePairs geometry;
    std::size_t surfaces = 0;             ///< that were left when level ones had been joined
    std::vector<FaceExchange> exchanges;  ///< as geometry.pairs
    std::vector<RowSum> rows;
    double entry_level = 0;       ///< of each interval by itself
    std::uint64_t samples = 0;    ///< in all rounds
    std::uint64_t lost_rays = 0;  ///< in a closed scene
    std::uint64_t rays = 0;
    bool interrupted = false;
    std::optional<RepairedFactors> repaired;

    [[nodiscard]] Eigen::MatrixXd factors() const;
    /// Larger halves of the intervals.
    [[nodiscard]] Eigen::MatrixXd half_widths() const;
    [[nodiscard]] std::size_t missed() const;  ///< pairs of faces that are not within the tolerance
};

/// Computes the matrix: exactly where geometry allows it, by sampling elsewhere (docs/form-factors.md). Surfaces of a
/// face are joined first where they can be (core/joined_surfaces.hpp).
/// @throws UserError
FormFactorMatrix find_form_factors(const Scene& scene, const FormFactorRequest& request);

}  // namespace ff::studies
