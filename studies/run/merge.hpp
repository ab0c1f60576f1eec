#pragma once

#include "studies/store/store.hpp"

#include <cstddef>
#include <filesystem>
#include <vector>

namespace ff::studies {

/// What a merge found; units by index, ascending.
struct MergeOutcome {
    std::vector<std::size_t> missing;    ///< in none of the stores
    std::vector<std::size_t> doubled;    ///< in several of them, with the same content
    std::vector<std::size_t> unchecked;  ///< sources, by index, that have no checksums
};

/// Brings the units of several stores of one study together in `target`, as if one run had saved them all. Merging a
/// store again changes nothing, so that an interrupted merge can be repeated. Sources are only read.
/// @throws UserError where the studies differ, or where two stores hold one unit with different content, with both
/// names; IoError
MergeOutcome merge_stores(const std::vector<std::filesystem::path>& sources, Store& target);

}  // namespace ff::studies
