#include "studies/audit/value_format.hpp"

#include <algorithm>

namespace ff::studies::audit {
namespace {

bool is_value_of(const Figure& figure, const std::string& method) {
    return figure.method == method && (figure.kind == FigureKind::form_factor || figure.kind == FigureKind::row_sum);
}

bool has_readings(const PublishedTables& tables, const std::string& table) {
    return std::any_of(tables.readings.begin(), tables.readings.end(),
                       [&](const Reading& reading) { return reading.table == table; });
}

InferredFormat sampled_format(const PublishedTables& tables, const std::string& method) {
    std::vector<SampledFigure> figures;
    std::vector<SampledFigure> uncertain;
    for (const Figure& figure : tables.figures) {
        if (!is_value_of(figure, method)) continue;
        const SampledFigure sampled{*parse_printed(figure.printed),
                                    *figure.samples_per_patch * figure.patches_per_face};
        (has_readings(tables, figure.table) ? uncertain : figures).push_back(sampled);
    }
    InferredFormat finding{.method = method, .format = {}, .evidence = {}};
    finding.evidence = weigh_formats(figures.empty() ? uncertain : figures, tables.decimals);
    finding.format = finding.evidence.front().format;
    return finding;
}

InferredFormat deterministic_format(const PublishedTables& tables, const std::string& method) {
    int most = 0;
    int least = 99;
    const NumberFormat significant{Rounding::rounded, Layout::significant_digits, tables.decimals};
    bool fits_significant = true;
    for (const Figure& figure : tables.figures) {
        if (!is_value_of(figure, method)) continue;
        const PrintedNumber number = *parse_printed(figure.printed);
        most = std::max(most, number.decimals);
        least = std::min(least, number.decimals);
        fits_significant = fits_significant && printed_range(number, significant);
    }
    NumberFormat format{Rounding::rounded, Layout::fixed_decimals, most};
    if (most != least && fits_significant) format = significant;
    if (tables.rule == PrintingRule::truncated) format.rounding = Rounding::truncated;
    return {.method = method, .format = format, .evidence = {}};
}

}  // namespace

InferredFormat infer_format(const PublishedTables& tables, const std::string& method) {
    const auto& sampling = tables.sampling_methods;
    const bool sampled = std::find(sampling.begin(), sampling.end(), method) != sampling.end();
    return sampled ? sampled_format(tables, method) : deterministic_format(tables, method);
}

}  // namespace ff::studies::audit
