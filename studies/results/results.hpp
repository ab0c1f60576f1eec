#pragma once

#include "studies/analysis/analysis.hpp"
#include "studies/analysis/slopes.hpp"
#include "studies/audit/audit.hpp"
#include "studies/claims/claims.hpp"
#include "studies/claims/comparison.hpp"
#include "studies/claims/error_law.hpp"
#include "studies/comparison/occlusion_series.hpp"
#include "studies/comparison/rivals.hpp"
#include "studies/diagnostics/coverage.hpp"
#include "studies/diagnostics/evenness.hpp"
#include "studies/diagnostics/heavy_tails.hpp"
#include "studies/diagnostics/variance_check.hpp"
#include "studies/diagnostics/variance_reduction.hpp"
#include "studies/published/published.hpp"
#include "studies/radiosity/bias_order.hpp"
#include "studies/radiosity/consequences.hpp"
#include "studies/trials/until.hpp"

#include <atomic>
#include <optional>
#include <vector>

namespace ff::studies {

/// What a study says about the tables of a publication.
struct PublishedResults {
    PublishedTables tables;
    std::vector<TableComparison> comparisons;
    std::vector<JudgedClaim> claims;
    AuditReport audit;
};

/// Everything that reports show, made from a store alone. Context (host, dates) stands apart.
struct StudyResults {
    Findings findings;
    std::vector<LadderSlopes> slopes;
    std::vector<OcclusionSeries> occlusion;
    std::vector<VarianceReduction> reductions;
    std::vector<Evenness> evenness;
    std::vector<HeavyTail> heavy_tails;
    std::vector<Coverage> coverage;
    std::vector<UntilOutcome> until;
    std::vector<VarianceCheck> variance_checks;
    std::vector<ErrorLaw> error_laws;
    std::vector<Rivalry> rivals;
    std::optional<RadiosityResults> radiosity;  ///< empty too where a study is not complete, or a trial gave no number
    std::vector<BiasOrder> bias_orders;         ///< of the exitance
    std::optional<PublishedResults> published;  ///< empty too where a trial gave no number
    Context context;
};

/// Pure but for the reading of the store: the same observations give the same results to the bit.
/// @param stop  once true, no further system between patches is begun (one may take minutes), and what is found so far
///              is kept; null: never
StudyResults evaluate(const Store& store, const std::atomic<bool>* stop = nullptr);

}  // namespace ff::studies
