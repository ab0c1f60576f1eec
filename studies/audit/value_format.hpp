#pragma once

#include "studies/audit/hit_counts.hpp"
#include "studies/published/published.hpp"

#include <string>
#include <vector>

namespace ff::studies::audit {

/// The number format of a method's form factors and row sums.
struct InferredFormat {
    std::string method;
    NumberFormat format;
    std::vector<FormatEvidence> evidence;  ///< sampling methods only; the likeliest first
};

/// For a sampling method, the format in which most figures are whole numbers of hits; tables with several readings
/// count only where there are no others. For a deterministic one, fixed decimals, unless the figures' lengths vary as
/// with significant digits; rounded or truncated as the publication says.
/// @pre the method has figures in the tables
InferredFormat infer_format(const PublishedTables& tables, const std::string& method);

}  // namespace ff::studies::audit
