#pragma once

#include "studies/analysis/analysis.hpp"
#include "studies/analysis/slopes.hpp"
#include "studies/audit/audit.hpp"
#include "studies/claims/claims.hpp"
#include "studies/claims/comparison.hpp"
#include "studies/claims/error_law.hpp"
#include "studies/comparison/contests.hpp"
#include "studies/comparison/occlusion_series.hpp"
#include "studies/comparison/ranking.hpp"
#include "studies/diagnostics/coverage.hpp"
#include "studies/diagnostics/evenness.hpp"
#include "studies/diagnostics/variances.hpp"
#include "studies/published/published.hpp"
#include "studies/radiosity/consequences.hpp"
#include "studies/trials/until.hpp"

#include <atomic>
#include <optional>
#include <vector>

namespace ff::studies {

/// The results of a study about the tables of a publication.
struct PublishedResults {
    PublishedTables tables;
    std::vector<TableComparison> comparisons;
    std::vector<JudgedClaim> claims;
    audit::Report audit;
};

/// Everything that reports show, computed from a store alone. Context (host, dates) is kept apart.
struct StudyResults {
    Analysis findings;
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
    std::vector<Contest> contests;
    std::vector<ClaimedErrors> claimed_errors;
    std::optional<radiosity::Results>
        radiosity;  ///< empty too where a study is not complete, or a trial gave no number
    std::vector<radiosity::BiasOrder> bias_orders;  ///< how the bias of the exitance falls, for each ladder
    std::optional<PublishedResults> published;      ///< empty too where a trial gave no number
    Context context;
};

/// Pure, except that it reads the store: the same observations give the same results to the bit.
/// @param stop  once true, no further system between patches is begun (one may take minutes), and what is found so far
///              is kept; null: never
StudyResults evaluate(const Store& store, const std::atomic<bool>* stop = nullptr);

}  // namespace ff::studies
