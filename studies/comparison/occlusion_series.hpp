#pragma once

#include "studies/analysis/analysis.hpp"
#include "studies/analysis/slopes.hpp"

#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

namespace ff::studies {

/// The slope of random points, which no other set of points should fall short of.
inline constexpr double slope_of_random = -0.5;

/// The error of a method on one pair of faces.
struct PairError {
    std::size_t cell = 0;  ///< the method's size closest to the common number of samples
    ClassError error;      ///< error on this pair alone
    /// Slope along the method's ladder: of the RMSE, or of the median where there is no variance.
    std::optional<Slope> slope;
    /// Whether the slope is shown to be flatter than that of random points, on a partly occluded pair: at the study's
    /// level over all such slopes of all series (Bonferroni). That of a deterministic method has no interval, and is
    /// compared as it is.
    bool slower_than_random = false;

    [[nodiscard]] double size() const {
        return error.status == VarianceStatus::infinite ? error.median_abs_error : error.rmse;
    }
};

/// One scene of a family: the occluded fraction, and each method's error.
struct HiddenPair {
    std::size_t scene = 0;
    double hidden = 0;  ///< occluded fraction of the open form factor, 0 to 1
    double exact = 0;
    std::vector<std::optional<PairError>> methods;  ///< one for each of StudySpec::methods
    std::optional<std::size_t> least;               ///< method with the smallest error; empty where all are rounding
    /// Whether the error of `least` is shown to be smaller than that of every other method: at the study's level over
    /// all scenes of all series, and over the methods, from which it is picked (Bonferroni).
    bool decided = false;
    /// How many times as large the error of the next method is: the one with the
    /// smallest error of those with a finite variance. At the same level; empty where there is none, or `least` is
    /// exact.
    std::optional<stats::Interval> next;

    [[nodiscard]] bool is_partly_hidden() const { return hidden > 0 && exact > 0; }
};

/// The same pair of faces in scenes of a family, by ascending occluded fraction.
struct OcclusionSeries {
    std::string_view family;
    std::string_view measure;
    Quantity pair;
    std::uint64_t samples = 0;  ///< of the pair: the common number that methods are compared at
    std::vector<HiddenPair> scenes;
};

/// The effect of occlusion on the methods of a study, for each family (SceneFamily) of which it has at least three
/// scenes. The common number of samples of a pair is the largest that all methods reach or come close to.
/// @param slopes  of all ladders; may be empty
std::vector<OcclusionSeries> occlusion_series(const CellReader& cells, const Analysis& findings,
                                              const std::vector<LadderSlopes>& slopes);

}  // namespace ff::studies
