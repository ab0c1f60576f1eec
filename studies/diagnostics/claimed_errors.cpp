#include "studies/diagnostics/claimed_errors.hpp"

#include "core/exact/known_factors.hpp"
#include "stats/basics/binomial.hpp"
#include "stats/basics/distributions.hpp"
#include "stats/basics/quantiles.hpp"
#include "studies/analysis/class_error.hpp"
#include "studies/trials/estimates.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace ff::studies {
namespace {

constexpr double rounding = 1e-12;

/// The sources of claims about a cell.
std::vector<Claimant> claimants(const Store& store, std::size_t cell) {
    const Method& method = store.plan().spec.methods[store.plan().cells[cell].method];
    std::vector<Claimant> found;
    if (store.has(cell, observable::claim)) found.push_back(Claimant::estimator);
    if (method.claimed_error) found.push_back(Claimant::study);
    const bool shoots = estimator_info(method).observes == Observes::hits;
    if (shoots && is_randomised(method)) found.push_back(Claimant::one_run);
    return found;
}

/// The share of claims that has to hold.
double promised(const StudyPlan& plan, std::size_t cell, Claimant claimant) {
    if (claimant == Claimant::one_run) return plan.spec.level;
    return plan.spec.methods[plan.cells[cell].method].claimed_level.value_or(1);
}

/// The errors claimed for a pair, by trial.
std::vector<double> claims_on(const Store& store, const CellEstimates& estimates, Quantity pair, Claimant claimant) {
    const StudyPlan& plan = store.plan();
    const auto& values = estimates.values(pair);
    std::vector<double> claims;
    switch (claimant) {
        case Claimant::estimator:
            return store.series(estimates.cell, observable::claim, pair.from, pair.to).value;
        case Claimant::study:
            claims.assign(values.size(), *plan.spec.methods[plan.cells[estimates.cell].method].claimed_error);
            return claims;
        case Claimant::one_run:
            break;
    }
    const double quantile = stats::normal_critical((1 - plan.spec.level) / 2);
    const auto index =
        static_cast<std::size_t>(pair.from - 1) * estimates.faces + static_cast<std::size_t>(pair.to - 1);
    for (const double value : values)
        claims.push_back(quantile * std::sqrt(std::max(0.0, value * (1 - value)) / estimates.rays[index]));
    return claims;
}

/// How often claims hold on one pair.
struct PairClaims {
    std::uint64_t held = 0;
    std::vector<double> ratios;  ///< [trial]: |error| / claim
};

PairClaims compare(const std::vector<double>& values, const std::vector<double>& claims, double exact) {
    PairClaims found;
    for (std::size_t trial = 0; trial < values.size(); ++trial) {
        const double error = std::abs(values[trial] - exact);
        const bool holds = error <= std::max(claims[trial], rounding);
        if (holds) ++found.held;
        if (error <= rounding)
            found.ratios.push_back(0);
        else
            found.ratios.push_back(claims[trial] > 0 ? error / claims[trial] : std::numeric_limits<double>::infinity());
    }
    return found;
}

std::optional<ClaimedErrors> judge(const Store& store, const CellEstimates& estimates, const KnownFactors& known,
                                   PairClass pair_class, Claimant claimant) {
    const StudyPlan& plan = store.plan();
    const auto pairs = known_pairs_of_class(plan, plan.cells[estimates.cell], known, pair_class);
    if (pairs.empty() || estimates.trials() == 0) return std::nullopt;
    const double level = plan.spec.level;
    ClaimedErrors found;
    found.cell = estimates.cell;
    found.pair_class = pair_class;
    found.claimant = claimant;
    found.promised = promised(plan, estimates.cell, claimant);
    std::vector<double> ratios;
    std::uint64_t fewest = std::numeric_limits<std::uint64_t>::max();
    for (const Quantity pair : pairs) {
        const auto claims = claims_on(store, estimates, pair, claimant);
        if (claims.size() != estimates.trials()) return std::nullopt;  // a program claims nothing in some of its runs
        const auto of_pair = compare(estimates.values(pair), claims, known.at(pair.from - 1, pair.to - 1).value());
        found.claims += of_pair.ratios.size();
        found.held += of_pair.held;
        ratios.insert(ratios.end(), of_pair.ratios.begin(), of_pair.ratios.end());
        if (of_pair.held >= fewest) continue;
        fewest = of_pair.held;
        found.worst_pair = pair;
    }
    found.worst_held = fewest;
    found.worst_share_interval = stats::clopper_pearson_interval({fewest, estimates.trials()},
                                                                 1 - (1 - level) / static_cast<double>(pairs.size()));
    found.median_ratio = *stats::median_absolute_error(ratios, 0);
    found.largest_ratio = *std::max_element(ratios.begin(), ratios.end());
    const bool wrong =
        found.promised < 1 ? found.worst_share_interval.high < found.promised : found.held < found.claims;
    found.finding = wrong ? ClaimedErrorFinding::fails : ClaimedErrorFinding::holds;
    return found;
}

}  // namespace

std::vector<ClaimedErrors> judge_claimed_errors(const CellReader& cells) {
    const StudyPlan& plan = cells.plan();
    std::vector<ClaimedErrors> all;
    for (std::size_t i = 0; i < plan.cells.size(); ++i) {
        const auto claiming = claimants(cells.store(), i);
        if (claiming.empty()) continue;
        const auto loaded = cells.load(i);
        const CellEstimates& estimates = *loaded;
        const KnownFactors known = known_factors(plan.scenes[plan.cells[i].scene]);
        for (const Claimant claimant : claiming) {
            if (claimant == Claimant::one_run && estimates.rays.empty()) continue;
            for (const PairClass pair_class : {PairClass::parallel, PairClass::adjacent, PairClass::other}) {
                if (auto found = judge(cells.store(), estimates, known, pair_class, claimant)) all.push_back(*found);
            }
        }
    }
    return all;
}

}  // namespace ff::studies
