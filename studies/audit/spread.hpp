#pragma once

#include "stats/goodness_of_fit/chi_squared.hpp"
#include "studies/audit/experiment.hpp"
#include "studies/audit/printed_number.hpp"
#include "studies/published/published.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace ff::studies::audit {

/// A published value of a sampling method: the range that its digits allow.
struct SampledValue {
    std::size_t figure = 0;
    Range values;
};

/// The joint distance of Monte Carlo values from the truth, relative to their exact covariance. Digits that are not
/// printed may be any, so the probabilities are those of the nearest and of the farthest values that the prints may
/// stand for.
struct JointDistance {
    stats::ChiSquared chi_squared;  ///< chi-squared of the middles of the ranges
    double too_far = 1;             ///< P(at least as far) is at most this, wherever in their ranges the values lie
    double too_close = 1;           ///< the same for P(at least as close)
    std::vector<std::size_t> figures;

    /// Whether the values are too far from the exact ones, or too close to them.
    [[nodiscard]] bool is_implausible(double level) const { return too_far < level || too_close < level; }
};

/// Uses pairs if there are any, otherwise row sums; each quantity once, and none that varies by less than four hits,
/// as rare hits are not normally distributed. Empty where nothing can vary.
std::optional<JointDistance> weigh_spread(const PublishedTables& tables, const SceneFacts& facts,
                                          const SrDistribution& distribution, std::uint64_t rays,
                                          std::span<const SampledValue> values);

/// An interpretation of a table's columns, judged by its figures.
struct ReadingEvidence {
    std::string table;
    std::string statement;
    std::string stated_in;
    std::vector<std::uint64_t> rays_per_face{};  ///< one per column
    FormatEvidence hits{};
    std::vector<std::optional<JointDistance>> spread{};  ///< one per column
    double log_odds = 0;                                 ///< natural, against the likeliest reading of the table
    bool refuted = false;                                ///< less likely than the best one by more than `refuting_odds`
};

/// All readings of every table that has some, beginning with the columns' own ("as the columns say"). The model: a
/// figure is a whole number of hits from the exact normal distribution, or, with probability 1/50, a misprint.
std::vector<ReadingEvidence> weigh_readings(const PublishedTables& tables, const SceneFacts& facts, NumberFormat format,
                                            DistributionCache& cache);

}  // namespace ff::studies::audit
