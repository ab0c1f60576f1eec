#pragma once

#include "studies/analysis.hpp"
#include "studies/audit.hpp"
#include "studies/claims.hpp"
#include "studies/comparison.hpp"
#include "studies/coverage.hpp"
#include "studies/error_law.hpp"
#include "studies/heavy_tails.hpp"
#include "studies/occlusion_series.hpp"
#include "studies/published.hpp"
#include "studies/radiosity/bias_order.hpp"
#include "studies/radiosity/consequences.hpp"
#include "studies/rivals.hpp"
#include "studies/slopes.hpp"
#include "studies/until.hpp"
#include "studies/variance_check.hpp"
#include "studies/variance_reduction.hpp"

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
StudyResults evaluate(const Store& store);

}  // namespace ff::studies
