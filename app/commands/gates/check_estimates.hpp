#pragma once

#include "studies/verdicts/gate.hpp"
#include "studies/verdicts/reported/estimate_gates.hpp"

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace ff::app {

/// Options of `ffstudy check`.
struct CheckCommand {
    std::filesystem::path bands;
    std::optional<std::uint64_t> seed;
    bool fresh_seed = false;
    std::uint64_t seed_sweep = 0;     ///< number of seeds; 0: one check
    std::filesystem::path estimates;  ///< CSV of another program; empty: none
    std::filesystem::path against;    ///< a second file of estimates; empty: none
    std::string again;                ///< commit whose looks share alpha; empty: a single look
    std::filesystem::path ledger;     ///< file that records looks; empty: <bands>.ledger.csv
    std::filesystem::path baseline;
    std::filesystem::path save_baseline;
    std::optional<unsigned> threads;
    std::filesystem::path out;  ///< empty: results/<bands>
    bool quiet = false;
    bool json = false;  ///< verdicts on stdout, instead of words
    bool dry_run = false;
};

/// @throws UserError where the bands file and the files of estimates do not go together
void expect_estimates(const CheckCommand& command, const studies::gates::Spec& spec);

/// Gates on the file of --estimates, be it of trials or of means with their errors; none where there is no file.
/// @throws UserError, IoError
std::vector<studies::gates::GateResult> judge_file(const CheckCommand& command, const studies::gates::Spec& spec);

/// Trials that each gate on a file of trials needs.
std::vector<studies::gates::EstimatesPlan> plan_file(const CheckCommand& command, const studies::gates::Spec& spec);

}  // namespace ff::app
