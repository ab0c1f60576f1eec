#pragma once

#include "core/visibility/pair_class.hpp"
#include "stats/basics/interval.hpp"
#include "studies/readers/names.hpp"
#include "studies/theory/quantity.hpp"
#include "studies/trials/cell_reader.hpp"

#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

namespace ff::studies {

/// Who claims an error.
enum class Claimant {
    estimator,  ///< for each factor in each trial: Outcome::claims
    study,      ///< one for all: Method::claimed_error
    one_run,    ///< hits treated as independent: binomial standard error times the normal quantile
};

template <>
inline constexpr auto names_of<Claimant> = name_table(Named{Claimant::estimator, "estimator"},
                                                      Named{Claimant::study, "study"},
                                                      Named{Claimant::one_run, "one_run"});

enum class ClaimedErrorFinding {
    holds,  ///< no claim was wrong; where not all have to hold, no share is significantly too small
    fails,  ///< some claim was wrong; where not all have to hold, a pair's share is significantly too small
};

/// How often a claimed error holds on the pairs of a class that have an exact value.
struct ClaimedErrors {
    std::size_t cell = 0;
    PairClass pair_class = PairClass::other;
    Claimant claimant = Claimant::estimator;
    double promised = 1;       ///< share of claims that has to hold
    std::uint64_t claims = 0;  ///< pairs times trials
    std::uint64_t held = 0;
    Quantity worst_pair;  ///< the pair with the fewest claims that hold
    std::uint64_t worst_held = 0;
    stats::Interval
        worst_share_interval;  ///< on that pair, all runs: Clopper-Pearson, corrected for the pairs of the class
    double median_ratio = 0;   ///< median of |error| / claim
    double largest_ratio = 0;
    ClaimedErrorFinding finding = ClaimedErrorFinding::holds;

    [[nodiscard]] double share() const { return static_cast<double>(held) / static_cast<double>(claims); }
};

/// For every method that claims errors or counts hits. Errors below 1e-12 are rounding; their claims hold.
std::vector<ClaimedErrors> judge_claimed_errors(const CellReader& cells);

}  // namespace ff::studies
