#pragma once

#include "studies/audit/constraint_system.hpp"
#include "studies/audit/experiment.hpp"
#include "studies/audit/spread.hpp"
#include "studies/published/published.hpp"

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace ff::studies::audit {

/// The variable that a figure prints (none for sums of relative errors), and the constraint that ties them.
struct FigureLink {
    std::size_t figure = 0;
    std::optional<Term> quantity;
    std::size_t constraint = 0;
};

/// An experiment as unknown quantities and relations, with what it was made from, which outlives it.
struct ExperimentModel {
    const PublishedTables& tables;
    const SceneFacts& facts;
    const Experiment& experiment;
    Interpretation interpretation;
    ConstraintSystem system{};
    std::vector<FigureLink> links{};
    std::vector<std::size_t> sums{};               ///< [face]: variable
    std::map<std::size_t, Term> pairs{};           ///< [from * faces + to]: variable; empty unless a pair is printed
    std::optional<SrDistribution> distribution{};  ///< sampling methods only
};

/// Figures that print values of the variables in these terms.
std::vector<std::size_t> prints_of(const ExperimentModel& model, const std::vector<Term>& terms);

/// The joint distance of an experiment's pairs and sums from the truth, by the ranges of the model's variables; empty
/// where nothing can vary.
std::optional<JointDistance> spread_within(const ExperimentModel& model, const std::vector<Range>& ranges);

/// @param z_limit  standard deviations beyond which a Monte Carlo value counts as impossible
ExperimentModel build_model(const PublishedTables& tables, const SceneFacts& facts, const Experiment& experiment,
                            const Interpretation& interpretation, DistributionCache& cache, double z_limit);

/// More broken pairs than this cannot be misprints.
inline constexpr std::size_t most_misprints = 12;

/// Adds that area times factor is the same both ways between two faces: unconditionally where rows complete each other;
/// as far as chance allows where every row has its own rays; and as an assumption, which can be given up, where a
/// deterministic method computes both ways, since its own error may be larger than what is printed.
/// @param printed  [variable]: what prints of a pair allow, all together
void add_reciprocity(const std::map<std::size_t, Range>& printed, double z_limit, ExperimentModel& model);

/// A figure's place and digits, e.g. `table4, Σ of face 3, SR ("0.97264")`.
std::string quote(const PublishedTables& tables, std::size_t figure);

/// The figures that a constraint of reciprocity ties, with the areas of their faces. Congruent pairs share it: one of
/// each is named.
std::string both_ways(const ExperimentModel& model, const Constraint& constraint);

}  // namespace ff::studies::audit
