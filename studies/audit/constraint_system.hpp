#pragma once

#include "studies/audit/printed_number.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace ff::studies::audit {

/// The kinds of ties between printed figures, and of those to the truth.
enum class Relation {
    printing_rule,           ///< how the publication says that it prints
    printing,                ///< a figure has digits that the format cannot print
    print,                   ///< a figure is the print of its quantity
    integrality,             ///< hits over rays
    row_sum,                 ///< a row sum is the sum of its pairs
    relative_error,          ///< an error belongs to its value and reference
    sum_of_relative_errors,  ///< the sum over all rows of their errors
    reference,               ///< the reference that errors are relative to
    closure,                 ///< the row of a face whose rays all belong to it sums to 1
    reciprocity,             ///< area times factor is the same both ways between two faces
    parity,                  ///< with reciprocity every pair counts twice in the row sums
    plausibility,            ///< a Monte Carlo value so far off that chance does not explain it
    spread,                  ///< Monte Carlo values that are together too far from or too close to the truth
    reading,                 ///< what a column means
};

std::string_view name(Relation relation);

/// A possible error: figures that print the same quantity with the same digits (one cause, if they are wrong), or an
/// assumption about the method.
struct Suspect {
    std::vector<std::size_t> figures;  ///< indices into PublishedTables::figures; empty for an assumption
    std::string assumption;            ///< the assumption in words; empty for figures
    double cost = 1;                   ///< cost of blaming it
    /// Improbability of each digit that it must change, in powers of ten; that of the assumption being wrong.
    double weight = 1;
};

/// An unknown true quantity. If `rays` is given, it is a whole number of hits divided by `rays`.
struct Variable {
    Range range;
    std::optional<std::uint64_t> rays;
};

struct Term {
    std::size_t variable = 0;
    double factor = 1;
};

enum class ConstraintKind {
    linear,     ///< sum of factor * x lies in `values`
    deviation,  ///< sum of factor * 100 |x - reference| / reference lies in `values`
    even,       ///< sum of the numbers of hits is even
};

/// A relation between variables. It holds unless its suspect is to blame.
struct Constraint {
    ConstraintKind kind = ConstraintKind::linear;
    Relation relation = Relation::print;
    std::vector<Term> terms{};  ///< every variable once
    Range values{};
    double reference = 1;
    std::optional<std::size_t> suspect{};  ///< empty: holds in any case
};

/// Unknown quantities and what is known about them.
struct ConstraintSystem {
    std::vector<Variable> variables;
    std::vector<Constraint> constraints;
    std::vector<Suspect> suspects;
};

/// Which suspects are assumed wrong: [suspect].
using Blame = std::vector<bool>;

/// The range that a term adds to the left side of its constraint, which is not `even`.
Range contribution(const Constraint& constraint, const std::vector<Range>& ranges, const Term& term);

/// The values that one constraint allows for the variable of its term `term`, given ranges of all variables. Empty
/// ranges have low > high.
Range project(const Constraint& constraint, const ConstraintSystem& system, const std::vector<Range>& ranges,
              std::size_t term);

/// Narrows all ranges until no constraint narrows them further, ignoring constraints of blamed suspects.
/// @return [variable], or empty where the constraints contradict each other. An empty result is a
///         certain contradiction; ranges may still hide contradictions that they cannot show.
std::optional<std::vector<Range>> propagate(const ConstraintSystem& system, const Blame& blame);

}  // namespace ff::studies::audit
