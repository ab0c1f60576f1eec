#include "studies/audit/blame.hpp"
#include "studies/audit/explain.hpp"
#include "studies/audit/reciprocity.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace ff::studies::audit {
namespace {

std::string explain_reciprocity(const ExperimentModel& model, const Diagnosis& diagnosis, std::size_t suspect,
                                Finding& finding) {
    constexpr std::size_t most_shown = 12;
    std::size_t broken = 0;
    std::string first = "sums of rows";
    for (const Constraint& constraint : model.system.constraints) {
        if (constraint.suspect != suspect) continue;
        const Range allowed = project(constraint, model.system, diagnosis.ranges, 0);
        const Range left = diagnosis.ranges[constraint.terms.front().variable];
        if (allowed.meets(left) || ++broken > most_shown) continue;
        const std::string both = both_ways(model, constraint);
        if (broken == 1) first = both;
        finding.cite(Relation::reciprocity, fmt::format("It is broken by {}.", both),
                     figures_behind(model, constraint));
    }
    if (broken > 1) first += fmt::format(", and {} other pair{} of figures", broken - 1, broken == 2 ? "" : "s");
    return fmt::format(
        "{}: {} break reciprocity by more than rounding can. Either the method does not keep it or "
        "figures are wrong.",
        describe(model.experiment), first);
}

std::string explain_closure(const ExperimentModel& model, const Diagnosis& diagnosis, std::size_t suspect,
                            Finding& finding) {
    const Experiment& experiment = model.experiment;
    const auto& constraints = model.system.constraints;
    const auto broken = std::find_if(constraints.begin(), constraints.end(), [&](const Constraint& constraint) {
        return constraint.suspect == suspect &&
               !diagnosis.ranges[constraint.terms.front().variable].contains(constraint.values.low);
    });
    Evidence evidence{.relation = Relation::closure,
                      .text =
                          "A face whose whole row comes from its own rays must sum to 1 exactly in a closed "
                          "scene, unless rays are lost.",
                      .figures = {}};
    if (broken == constraints.end()) {
        finding.evidence.push_back(std::move(evidence));
        return fmt::format("{}: the row sums cannot all be 1 exactly, as they must be unless rays are lost.",
                           describe(experiment));
    }
    const std::size_t sum = broken->terms.front().variable;
    const Range range = diagnosis.ranges[sum];
    const double rays = static_cast<double>(experiment.rays_per_face.value_or(0));
    for (const FigureLink& link : model.links) {
        if (link.quantity && link.quantity->variable == sum) evidence.figures.push_back(link.figure);
    }
    std::string text = fmt::format("{}: a row sum must be 1 exactly but is {}, as if {:.0f}", describe(experiment),
                                   in_words(range), rays * (1 - range.high));
    if (range.high > range.low) text += fmt::format(" to {:.0f}", rays * (1 - range.low));
    text += fmt::format(" of {:.0f} rays were lost", rays);
    for (const std::size_t f : evidence.figures) text += fmt::format("; {}", quote(model.tables, f));
    finding.evidence.push_back(std::move(evidence));
    return text + ".";
}

}  // namespace

std::string explain_assumption(const ExperimentModel& model, const Diagnosis& diagnosis, std::size_t suspect,
                               Finding& finding) {
    const auto explain =
        constraint_of(model, suspect).relation == Relation::closure ? explain_closure : explain_reciprocity;
    return explain(model, diagnosis, suspect, finding);
}

}  // namespace ff::studies::audit
