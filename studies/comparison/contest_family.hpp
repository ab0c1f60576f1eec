#pragma once

#include "studies/comparison/contenders.hpp"
#include "studies/comparison/contests.hpp"
#include "studies/trials/estimates.hpp"

#include <cstddef>
#include <functional>
#include <vector>

namespace ff::studies {

/// A cell of a run.
struct CellOfRun {
    const CellReader* cells;
    std::size_t cell;
};

/// Correlation of both mean square errors on a class of pairs where trials have the same random numbers, else 0.
double shared_noise(const CellOfRun& a, const CellOfRun& b, PairClass pair_class);

/// Who takes part in the contests of a scene.
struct Field {
    std::function<std::vector<Contender>(PairClass, Equal)> contenders;
    std::function<std::vector<Rung>(PairClass, Equal)> exact_sizes;
    std::function<std::size_t(std::size_t cell)> method_of;
    /// Correlation of the mean square errors of two cells: 0 where they are independent.
    std::function<double(std::size_t a, std::size_t b, PairClass pair_class)> shared_noise;
};

/// Adds all contests of a scene. The intervals of those with the same thing equal hold together.
/// @param scene  for Contest::scene
/// @param spec   for the level, and the power of Handicap::times_trials
void hold(std::size_t scene, const Field& field, const StudySpec& spec, std::vector<Contest>& contests);

}  // namespace ff::studies
