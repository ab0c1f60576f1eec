#pragma once

#include "tests/validation/form_factors/facet_coverage.hpp"

#include <cstddef>
#include <cstdint>
#include <map>
#include <string_view>
#include <utility>
#include <vector>

namespace ff::studies::form_factors {

/// What one seed gave for a pair of faces, or for the sum of a row.
struct FacetEntry {
    std::string_view kind;  ///< its method, or "row sum"
    std::uint32_t from = 0;
    std::uint32_t to = 0;  ///< `from` for a sum
    std::size_t reference = 0;
    std::uint32_t seed = 0;   ///< from 0
    bool is_clipped = false;  ///< FaceExchange::clipped
    bool is_one = false;      ///< the one entry of its pair that counts where entries are to be independent
    double tolerance = 0;
    double smaller_area = 1;  ///< the smaller area of the two faces; 1 for a sum
    double value = 0;         ///< exchange area, or sum
    double low = 0;
    double high = 0;
};

/// The entries of a scene with many seeds.
struct FacetEntries {
    std::vector<FacetEntry> entries;
    std::vector<PlainReference> references;
    std::vector<std::pair<std::uint32_t, std::uint32_t>> pairs;  ///< pairs of the entries; that of a row sum is (0, 0)
    std::size_t wide_references = 0;                             ///< references that do not reach their accuracy
};

FacetEntries facet_entries(const Scene& scene, const FacetCoverageOptions& options);

/// References of other random numbers, four times as many randomisations, the most points and level 0.999 for those
/// that may be wrong, by their index. A row sum needs none.
std::map<std::size_t, PlainReference> sharper_references(const Scene& scene, const FacetEntries& entries,
                                                         const std::vector<std::size_t>& doubtful,
                                                         const FacetCoverageOptions& options);

}  // namespace ff::studies::form_factors
