#pragma once

#include "studies/verdicts/gate.hpp"
#include "studies/verdicts/verdict.hpp"

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace ff::studies {

/// One look at a commit: a line of a ledger.
struct LedgerLook {
    std::string commit;
    std::string bands;  ///< digest of the bands file
    std::string data;   ///< digest of what was judged: estimates, or the seed of our own trials
    Verdict verdict = Verdict::inconclusive;
};

/// All looks at all commits, in their order: a CSV file with the columns commit, bands, data, verdict.
using Ledger = std::vector<LedgerLook>;

/// @throws UserError "origin:line:column: ..."
Ledger parse_ledger(std::string_view text, std::string_view origin);
std::string ledger_csv(const Ledger& ledger);

/// What earlier looks at a commit mean for the next.
struct NextLook {
    std::size_t number = 1;  ///< 1 for the first
    bool failed = false;     ///< at an earlier one: the risk of that is spent, and no later look takes it back
    bool repeated = false;   ///< the same data were judged before
    Verdict earlier = Verdict::inconclusive;  ///< of these data
};
NextLook next_look(const Ledger& ledger, const LedgerLook& look);

/// The share of both alphas that a look has, by the file's `spending`: shares of all looks add up to at most 1, so that
/// a false alarm at any of them is as rare as alpha, on whatever data the looks are.
/// @param number  from 1 on    @pre no more than `looks`, unless alpha is halved
double share_of_look(const GatesSpec& spec, std::size_t number);

/// The file at a look: alpha and pass_alpha are shares.
/// @throws UserError where all looks are spent, or the share is too small to be computed
GatesSpec at_look(GatesSpec spec, std::size_t number);

}  // namespace ff::studies
