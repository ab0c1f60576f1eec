#pragma once

#include "studies/audit/constraint_system.hpp"
#include "studies/audit/printed_number.hpp"
#include "studies/audit/scene_facts.hpp"
#include "studies/published/published.hpp"

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace ff::studies::audit {

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

/// "SR, 169 patches per face, 625 rays per patch".
std::string describe(const Experiment& experiment);

/// The reference of a relative error. Authors do not say whether they divided by the stated reference or by the exact
/// value.
struct Reference {
    double value = 0;
    double uncertainty = 0;  ///< distance between the two, 0 where a shortened one was used
};

/// How figures are printed, and the references of errors.
struct Interpretation {
    NumberFormat values;                  ///< format of form factors and row sums
    Rounding errors = Rounding::rounded;  ///< rounding of relative errors, which keep their own decimals
    std::vector<std::optional<Reference>>
        reference;  ///< [figure]: what a relative error refers to; empty for other figures
};

/// The format of a figure: errors are printed to as many decimals as they show.
NumberFormat format_of(const Figure& figure, const Interpretation& interpretation);

/// The variable that a figure prints (none for sums of relative errors), and the constraint that ties them.
struct FigureLink {
    std::size_t figure = 0;
    std::optional<Term> quantity;
    std::size_t constraint = 0;
};

/// An experiment as unknown quantities and relations.
struct ExperimentModel {
    ConstraintSystem system;
    std::vector<FigureLink> links;
    std::vector<std::size_t> sums;               ///< [face]: variable
    std::map<std::size_t, Term> pairs;           ///< [from * faces + to]: variable; empty unless a pair is printed
    std::optional<SrDistribution> distribution;  ///< sampling methods only
};

/// Builds the model.
/// @param z_limit  standard deviations beyond which a Monte Carlo value counts as impossible
ExperimentModel build_model(const PublishedTables& tables, const SceneFacts& facts, const Experiment& experiment,
                            const Interpretation& interpretation, DistributionCache& cache, double z_limit);

/// Exact mean and standard deviation of what a figure of a sampling method prints; empty for errors and where unknown.
struct Expectation {
    double mean = 0;
    double sigma = 0;
};
std::optional<Expectation> expectation(const SceneFacts& facts, const SrDistribution& distribution,
                                       const Figure& figure);

}  // namespace ff::studies::audit
