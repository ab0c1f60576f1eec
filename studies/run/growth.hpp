#pragma once

#include "studies/store/store.hpp"

#include <cstdint>
#include <filesystem>
#include <vector>

namespace ff::studies {

/// Trials that two studies have in common: those of a cell of the same scene, sampler, estimator, size, tracer and
/// seed. Names of methods, their order, levels, margins and what is asked of the light make no difference.
struct CommonTrials {
    /// Consecutive trials of a cell.
    struct Range {
        std::size_t there = 0;  ///< index of the cell in the stored study
        std::size_t here = 0;
        std::uint64_t first = 0;
        std::uint64_t whole = 0;  ///< trials of units that are the same in both
        std::uint64_t begun = 0;  ///< trials after those, of a unit that has more of them here
    };
    std::vector<Range> ranges;
    std::uint64_t reused = 0;
    std::uint64_t left_behind = 0;  ///< saved, but none of this study's
    std::uint64_t wanted = 0;       ///< of this study in all
};

/// Of an adaptive study no more than the pilots: how many trials follow them is for the study to decide.
CommonTrials common_trials(const Store& stored, const StudyPlan& plan);

/// Adds them to a new store of the study; units that were begun are carried out to their end.
/// @param stored  open on `file`
/// @throws UserError, IoError
void adopt(const Store& stored, const std::filesystem::path& file, const CommonTrials& common, Store& target,
           unsigned threads);

}  // namespace ff::studies
