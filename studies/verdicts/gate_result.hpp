#pragma once

#include "stats/basics/interval.hpp"
#include "studies/verdicts/gate.hpp"
#include "studies/verdicts/verdict.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace ff::studies::gates {

/// One effect of a gate: a row of verdicts.csv. Labels that do not apply are empty.
struct Comparison {
    std::string scene;
    std::string method;                             ///< "sampler estimator"
    std::optional<std::uint32_t> patches_per_face;  ///< empty for a ladder of them
    std::optional<std::uint64_t> samples_per_patch;
    std::string from_face;
    std::string to_face;
    std::string quantity;  ///< the meaning of the value, e.g. "bias"
    Band band;
    std::optional<Measurement> measurement;  ///< empty where the trials cannot carry an interval; `note` says why
    Verdict verdict = Verdict::inconclusive;
    Levels levels;
    std::uint64_t trials = 0;         ///< behind the measurement, over all looks
    std::string_view unit = "trial";  ///< what these are, for a sentence: "trial", "run" or "event"
    std::string note;
};

/// The result of a gate.
struct GateResult {
    std::string gate;
    GateKind kind = GateKind::bias;
    Verdict verdict = Verdict::inconclusive;
    std::vector<Comparison> comparisons;
    std::uint64_t looks = 1;        ///< look at which it was decided
    std::uint64_t evaluations = 0;  ///< rays and kernel values, including the pilot's
    std::string note;               ///< why it was decided, or what is missing, in words
    std::size_t compared = 0;       ///< bins behind the verdict, where only the worst are among the comparisons
    std::vector<std::uint64_t> scores =
        {};  ///< counts of bins by standardised difference (reported_bins.hpp: count_scores)
};

/// The result of a gate that makes one comparison, at its only look.
GateResult result_of(const Gate& gate, const Comparison& comparison);

/// The finished gates of a file; every report is made from it.
struct CheckResults {
    Spec spec;
    std::vector<GateResult> results;  ///< in the order of completion; found by name

    [[nodiscard]] bool complete() const { return results.size() == spec.gates.size(); }
    [[nodiscard]] std::size_t count(Verdict verdict) const;
    /// The verdict of all gates together; those that have not run are inconclusive.
    [[nodiscard]] Verdict verdict() const;
};

/// The joint verdict of its comparisons; a gate without any is inconclusive.
Verdict verdict_of(const std::vector<Comparison>& comparisons);

/// The worst comparison: one that fails, else an undecided one, else the one whose interval comes closest to the end of
/// its band.
/// @pre not empty
const Comparison& decisive(const std::vector<Comparison>& comparisons);

/// Verdicts of one gate over many seeds. Each seed is an independent check: nothing is repeated until it passes.
struct SeedSweep {
    std::string gate;
    std::uint64_t seeds = 0;
    std::uint64_t fails = 0;
    std::uint64_t inconclusive = 0;
};

/// How often a gate had some outcome, and how often it may.
struct SweepRate {
    double rate = 0;
    stats::Interval interval;  ///< Clopper-Pearson, level 0.95
    double allowed = 0;
    bool exceeded = false;  ///< the interval lies above
};

void add_verdict(SeedSweep& sweep, Verdict verdict);

/// Failures against the gate's share of alpha, which is allowed where all effects lie inside their bands.
SweepRate failure_rate(const SeedSweep& sweep, const Spec& spec);

/// Undecided runs against 1 - power, which is allowed where there is no effect.
SweepRate inconclusive_rate(const SeedSweep& sweep, const Spec& spec);

}  // namespace ff::studies::gates
