#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

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

}  // namespace ff::app
