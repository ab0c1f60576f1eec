#pragma once

#include "studies/audit/printed_number.hpp"
#include "studies/published/published.hpp"
#include "studies/theory/sr_distribution.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace ff::studies::audit {

class DistributionCache;
struct SceneFacts;

/// One method at one size: all figures about it, in whichever table, concern the same unknown quantities.
struct Experiment {
    std::string method;
    std::uint32_t patches_per_face = 1;
    std::optional<std::uint64_t> samples_per_patch;
    std::optional<std::uint64_t> rays_per_face;  ///< sampling methods only
    Completion completion = Completion::direct;
    std::vector<std::size_t> figures;  ///< indices into PublishedTables::figures
};

/// The experiments of the tables, in order of first appearance, with columns read as the file says.
std::vector<Experiment> collect_experiments(const PublishedTables& tables);

/// Whether the estimates of a method are hits over rays.
bool is_sampling(const PublishedTables& tables, const std::string& method);
Completion completion_of(const PublishedTables& tables, const std::string& method);

/// Whether there are other readings of a table's columns.
bool has_readings(const PublishedTables& tables, const std::string& table);

/// "SR, 169 patches per face, 625 rays per patch".
std::string describe(const Experiment& experiment);

/// The reference of a relative error. Authors do not say whether they divided by the stated reference or by the exact
/// value.
struct Reference {
    double value = 0;
    double uncertainty = 0;  ///< distance between the two, 0 where a shortened one was used
};

/// How figures are printed, and what errors are relative to.
struct Interpretation {
    NumberFormat values;                  ///< format of form factors and row sums
    Rounding errors = Rounding::rounded;  ///< rounding of relative errors, which keep their own decimals
    std::vector<std::optional<Reference>>
        reference;  ///< [figure]: what a relative error refers to; empty for other figures
};

/// The format of a figure: errors are printed to as many decimals as they show.
NumberFormat format_of(const Figure& figure, const Interpretation& interpretation);

/// Exact mean and standard deviation of what a figure of a sampling method prints; empty for errors and where unknown.
struct Expectation {
    double mean = 0;
    double sigma = 0;
};
std::optional<Expectation> expectation(const SceneFacts& facts, const SrDistribution& distribution,
                                       const Figure& figure);

}  // namespace ff::studies::audit
