#pragma once

#include "studies/store/store.hpp"

#include <cstddef>
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

}  // namespace ff::studies
