#include "studies/verdicts/reported/reported_quantity.hpp"

#include "core/support/error.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace ff::studies::gates {
namespace {

bool same_numbers(const ReportedRow& a, const ReportedRow& b) {
    return a.mean == b.mean && a.standard_error == b.standard_error && a.n == b.n;
}

/// The chance that a second row of its kind holds the same number: about 1 / sqrt(4 pi v) for counts and hits of
/// variance v; real numbers never do.
double chance_of_equal(const ReportedFile& file, const ReportedRow& row) {
    if (file.holds != Holds::counts && file.holds != Holds::hits) return file.has_errors ? 0 : 1;
    double variance = row.mean;
    if (file.holds == Holds::hits) variance *= 1 - row.mean / std::max(1.0, row.n);
    return std::min(1.0, 1 / std::sqrt(4 * std::numbers::pi * variance));
}

/// Whether independent numbers may well equal all of these.
bool may_be_equal(const ReportedFile& file, Rows rows) {
    constexpr double rare = 1e-6;
    double chance = 1;
    for (const ReportedRow& row : rows) chance *= chance_of_equal(file, row);
    return chance > rare;
}

void refuse_equal_runs(const Gate& gate, const Bins& bins) {
    constexpr std::size_t telling = 3;  // rounded means of a bin or two may agree by chance
    for (std::size_t run = 1; run < bins.runs; ++run) {
        std::vector<ReportedRow> filled;
        bool equal = true;
        for (std::size_t bin = 0; equal && bin < bins.count(); ++bin) {
            const Rows runs = bins.runs_of(bin);
            equal = same_numbers(runs[run - 1], runs[run]);
            if (!runs[run].is_empty()) filled.push_back(runs[run]);
        }
        if (equal && filled.size() >= telling && !may_be_equal(*bins.file, filled))
            throw UserError(
                "{}: runs {} and {} of '{}' hold the same numbers in all {} bins (a run repeated "
                "is not a second run). Give every run a seed of its own.",
                bins.file->origin, bins.rows[run - 1].run, bins.rows[run].run, gate.quantity, bins.count());
    }
}

void expect_same_bins(const Gate& gate, const Bins& ours, const Bins& theirs) {
    const auto missing_in = [&](const Bins& all, const Bins& some) {
        for (std::size_t a = 0, b = 0; a < all.count(); ++a, ++b) {
            if (b < some.count() && all.name(a) == some.name(b)) continue;
            throw UserError(
                "{}:{}:1: '{}', bin '{}' is not matched in {} ({} bins here, {} there; bins are "
                "compared by name). Give both files the same binning.",
                all.file->origin, all.rows[a * all.runs].line, gate.quantity, all.name(a), some.file->origin,
                all.count(), some.count());
        }
    };
    missing_in(ours, theirs);
    missing_in(theirs, ours);
}

void refuse_equal_files(const Gate& gate, const Bins& ours, const Bins& theirs) {
    const bool equal = ours.rows.size() == theirs.rows.size() && !may_be_equal(*theirs.file, theirs.rows) &&
                       std::equal(ours.rows.begin(), ours.rows.end(), theirs.rows.begin(), same_numbers);
    if (!equal) return;
    throw UserError(
        "{}: '{}' has the same numbers as in {} (one file twice, or two runs with the same random "
        "numbers: their difference of 0 says nothing). Give the second run a seed of its own; "
        "where equal bits are wanted, compare them with cmp.",
        ours.file->origin, gate.quantity, theirs.file->origin);
}

}  // namespace

Bins bins_of(const Gate& gate, const ReportedFile& file) {
    Bins bins{&file, find_rows(file, gate.quantity, gate.place), 1};
    const Rows rows = bins.rows;
    while (bins.runs < rows.size() && file.name_of(rows[bins.runs]) == file.name_of(rows[0])) ++bins.runs;
    for (std::size_t i = 0; i < rows.size(); ++i) {
        const std::size_t first = i - i % bins.runs;
        const bool whole = first + bins.runs <= rows.size() && file.name_of(rows[i]) == file.name_of(rows[first]) &&
                           rows[i].run == rows[i % bins.runs].run;
        if (whole) continue;
        throw UserError(
            "{}:{}:1: '{}', bin '{}', run {} (every bin needs the same runs; the first has {}). "
            "Give one row for each bin and run.",
            file.origin, rows[i].line, gate.quantity, file.name_of(rows[i]), rows[i].run, bins.runs);
    }
    refuse_equal_runs(gate, bins);
    return bins;
}

void expect_comparable(const Gate& gate, const Bins& ours, const Bins& theirs) {
    expect_same_bins(gate, ours, theirs);
    refuse_equal_files(gate, ours, theirs);
}

}  // namespace ff::studies::gates
