#include "reports/words/findings/printed_errors.hpp"

#include "reports/text/numbers.hpp"
#include "studies/published/published.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace ff::reports {

PrintedErrors printed_errors(const studies::StudyResults& results, std::size_t cell, PairClass pair_class) {
    const studies::PublishedResults& published = *results.published;
    PrintedErrors errors{.cell = cell, .pair_class = pair_class};
    for (const studies::TableComparison& table : published.comparisons) {
        for (const studies::FigureComparison& c : table.figures) {
            const studies::Figure& figure = published.tables.figures[c.figure];
            if (c.cell != cell || !c.ours || figure.kind != studies::FigureKind::form_factor) continue;
            const studies::Summary& summary = results.findings.cells[cell].summary(c.quantity);
            if (summary.pair_class != pair_class || !summary.reference || *summary.reference == 0) continue;
            ++errors.figures;
            const double off = c.printed - *summary.reference;
            errors.printed += std::abs(off / *summary.reference);
            errors.ours += std::abs(*c.ours / *summary.reference - 1);
            errors.printed_rms += off * off;
            errors.differs |= std::abs(c.printed - *c.ours) > 2 * studies::half_printed_unit(figure.printed);
        }
    }
    const auto count = static_cast<double>(std::max<std::size_t>(errors.figures, 1));
    errors.printed /= count;
    errors.ours /= count;
    errors.printed_rms = std::sqrt(errors.printed_rms / count);
    return errors;
}

std::string as_printed(const studies::StudyResults& results, const studies::Ranked& first,
                       const studies::Ranked& second, PairClass pair_class) {
    if (!results.published) return {};
    bool differs = false;
    const auto error_of = [&](const studies::Ranked& one) {
        const std::size_t cell = results.findings.cells[one.index].cell;
        if (!results.findings.plan.cells[cell].deterministic) return one.value;
        const PrintedErrors errors = printed_errors(results, cell, pair_class);
        differs = differs || errors.differs;
        return errors.differs ? errors.printed_rms : one.value;
    };
    const double times = error_of(second) / error_of(first);
    return differs ? fmt::format("; in print {}", brief(times, 2)) : std::string();
}

}  // namespace ff::reports
