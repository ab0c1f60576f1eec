#pragma once

#include "core/visibility/pair_class.hpp"
#include "stats/basics/interval.hpp"
#include "studies/readers/names.hpp"
#include "studies/trials/cell_reader.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

namespace ff::studies {

/// The rule by which a group of trials yields an interval.
enum class IntervalRule {
    student_t,
    normal,
    percentile_bootstrap,
    two_stage,   ///< Stein's: R trials are the pilot and determine how many follow
    look_short,  ///< trials are added to R one by one until Student's interval is short enough; broken on purpose
};

template <>
inline constexpr auto names_of<IntervalRule> =
    name_table(Named{IntervalRule::student_t, "student_t"}, Named{IntervalRule::normal, "normal"},
               Named{IntervalRule::percentile_bootstrap, "percentile_bootstrap"},
               Named{IntervalRule::two_stage, "two_stage"}, Named{IntervalRule::look_short, "look_short"});

/// How often intervals of one rule contain the exact value.
struct Coverage {
    std::size_t cell = 0;
    PairClass pair_class = PairClass::other;
    IntervalRule interval_method = IntervalRule::student_t;
    std::uint64_t replicates = 0;  ///< R: trials per group, or in its first stage
    std::uint64_t intervals = 0;
    std::uint64_t covered = 0;
    double mean_trials = 0;             ///< mean number of trials per group
    stats::Interval coverage_interval;  ///< Clopper-Pearson, of the coverage, at the study's level
    bool short_of_nominal = false;      ///< significantly, at the study's level over all rows together (Sidak)

    [[nodiscard]] double share() const { return static_cast<double>(covered) / static_cast<double>(intervals); }
};

/// Cuts the trials of each sampled cell into groups of R and makes an interval of each, for StudySpec::coverage. From
/// each source face one target of each class is taken: such pairs have no point in common, so that intervals are
/// independent. Stopping rules aim at the half-width that 4 R trials have on average. Pure.
std::vector<Coverage> measure_coverage(const CellReader& cells);

}  // namespace ff::studies
