#pragma once

#include "studies/form_factors/jobs.hpp"

#include <cstddef>
#include <vector>

namespace ff::studies {

/// How far sampling has to go.
struct Aim {
    const FacePairs& geometry;
    double tolerance = 0;  ///< of a form factor
    double level = 0;      ///< of the interval of a first round

    /// The face of a pair from which rays tell more: the smaller.
    [[nodiscard]] std::size_t owner(std::size_t pair) const;
    /// Exchange area that the half width of a pair is to stay below.
    [[nodiscard]] double wanted(std::size_t pair) const;
    [[nodiscard]] std::vector<double> wanted(const Job& job) const;
};

/// Pairs to sample, in parts whose jobs are in memory at a time: rows that rays may serve, together at least 16 384
/// pairs or all there are. Samples of a part do not depend on the others.
std::vector<std::vector<std::size_t>> batches(const Aim& aim);

/// A job and how far it has come.
struct Work {
    Job job;
    std::size_t rounds = 0;  ///< that count, done
    bool pilot = true;       ///< its next round decides and does not count
    bool has_run = false;
};

/// Sizes of a job's next round by its last, and whether that is a pilot still.
/// @param wanted  half widths of its pairs
void set_next(Work& work, const std::vector<double>& wanted, double level);

/// After a round of all candidates: for each pair that points can do, points or the rays of its row, such that all
/// together cost least. Rays serve all pairs of a row at once, so that those that need the most are moved to points as
/// long as that saves anything.
std::vector<Work> choose_methods(const Scene& scene, const Aim& aim, std::vector<Work> candidates);

}  // namespace ff::studies
