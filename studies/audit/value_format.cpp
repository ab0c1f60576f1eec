#include "studies/audit/value_format.hpp"

#include "studies/audit/experiment.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace ff::studies::audit {
namespace {

bool has_readings(const PublishedTables& tables, const std::string& table) {
    return std::any_of(tables.readings.begin(), tables.readings.end(),
                       [&](const Reading& reading) { return reading.table == table; });
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
    const auto chosen = std::find_if(finding.evidence.begin(), finding.evidence.end(), [&](const FormatEvidence& e) {
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

}  // namespace

std::optional<Rounding> stated_rounding(const PublishedTables& tables) {
    switch (tables.rule) {
        case PrintingRule::rounded:
            return Rounding::rounded;
        case PrintingRule::truncated:
            return Rounding::truncated;
        case PrintingRule::unstated:
            break;
    }
    return std::nullopt;
}

InferredFormat infer_format(const PublishedTables& tables, const std::string& method) {
    return is_sampling(tables, method) ? sampled_format(tables, method) : deterministic_format(tables, method);
}

}  // namespace ff::studies::audit
