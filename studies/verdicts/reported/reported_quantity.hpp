#pragma once

#include "studies/verdicts/gate.hpp"
#include "studies/verdicts/reported/reported_file.hpp"

#include <cstddef>
#include <span>
#include <string_view>

namespace ff::studies::gates {

using Rows = std::span<const ReportedRow>;

/// The rows of one quantity in one file, bin by bin.
struct Bins {
    const ReportedFile* file = nullptr;
    Rows rows;
    std::size_t runs = 1;  ///< number of rows for each bin, one from each run

    [[nodiscard]] std::size_t count() const { return rows.size() / runs; }
    [[nodiscard]] Rows runs_of(std::size_t bin) const { return rows.subspan(bin * runs, runs); }
    [[nodiscard]] std::string_view name(std::size_t bin) const { return file->name_of(rows[bin * runs]); }
};

/// @throws UserError where bins have different runs, and where two runs hold the same numbers, i.e. used the same
///   random numbers
Bins bins_of(const Gate& gate, const ReportedFile& file);

/// @throws UserError where the two have different bins, or hold the same numbers
void expect_comparable(const Gate& gate, const Bins& ours, const Bins& theirs);

}  // namespace ff::studies::gates
