#pragma once

#include "studies/audit/hit_counts.hpp"
#include "studies/published/published.hpp"

#include <optional>
#include <string>
#include <vector>

namespace ff::studies::audit {

/// The number format of a method's form factors and row sums.
struct InferredFormat {
    std::string method;
    NumberFormat format;
    std::vector<NumberFormat> candidates;  ///< possible formats, the one that is most likely by itself first
    std::vector<FormatEvidence> evidence;  ///< evidence for each candidate; sampling methods only
};

/// How the publication says that digits are dropped; empty where it does not.
std::optional<Rounding> stated_rounding(const PublishedTables& tables);

/// What the single figures of a method tell about its format. For a sampling method, a format is the more likely the
/// more figures are whole numbers of hits in it; tables with several readings count only where there are no others. A
/// deterministic one has fixed decimals, unless the figures' lengths vary as with significant digits. The first
/// candidate is chosen, but one that is not rounded or truncated as stated only where the odds for it are overwhelming.
/// @pre the method has figures in the tables
InferredFormat infer_format(const PublishedTables& tables, const std::string& method);

}  // namespace ff::studies::audit
