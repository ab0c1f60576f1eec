#include "reports/words/findings/claim_words.hpp"

#include "samplers/sampler.hpp"
#include "stats/basics/distributions.hpp"
#include "studies/diagnostics/claimed_errors.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace ff::reports {

std::vector<std::string> one_run_errors_in_brief(const studies::StudyResults& results) {
    const studies::StudyPlan& plan = results.findings.plan;
    double least = 1;
    double most = 0;
    std::size_t rows = 0;
    for (const studies::ClaimedErrors& row : results.claimed_errors) {
        const studies::Method& method = plan.spec.methods[plan.cells[row.cell].method];
        if (row.claimant != studies::Claimant::one_run || samplers::find(method.sampler).info.independent()) continue;
        ++rows;
        least = std::min(least, row.share());
        most = std::max(most, row.share());
    }
    if (rows == 0) return {};
    const double level = plan.spec.level;
    const std::string range =
        least == most ? fmt::format("{:.3g}", 100 * least) : fmt::format("{:.3g} to {:.3g}", 100 * least, 100 * most);
    return {
        fmt::format("If the rays of a set are taken as independent, {:.3g} standard errors of one run hold in {} % of "
                    "runs and pairs, not {:g} %.",
                    stats::normal_critical((1 - level) / 2), range, 100 * level)};
}

}  // namespace ff::reports
