#pragma once

#include "studies/form_factors/jobs.hpp"

#include <cstddef>
#include <map>
#include <vector>

namespace ff::studies::form_factors {

/// Places in FacePairs::pairs, by the face that owns the pairs.
using PairsOfRows = std::map<std::size_t, std::vector<std::size_t>>;

/// The face of a pair from which rays tell more: the smaller.
std::size_t owner_of(const FacePairs& geometry, std::size_t pair);

/// All pairs that are sampled.
PairsOfRows pairs_to_sample(const FacePairs& geometry);

/// How far sampling has to go.
struct Aim {
    const FacePairs& geometry;
    const Request& request;
    double level = 0;  ///< confidence level of the interval after a first round
    /// Exchange area that is expected of each pair, from the samples so far. It decides on numbers of samples, not on
    /// intervals.
    std::vector<double> expected{};

    [[nodiscard]] std::size_t owner(std::size_t pair) const { return owner_of(geometry, pair); }
    /// What the half width of a pair is to stay below, if its exchange area is as large as that.
    [[nodiscard]] double wanted(std::size_t pair, double exchange) const;
    [[nodiscard]] double wanted(std::size_t pair) const { return wanted(pair, expected[pair]); }
    [[nodiscard]] std::vector<double> wanted(const Job& job) const;
};

/// A job and how far it has come.
struct Work {
    Job job;
    std::size_t rounds = 0;  ///< completed rounds that count, those by cells among them
    bool pilot = true;       ///< its next round only decides and does not count
    bool has_run = false;
};

/// Pairs for which rays are tried, by the face that rays leave: rows with a pair that points cannot do, or where rays
/// may cost less than points; all, if there are few pairs.
/// @param by_points         jobs of those that points can do
/// @param are_exact_enough  whether rays are, for pairs that points can do
PairsOfRows rows_to_shoot(const Scene& scene, const Aim& aim, const PairsOfRows& rows,
                          const std::vector<Work>& by_points, bool are_exact_enough);

/// Sizes of a job's next round from its last one, and whether the next is still a pilot.
/// @param wanted  half widths of its pairs
void set_next(Work& work, const std::vector<double>& wanted, double level);

/// After a round of all candidates: chooses points or the rays of the row for each pair that points can do, such that
/// the total cost is least. Rays serve all pairs of a row at once, so the pairs that need most rays are moved to points
/// as long as that saves anything.
std::vector<Work> choose_methods(const Scene& scene, const Aim& aim, std::vector<Work> candidates);

}  // namespace ff::studies::form_factors
