#pragma once

#include "studies/verdicts/gate.hpp"
#include "studies/verdicts/verdict.hpp"

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace ff::studies::gates {

/// One look at a commit: a line of a ledger.
struct LedgerLook {
    std::string commit;
    std::string bands;  ///< digest of the bands file
    std::string data;   ///< digest of what was judged: estimates, or the seed of the program's own trials
    Verdict verdict = Verdict::inconclusive;
};

/// All looks at all commits, in their order: a CSV file with the columns commit, bands, data, verdict.
using Ledger = std::vector<LedgerLook>;

/// @throws UserError "origin:line:column: ..."
Ledger parse_ledger(std::string_view text, std::string_view origin);
std::string ledger_csv(const Ledger& ledger);

/// The effect of earlier looks at a commit on the next one.
struct NextLook {
    std::size_t number = 1;  ///< 1 for the first
    bool failed = false;     ///< an earlier look failed: its risk is spent, and no later look can undo it
    bool changed = false;    ///< the bands were others at the last look
    bool repeated = false;   ///< the same data were judged before, with the same bands
    Verdict earlier = Verdict::inconclusive;  ///< verdict on the same data
};
/// All looks at a commit count together, also those with other bands: otherwise any change of the file would begin
/// alpha anew.
NextLook next_look(const Ledger& ledger, const LedgerLook& look);

/// A look's share of both alphas, by the file's `spending`: shares of all looks add up to at most 1, so that the risk
/// of a false alarm at any of them is at most alpha, whatever the data of the looks.
/// @param number  from 1 on    @pre no more than `looks`, unless alpha is halved
double share_of_look(const Spec& spec, std::size_t number);

/// The bands file at a look, with shares of alpha and pass_alpha.
/// @throws UserError where all looks are used up, or the share is too small
Spec at_look(Spec spec, std::size_t number);

}  // namespace ff::studies::gates
