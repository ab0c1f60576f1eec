#include "studies/audit/value_format.hpp"

#include "studies/audit/diagnosis.hpp"
#include "studies/audit/experiment.hpp"
#include "studies/audit/experiment_model.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace ff::studies::audit {
namespace {

/// How the publication says that digits are dropped; empty where it does not.
std::optional<Rounding> stated_rounding(const PublishedTables& tables) {
    if (tables.rule == PrintingRule::unstated) return std::nullopt;
    return tables.rule == PrintingRule::rounded ? Rounding::rounded : Rounding::truncated;
}

InferredFormat sampled_format(const PublishedTables& tables, const std::string& method) {
    std::vector<SampledFigure> figures;
    std::vector<SampledFigure> uncertain;
    for (const Figure& figure : tables.figures) {
        if (figure.method != method || !is_value(figure)) continue;
        const SampledFigure sampled{*parse_printed(figure.printed),
                                    *figure.samples_per_patch * figure.patches_per_face};
        (has_readings(tables, figure.table) ? uncertain : figures).push_back(sampled);
    }
    InferredFormat finding{.method = method, .format = {}, .candidates = {}, .evidence = {}};
    finding.evidence = weigh_formats(figures.empty() ? uncertain : figures, tables.decimals);
    for (const FormatEvidence& evidence : finding.evidence) finding.candidates.push_back(evidence.format);
    const double best = finding.evidence.front().log_likelihood;
    const auto chosen = std::ranges::find_if(finding.evidence, [&](const FormatEvidence& e) {
        return e.format.rounding == stated_rounding(tables).value_or(e.format.rounding);
    });
    finding.format =
        best - chosen->log_likelihood > std::log(refuting_odds) ? finding.candidates.front() : chosen->format;
    return finding;
}

InferredFormat deterministic_format(const PublishedTables& tables, const std::string& method) {
    int most = 0;
    int least = 99;
    const NumberFormat significant{Rounding::rounded, Layout::significant_digits, tables.decimals};
    bool fits_significant = true;
    for (const Figure& figure : tables.figures) {
        if (figure.method != method || !is_value(figure)) continue;
        const PrintedNumber number = *parse_printed(figure.printed);
        most = std::max(most, number.decimals);
        least = std::min(least, number.decimals);
        fits_significant = fits_significant && printed_range(number, significant);
    }
    NumberFormat format{Rounding::rounded, Layout::fixed_decimals, most};
    if (most != least && fits_significant) format = significant;
    NumberFormat other = format;
    other.rounding = Rounding::truncated;
    if (stated_rounding(tables) == Rounding::truncated) std::swap(format, other);
    return {.method = method, .format = format, .candidates = {format, other}, .evidence = {}};
}

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
        if (spread && spread->is_implausible(judgement.spread_level)) causes += 1;
    }
    return causes;
}

}  // namespace

InferredFormat infer_format(const PublishedTables& tables, const std::string& method) {
    return is_sampling(tables, method) ? sampled_format(tables, method) : deterministic_format(tables, method);
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
    const auto other =
        std::ranges::find_if(inferred.evidence, [&](const FormatEvidence& e) { return e.format.rounding == *stated; });
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
