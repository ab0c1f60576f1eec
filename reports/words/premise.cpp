#include "reports/words/premise.hpp"

#include "reports/text/labels.hpp"
#include "reports/text/numbers.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace ff::reports {
namespace {

/// The printed and the computed errors of a deterministic cell on a class of pairs.
struct PrintedErrors {
    std::size_t cell = 0;
    PairClass pair_class = PairClass::other;
    std::size_t figures = 0;
    double printed = 0;      ///< mean relative error
    double ours = 0;         ///< the same
    double printed_rms = 0;  ///< root mean square of printed - exact
    bool differs = false;    ///< by more than printing makes
};

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

/// "17.9 million kernel values"
std::string cost(const studies::Analysis& findings, std::size_t cell) {
    const studies::Method& method = findings.plan.spec.methods[findings.plan.cells[cell].method];
    const auto evaluations = static_cast<double>(findings.cells[cell].evaluations_per_face);
    return fmt::format("{:.3g} million {}", evaluations / 1e6, estimator_info(method).evaluations);
}

std::string in_words(const studies::StudyResults& results, const PrintedErrors& errors,
                     const std::vector<std::size_t>& cells) {
    const studies::Analysis& findings = results.findings;
    const studies::StudyPlan& plan = findings.plan;
    const auto method = [&](std::size_t cell) { return plan.spec.methods[plan.cells[cell].method].name; };
    const std::string where = on_pairs(plan, plan.cells[errors.cell].scene, name(errors.pair_class));
    std::string text = fmt::format(
        "{} as described does not give the figures printed for it: {} its mean error is {:.3g} % here and {:.3g} % in "
        "print.",
        method(errors.cell), where, 100 * errors.ours, 100 * errors.printed);
    const studies::ClassError& own = *findings.cells[errors.cell].class_error(errors.pair_class);
    for (const std::size_t cell : cells) {
        const studies::ClassError* other = findings.cells[cell].class_error(errors.pair_class);
        if (cell == errors.cell || other == nullptr || !other->interval) continue;
        const auto ratio = studies::ratio_interval(*log_rmse(*other), *log_rmse(own, true), plan.spec.level);
        text += fmt::format(
            " The RMSE of {} ({} per face) is {} to {} times that of {} ({}) by these figures, and {} times by the "
            "printed ones.",
            method(errors.cell), cost(findings, errors.cell), brief(ratio->low), brief(ratio->high), method(cell),
            cost(findings, cell), brief(errors.printed_rms / other->rmse, 2));
    }
    return text;
}

}  // namespace

std::string premise(const studies::StudyResults& results) {
    const studies::StudyPlan& plan = results.findings.plan;
    for (std::size_t scene = 0; scene < plan.scenes.size(); ++scene) {
        const auto cells = studies::compared_cells(results.findings, scene, results.published->comparisons);
        PrintedErrors worst;  // where print and computation differ most
        for (const std::size_t cell : cells) {
            if (!plan.cells[cell].deterministic) continue;
            for (const PairClass pair_class : {PairClass::parallel, PairClass::adjacent, PairClass::other}) {
                const PrintedErrors errors = printed_errors(results, cell, pair_class);
                if (errors.differs && std::abs(errors.printed - errors.ours) > std::abs(worst.printed - worst.ours))
                    worst = errors;
            }
        }
        if (worst.differs) return in_words(results, worst, cells);
    }
    return {};
}

}  // namespace ff::reports
