#include "studies/audit/format_choice.hpp"

#include "studies/audit/diagnosis.hpp"
#include "studies/audit/experiment_model.hpp"
#include "studies/audit/reciprocity.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace ff::studies::audit {
namespace {

constexpr double infinity_of_causes = std::numeric_limits<double>::infinity();

/// The cost of a format that contradicts the publication: as many misprints as have `refuting_odds` together.
double handicap(const PublishedTables& tables, NumberFormat format) {
    const auto stated = stated_rounding(tables);
    return !stated || *stated == format.rounding ? 0 : std::log(refuting_odds) / -std::log(misprint_share);
}

/// The fewest causes of all contradictions under a format; infinite where there are more than `most`. With a wrong
/// format many pairs seem to break reciprocity, so that giving up an assumption is the last resort.
double count_causes(const Judgement& judgement, std::span<const Experiment> experiments, NumberFormat format,
                    double most) {
    const Interpretation interpretation{format, judgement.references.rounding, judgement.references.reference};
    double causes = 0;
    for (const Experiment& experiment : experiments) {
        const ExperimentModel model = build_model(judgement.tables, judgement.facts, experiment, interpretation,
                                                  judgement.cache, judgement.z_limit);
        const auto diagnosis = find_cheapest(model.system, most - causes);
        if (!diagnosis) return infinity_of_causes;
        for (const std::size_t s : diagnosis->blamed) {
            const Suspect& suspect = model.system.suspects[s];
            causes += suspect.figures.empty() ? static_cast<double>(most_misprints) : suspect.cost;
        }
        const auto spread = spread_within(model, diagnosis->ranges);
        if (spread && is_implausible(*spread, judgement.spread_level)) causes += 1;
    }
    return causes;
}

}  // namespace

bool is_implausible(const JointDistance& spread, double level) {
    return spread.too_far < level || spread.too_close < level;
}

std::optional<Finding> judge_printing_rule(const PublishedTables& tables, const InferredFormat& inferred) {
    const auto stated = stated_rounding(tables);
    if (!stated || inferred.format.rounding == *stated) return std::nullopt;
    Finding f;
    f.id = fmt::format("printing rule: {}", inferred.method);
    f.relation = Relation::printing_rule;
    f.statement =
        fmt::format("The publication says that its figures are {}, but those of {} are {}.",
                    *stated == Rounding::rounded ? "rounded" : "truncated", inferred.method, describe(inferred.format));
    f.cite(Relation::printing_rule, fmt::format("Otherwise at least {:.0f} more figures would be wrong.",
                                                std::ceil(handicap(tables, inferred.format))));
    const auto add = [&](const FormatEvidence& e) {
        f.cite(Relation::integrality,
               fmt::format("{}: {} of {} figures are a whole number of hits, {:.1f} expected by chance (p = {:.2g}).",
                           describe(e.format), e.whole, e.figures, e.expected, e.chance));
    };
    for (const FormatEvidence& e : inferred.evidence) {
        if (e.format == inferred.format) add(e);
    }
    const auto other = std::find_if(inferred.evidence.begin(), inferred.evidence.end(),
                                    [&](const FormatEvidence& e) { return e.format.rounding == *stated; });
    if (other != inferred.evidence.end()) add(*other);
    return f;
}

NumberFormat choose_format(const Judgement& judgement, std::span<const Experiment> experiments,
                           const InferredFormat& inferred) {
    constexpr double half_a_figure = 0.5;
    NumberFormat best = inferred.format;
    double fewest = infinity_of_causes;
    for (const NumberFormat candidate : inferred.candidates) {
        const double paid = handicap(judgement.tables, candidate);
        const double most = fewest - half_a_figure - paid;
        if (most < 0) continue;
        const double causes = count_causes(judgement, experiments, candidate, most) + paid;
        if (causes > fewest - half_a_figure) continue;
        best = candidate;
        fewest = causes;
    }
    return best;
}

}  // namespace ff::studies::audit
