#include "studies/audit/constraint_system.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace ff::studies::audit {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double tolerance = 1e-12;  // rounding of sums of numbers near 1; a printed unit is at least 1e-9
constexpr double hit_slack = 1e-6;

bool is_empty(Range range) {
    return range.low > range.high + tolerance;
}

Range scaled(Range range, double factor) {
    return factor >= 0 ? Range{range.low * factor, range.high * factor}
                       : Range{range.high * factor, range.low * factor};
}

Range project_deviation(Range allowed, double reference, Range current) {
    if (allowed.high < 0) return {1, 0};
    const double outer = reference * allowed.high / 100;
    const double inner = reference * std::max(0.0, allowed.low) / 100;
    if (current.high < reference + inner - tolerance) return {reference - outer, reference - inner};
    if (current.low > reference - inner + tolerance) return {reference + inner, reference + outer};
    return {reference - outer, reference + outer};
}

/// Snaps to whole hits.
Range on_lattice(Range range, std::optional<std::uint64_t> rays) {
    if (!rays || std::isinf(range.low) || std::isinf(range.high)) return range;
    const double n = static_cast<double>(*rays);
    return {std::ceil(range.low * n - hit_slack) / n, std::floor(range.high * n + hit_slack) / n};
}

Range project_even(const Constraint& constraint, const ConstraintSystem& system, const std::vector<Range>& ranges,
                   std::size_t term) {
    const auto hits = [&](std::size_t variable, double value) {
        return std::llround(value * static_cast<double>(*system.variables[variable].rays));
    };
    long long others = 0;
    for (std::size_t k = 0; k < constraint.terms.size(); ++k) {
        if (k == term) continue;
        const std::size_t variable = constraint.terms[k].variable;
        const Range range = ranges[variable];
        const long long low = hits(variable, range.low);
        if (low != hits(variable, range.high)) return {-infinity, infinity};
        others += low;
    }
    const std::size_t variable = constraint.terms[term].variable;
    const double n = static_cast<double>(*system.variables[variable].rays);
    Range range = ranges[variable];
    if ((others + hits(variable, range.low)) % 2 != 0) range.low += 1 / n;
    if ((others + hits(variable, range.high)) % 2 != 0) range.high -= 1 / n;
    return range;
}

}  // namespace

std::string_view name(Relation relation) {
    constexpr std::array<std::string_view, 14> names{"printing rule",
                                                     "printing",
                                                     "print",
                                                     "whole hits",
                                                     "row sum",
                                                     "relative error",
                                                     "sum of relative errors",
                                                     "reference",
                                                     "closure",
                                                     "reciprocity",
                                                     "parity",
                                                     "plausibility",
                                                     "spread",
                                                     "reading"};
    return names[static_cast<std::size_t>(relation)];
}

Range contribution(const Constraint& constraint, const std::vector<Range>& ranges, const Term& term) {
    const Range x = ranges[term.variable];
    return scaled(constraint.kind == ConstraintKind::linear ? x : deviation(x, constraint.reference), term.factor);
}

Range project(const Constraint& constraint, const ConstraintSystem& system, const std::vector<Range>& ranges,
              std::size_t term) {
    if (constraint.kind == ConstraintKind::even) return project_even(constraint, system, ranges, term);
    Range allowed = constraint.values;
    for (std::size_t k = 0; k < constraint.terms.size(); ++k) {
        if (k == term) continue;
        const Range other = contribution(constraint, ranges, constraint.terms[k]);
        allowed.low -= other.high;
        allowed.high -= other.low;
    }
    const Term& t = constraint.terms[term];
    allowed = scaled(allowed, 1 / t.factor);
    if (constraint.kind == ConstraintKind::linear) return allowed;
    return project_deviation(allowed, constraint.reference, ranges[t.variable]);
}

std::optional<std::vector<Range>> propagate(const ConstraintSystem& system, const Blame& blame) {
    std::vector<Range> ranges;
    ranges.reserve(system.variables.size());
    for (const Variable& variable : system.variables) {
        ranges.push_back(on_lattice(variable.range, variable.rays));
        if (is_empty(ranges.back())) return std::nullopt;
    }
    constexpr int most_sweeps = 100;
    for (int sweep = 0; sweep < most_sweeps; ++sweep) {
        bool narrowed = false;
        for (const Constraint& constraint : system.constraints) {
            if (constraint.suspect && blame[*constraint.suspect]) continue;
            for (std::size_t k = 0; k < constraint.terms.size(); ++k) {
                const std::size_t variable = constraint.terms[k].variable;
                Range& range = ranges[variable];
                const Range allowed = project(constraint, system, ranges, k);
                const Range next = on_lattice({std::max(range.low, allowed.low), std::min(range.high, allowed.high)},
                                              system.variables[variable].rays);
                if (is_empty(next)) return std::nullopt;
                narrowed = narrowed || next.low > range.low + tolerance || next.high < range.high - tolerance;
                range = next;
            }
        }
        if (!narrowed) break;
    }
    return ranges;
}

}  // namespace ff::studies::audit
