#include "studies/audit/blame.hpp"

#include "studies/audit/reciprocity.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

namespace ff::studies::audit {
namespace {

/// The values that a blamed figure should print: the range of its constraint's left side.
Range predicted(const Constraint& constraint, const std::vector<Range>& ranges) {
    Range sum{0, 0};
    for (const Term& term : constraint.terms) {
        const Range part = contribution(constraint, ranges, term);
        sum.low += part.low;
        sum.high += part.high;
    }
    sum.high = std::max(sum.low, sum.high);  // the ends of a point may be rounded past each other
    return sum;
}

/// Whether the blamed suspect could print `values` with everything that is not blamed.
bool agrees(ConstraintSystem system, const std::vector<std::size_t>& blamed, std::size_t suspect, Range values) {
    Blame blame(system.suspects.size(), false);
    for (const std::size_t s : blamed) blame[s] = s != suspect;
    for (Constraint& constraint : system.constraints) {
        if (constraint.suspect == suspect) constraint.values = values;
    }
    return propagate(system, blame).has_value();
}

/// The errors of a deterministic method have any size, so the probability that one lies within a printed unit of its
/// value falls as the reciprocal of this value. In powers of ten, over all pairs.
double distance_from_truth(const ExperimentModel& model, const std::vector<Range>& ranges) {
    const SceneFacts& facts = model.facts;
    double improbability = 0;
    std::set<std::size_t> seen;
    for (const auto& [pair, term] : model.pairs) {
        if (model.system.variables[term.variable].rays || !seen.insert(term.variable).second) continue;
        const Range left = ranges[term.variable];
        const Range truth = facts.factor(pair / facts.faces(), pair % facts.faces());
        const double gap = std::max({0.0, left.low - truth.high / term.factor, truth.low / term.factor - left.high});
        improbability += std::log10(1 + gap / printed_unit(left.low, model.interpretation.values));
    }
    return improbability;
}

JudgedDiagnosis judge(const ExperimentModel& model, Diagnosis diagnosis) {
    JudgedDiagnosis judged;
    judged.improbability = distance_from_truth(model, diagnosis.ranges);
    for (const std::size_t s : diagnosis.blamed) {
        const Suspect& suspect = model.system.suspects[s];
        if (suspect.figures.empty()) {
            judged.improbability += suspect.weight;
            continue;
        }
        const Constraint& constraint = constraint_of(model, s);
        const Figure& figure = model.tables.figures[suspect.figures.front()];
        const auto is_consistent = [&](Range values) { return agrees(model.system, diagnosis.blamed, s, values); };
        Correction correction =
            correct(figure.printed, predicted(constraint, diagnosis.ranges), format_of(figure, model.interpretation),
                    rays_of(model, constraint), is_consistent);
        correction.figure = suspect.figures.front();
        judged.improbability += suspect.weight * correction.edits;
        if (const auto expected =
                model.distribution ? expectation(model.facts, *model.distribution, figure) : std::nullopt;
            expected && expected->sigma > 0) {
            const double z = (parse_printed(correction.meant)->value() - expected->mean) / expected->sigma;
            judged.improbability += 0.5 * z * z / std::numbers::ln10;
        }
        judged.corrections.push_back(std::move(correction));
    }
    judged.diagnosis = std::move(diagnosis);
    return judged;
}

}  // namespace

const Constraint& constraint_of(const ExperimentModel& model, std::size_t suspect) {
    return *std::find_if(model.system.constraints.begin(), model.system.constraints.end(),
                         [&](const Constraint& c) { return c.suspect == suspect; });
}

std::optional<std::uint64_t> rays_of(const ExperimentModel& model, const Constraint& constraint) {
    if (constraint.kind != ConstraintKind::linear || constraint.terms.size() != 1) return std::nullopt;
    if (constraint.terms.front().factor != 1) return std::nullopt;
    return model.system.variables[constraint.terms.front().variable].rays;
}

std::vector<JudgedDiagnosis> judge_diagnoses(const ExperimentModel& model) {
    std::vector<JudgedDiagnosis> judged;
    for (Diagnosis& diagnosis : diagnose(model.system)) judged.push_back(judge(model, std::move(diagnosis)));
    std::stable_sort(judged.begin(), judged.end(), [](const JudgedDiagnosis& a, const JudgedDiagnosis& b) {
        return a.improbability < b.improbability;
    });
    return judged;
}

}  // namespace ff::studies::audit
