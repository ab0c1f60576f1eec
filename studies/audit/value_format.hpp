#pragma once

#include "studies/audit/hit_counts.hpp"
#include "studies/published/published.hpp"

#include <string>
#include <vector>

namespace ff::studies {

/// How the form factors and row sums of a method are printed.
struct FormatFinding {
    std::string method;
    NumberFormat format;
    std::vector<FormatEvidence> evidence;  ///< sampling methods only; the likeliest first
};

/// Of a sampling method: the format in which most figures are whole numbers of hits; tables that can be read in several
/// ways count only where there are no others. Of a deterministic one: fixed decimals, unless the figures' lengths
/// differ as they do with significant digits, rounded or truncated as the publication says.
/// @pre the method has figures in the tables
FormatFinding infer_format(const PublishedTables& tables, const std::string& method);

}  // namespace ff::studies
