#pragma once

#include "studies/store/store.hpp"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <vector>

namespace ff::studies {

/// The outcome of a merge; units by index, ascending.
struct MergeOutcome {
    std::vector<std::size_t> missing;    ///< found in none of the stores
    std::vector<std::size_t> doubled;    ///< found in several of them, with the same content
    std::vector<std::size_t> unchecked;  ///< indices of sources without checksums
};

/// Combines the units of several stores of one study in `target`, as if one run had saved them all. Merging a store
/// again changes nothing, so that an interrupted merge can be repeated. Sources are only read.
/// @throws UserError, with both names, where the studies differ or two stores hold different content for a unit;
/// IoError
MergeOutcome merge_stores(const std::vector<std::filesystem::path>& sources, Store& target);

/// Trials that two studies share: those of a cell with the same scene, sampler, estimator, size, tracer and seed. Names
/// of methods, their order, levels, margins and radiosity settings make no difference.
struct CommonTrials {
    /// Shared consecutive trials of a cell.
    struct Range {
        std::size_t there = 0;  ///< index of the cell in the stored study
        std::size_t here = 0;
        std::uint64_t first = 0;
        std::uint64_t whole = 0;  ///< trials of units that are identical in both
        std::uint64_t begun = 0;  ///< trials after those, from a unit that has more trials here
    };
    std::vector<Range> ranges;
    std::uint64_t reused = 0;
    std::uint64_t left_behind = 0;  ///< saved trials that are not part of this study
    std::uint64_t beyond = 0;       ///< saved trials beyond this study, if that is all that it lacks; otherwise 0
    std::uint64_t wanted = 0;       ///< total of this study
};

/// Finds the shared trials; of an adaptive study the pilots only, since it decides itself how many trials follow.
CommonTrials common_trials(const Store& stored, const StudyPlan& plan);

/// Adds the shared trials to a new store of the study; units that were begun are completed.
/// @param stored  open on `file`
/// @throws UserError, IoError
void adopt(const Store& stored, const std::filesystem::path& file, const CommonTrials& common, Store& target,
           unsigned threads);

}  // namespace ff::studies
