#include "studies/audit/experiment_model.hpp"
#include "studies/audit/findings.hpp"
#include "studies/audit/scene_facts.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <iterator>

namespace ff::studies::audit {
namespace {

std::vector<std::size_t> figures_of(const ConstraintSystem& system, const std::vector<std::size_t>& suspects) {
    std::vector<std::size_t> figures;
    for (const std::size_t s : suspects) {
        figures.insert(figures.end(), system.suspects[s].figures.begin(), system.suspects[s].figures.end());
    }
    std::ranges::sort(figures);
    return figures;
}

std::vector<std::size_t> without(const std::vector<std::size_t>& all, const std::vector<std::size_t>& some) {
    std::vector<std::size_t> rest;
    std::set_difference(all.begin(), all.end(), some.begin(), some.end(), std::back_inserter(rest));
    return rest;
}

/// "0.19902" or "0.19902 to 0.19903".
std::string in_words(Range range) {
    const std::string low = fmt::format("{:.7g}", range.low);
    const std::string high = fmt::format("{:.7g}", range.high);
    return low == high ? low : low + " to " + high;
}

/// Figures that a constraint is about: its own, or all prints of its variables.
std::vector<std::size_t> figures_behind(const ExperimentModel& model, const Constraint& constraint) {
    if (constraint.suspect && constraint.relation != Relation::reciprocity)
        return model.system.suspects[*constraint.suspect].figures;
    if (constraint.relation == Relation::plausibility) return {};
    return prints_of(model, constraint.terms);
}

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
    const auto broken = std::ranges::find_if(constraints, [&](const Constraint& constraint) {
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

/// Says why the assumption of a blamed suspect does not hold, and adds the evidence to `finding`.
std::string explain_assumption(const ExperimentModel& model, const Diagnosis& diagnosis, std::size_t suspect,
                               Finding& finding) {
    const auto explain =
        constraint_of(model, suspect).relation == Relation::closure ? explain_closure : explain_reciprocity;
    return explain(model, diagnosis, suspect, finding);
}

/// Speaks about the figures of one experiment.
class Explainer {
  public:
    Explainer(const ExperimentModel& model, const std::vector<JudgedDiagnosis>& diagnoses)
        : model_(model), diagnoses_(diagnoses), best_(diagnoses.front()) {}

    std::vector<Finding> explain() {
        std::vector<Finding> findings;
        std::vector<std::vector<std::size_t>> groups;
        for (const std::size_t s : best_.diagnosis.blamed) {
            const auto same = std::ranges::find_if(groups, [&](const auto& g) { return same_quantity(g.front(), s); });
            if (same == groups.end()) {
                groups.push_back({s});
            } else {
                same->push_back(s);
            }
        }
        for (const auto& group : groups) {
            Finding& finding = findings.emplace_back(explain_group(group));
            if (!best_.diagnosis.proven)
                finding.statement +=
                    " Not proven: with so many contradictions, fewer other figures may be wrong instead.";
        }
        return findings;
    }

  private:
    [[nodiscard]] bool is_blamed(std::size_t suspect) const {
        const auto& blamed = best_.diagnosis.blamed;
        return std::ranges::find(blamed, suspect) != blamed.end();
    }

    [[nodiscard]] bool same_quantity(std::size_t a, std::size_t b) const {
        if (model_.system.suspects[a].figures.empty() || model_.system.suspects[b].figures.empty()) return false;
        const Constraint& first = constraint_of(model_, a);
        const Constraint& second = constraint_of(model_, b);
        return first.relation != Relation::sum_of_relative_errors &&
               second.relation != Relation::sum_of_relative_errors &&
               first.terms.front().variable == second.terms.front().variable;
    }

    [[nodiscard]] const Correction* correction_of(std::size_t suspect) const {
        const auto& figures = model_.system.suspects[suspect].figures;
        if (figures.empty()) return nullptr;
        const auto found = std::ranges::find(best_.corrections, figures.front(), &Correction::figure);
        return found == best_.corrections.end() ? nullptr : &*found;
    }

    Finding explain_group(const std::vector<std::size_t>& group) {
        Finding finding;
        finding.blamed = figures_of(model_.system, group);
        std::vector<std::string> sentences;
        for (const std::size_t s : group) {
            if (const Correction* correction = correction_of(s)) {
                finding.corrections.push_back(*correction);
                sentences.push_back(sentence(s, *correction));
                explain_figure(s, *correction, finding);
            } else {
                sentences.push_back(explain_assumption(model_, best_.diagnosis, s, finding));
            }
        }
        finding.statement = fmt::format("{}", fmt::join(sentences, " "));
        if (!finding.evidence.empty()) finding.relation = finding.evidence.front().relation;
        if (finding.relation == Relation::reciprocity && !finding.blamed.empty())
            finding.statement += " " + finding.evidence.front().text;
        add_alternatives(group, finding);
        if (finding.blamed.empty()) {
            finding.id = fmt::format("not so: {}", model_.system.suspects[group.front()].assumption);
        } else {
            const Figure& figure = model_.tables.figures[finding.blamed.front()];
            finding.id = fmt::format("{}.{}.{}", figure.table, figure.row + 1, figure.column + 1);
            if (finding.blamed.size() > 1) finding.id += fmt::format("+{}", finding.blamed.size() - 1);
        }
        finding.involved.insert(finding.involved.end(), finding.blamed.begin(), finding.blamed.end());
        for (const Evidence& evidence : finding.evidence) {
            finding.involved.insert(finding.involved.end(), evidence.figures.begin(), evidence.figures.end());
        }
        std::ranges::sort(finding.involved);
        finding.involved.erase(std::unique(finding.involved.begin(), finding.involved.end()), finding.involved.end());
        return finding;
    }

    std::string sentence(std::size_t suspect, const Correction& correction) const {
        const auto& figures = model_.system.suspects[suspect].figures;
        std::string text =
            fmt::format("{} is printed as {}", describe(model_.tables, figures.front()), correction.printed);
        if (differs(correction)) {
            text += fmt::format(" but should be {}{}.", correction.certain ? "" : "near ", correction.meant);
        } else {
            text += ", which does not agree with the other figures.";
        }
        // Values that are possible one by one need not be possible together.
        const Range printed = constraint_of(model_, suspect).values;
        if (!correction.certain && !correction.values.meets(printed))
            text += fmt::format(" Everything else leaves {}.", in_words(correction.values));
        if (figures.size() > 1) text += fmt::format(" The same holds for {} equal figures.", figures.size() - 1);
        return text;
    }

    static bool differs(const Correction& correction) {
        const auto printed = parse_printed(correction.printed);
        const auto meant = parse_printed(correction.meant);
        return !printed || !meant || printed->value() != meant->value();
    }

    /// Every relation that does not allow the printed figure.
    void explain_figure(std::size_t suspect, const Correction& correction, Finding& finding) const {
        const Constraint& own = constraint_of(model_, suspect);
        const Figure& figure = model_.tables.figures[correction.figure];
        const NumberFormat format = format_of(figure, model_.interpretation);
        if (own.relation == Relation::printing) {
            finding.cite(Relation::printing,
                         fmt::format("{} has more digits than numbers {}.", figure.printed, describe(format)),
                         {correction.figure});
            return;
        }
        if (const auto rays = rays_of(model_, own); rays && !possible_hits(own.values, *rays)) {
            finding.cite(
                Relation::integrality,
                fmt::format("No whole number of {} rays is printed as {} ({:.2f} hits).", *rays, figure.printed,
                            parse_printed(figure.printed)->value() * static_cast<double>(*rays)),
                {correction.figure});
        }
        if (own.kind == ConstraintKind::deviation) {
            explain_error(own, correction, finding);
            return;
        }
        const Term& quantity = own.terms.front();
        std::vector<Range> ranges = best_.diagnosis.ranges;
        ranges[quantity.variable] = model_.system.variables[quantity.variable].range;
        for (const Constraint& constraint : model_.system.constraints) {
            if (constraint.suspect && is_blamed(*constraint.suspect)) continue;
            for (std::size_t k = 0; k < constraint.terms.size(); ++k) {
                if (constraint.terms[k].variable != quantity.variable) continue;
                const Range allowed = project(constraint, model_.system, ranges, k);
                add_evidence(constraint, quantity, allowed, own.values, finding);
            }
        }
    }

    void explain_error(const Constraint& own, const Correction& correction, Finding& finding) const {
        const std::string text =
            own.relation == Relation::relative_error
                ? fmt::format("A value of {} lies {} % off the reference {:.9g}.",
                              in_words(best_.diagnosis.ranges[own.terms.front().variable]), in_words(correction.values),
                              own.reference)
                : fmt::format("The errors of the rows add up to {} %.", in_words(correction.values));
        finding.cite(own.relation, text, prints_of(model_, own.terms));
    }

    void add_evidence(const Constraint& constraint, const Term& quantity, Range allowed, Range printed,
                      Finding& finding) const {
        const double low = allowed.low * quantity.factor;
        const double high = allowed.high * quantity.factor;
        if (printed.meets({low, high})) return;
        if (constraint.relation == Relation::row_sum && !is_stated(constraint.terms.front().variable)) return;
        finding.cite(constraint.relation, fmt::format("{} leaves {}.", reason(constraint), in_words({low, high})),
                     figures_behind(model_, constraint));
    }

    /// Whether anything but its pairs determines a row sum; otherwise it is not evidence about them.
    [[nodiscard]] bool is_stated(std::size_t sum) const {
        return std::ranges::any_of(model_.system.constraints, [&](const auto& c) {
            return c.relation != Relation::row_sum &&
                   std::ranges::any_of(c.terms, [&](const Term& term) { return term.variable == sum; });
        });
    }

    std::string reason(const Constraint& constraint) const {
        switch (constraint.relation) {
            case Relation::row_sum:
                return fmt::format("The sum of row {}", row_of(constraint.terms.front().variable));
            case Relation::reciprocity:
                return fmt::format("Reciprocity{} ({})",
                                   model_.experiment.rays_per_face ? ", as far as chance allows," : "",
                                   both_ways(model_, constraint));
            case Relation::closure:
                return "Closure (a row of own rays sums to 1)";
            case Relation::parity:
                return "Reciprocity (every pair counts twice in the row sums)";
            case Relation::plausibility:
                return "Chance (the exact distribution of the method)";
            case Relation::relative_error:
                return "The printed relative error";
            case Relation::sum_of_relative_errors:
                return "The printed sum of relative errors";
            default:
                return "Another print of the same quantity";
        }
    }

    /// Label of the face whose row sum is `variable`; the first of faces that look alike.
    [[nodiscard]] std::string row_of(std::size_t variable) const {
        const auto found = std::ranges::find(model_.sums, variable);
        return model_.facts.labels[static_cast<std::size_t>(found - model_.sums.begin())];
    }

    void add_alternatives(const std::vector<std::size_t>& group, Finding& finding) const {
        constexpr double as_likely = 0.3;  // powers of ten: less than twice as improbable
        constexpr std::size_t most_named = 3;
        std::vector<std::string> equal;
        for (std::size_t d = 1; d < diagnoses_.size(); ++d) {
            const JudgedDiagnosis& other = diagnoses_[d];
            const auto spared = without(best_.diagnosis.blamed, other.diagnosis.blamed);
            const bool mine =
                std::ranges::any_of(group, [&](std::size_t s) { return std::ranges::find(spared, s) != spared.end(); });
            if (!mine) continue;
            std::vector<std::string> parts;
            for (const std::size_t s : without(other.diagnosis.blamed, best_.diagnosis.blamed)) {
                const Suspect& suspect = model_.system.suspects[s];
                if (suspect.figures.empty()) {
                    parts.push_back(fmt::format("not true that {}", suspect.assumption));
                    continue;
                }
                for (const Correction& correction : other.corrections) {
                    if (correction.figure != suspect.figures.front()) continue;
                    parts.push_back(fmt::format("{} should be {}{}", quote(model_.tables, correction.figure),
                                                correction.certain ? "" : "near ", correction.meant));
                }
                finding.involved.insert(finding.involved.end(), suspect.figures.begin(), suspect.figures.end());
            }
            const std::string instead = fmt::format("{}", fmt::join(parts, "; "));
            finding.alternatives.push_back(fmt::format("Instead: {}.", instead));
            if (other.improbability < best_.improbability + as_likely) equal.push_back(instead);
        }
        if (equal.empty() || finding.blamed.empty()) return;
        const bool more = equal.size() > most_named;
        equal.resize(std::min(equal.size(), most_named));
        finding.statement +=
            fmt::format(" As likely, instead {}{}.", fmt::join(equal, ", or "), more ? ", or one of others" : "");
    }

    const ExperimentModel& model_;
    const std::vector<JudgedDiagnosis>& diagnoses_;
    const JudgedDiagnosis& best_;
};

}  // namespace

std::vector<Finding> explain_diagnosis(const ExperimentModel& model, const std::vector<JudgedDiagnosis>& diagnoses) {
    return Explainer(model, diagnoses).explain();
}

}  // namespace ff::studies::audit
