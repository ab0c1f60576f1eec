#pragma once

#include "studies/audit/experiment.hpp"
#include "studies/published/published.hpp"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace ff::studies::audit {

enum class ReferenceSource {
    printed,    ///< the printed value
    exact,      ///< the exact value
    shortened,  ///< one of these with fewer digits
};

/// The reference of one table's relative errors, for pairs with the same exact value.
struct InferredReference {
    std::string table;
    std::string pair_class;
    ReferenceSource source = ReferenceSource::exact;
    std::string text;  ///< digits of the reference
    double value = 0;
    std::size_t rows = 0;       ///< different (value, error) rows
    std::size_t explained = 0;  ///< rows that this reference explains
    std::string stated;         ///< digits of the stated (printed, else exact) reference
    std::size_t explained_by_stated = 0;
    std::vector<std::size_t> unexplained_by_stated;  ///< figures: relative errors
};

/// The references of all relative errors, and how these are rounded.
struct ReferenceInference {
    std::vector<InferredReference> references;
    Rounding rounding = Rounding::rounded;
    std::size_t rows = 0;
    std::size_t explained_rounded = 0;
    std::size_t explained_truncated = 0;
    std::vector<std::optional<Reference>> reference;  ///< [figure], of relative errors
};

/// Tries the stated reference, the exact value and all shorter forms of both, for errors rounded and truncated. A
/// shorter form is preferred only where it explains at least two different rows more than the stated reference.
/// @param formats  [figure]: of printed values
ReferenceInference infer_references(const PublishedTables& tables, const SceneFacts& facts,
                                    const std::vector<NumberFormat>& formats);

/// Whether a printed error can belong to a printed value. Exact where a range is a point.
bool error_fits(Range value, Range percent, double reference);

}  // namespace ff::studies::audit
