#include "reports/pictures/pictures.hpp"
#include "reports/pictures/ranking_rows.hpp"
#include "reports/text/labels.hpp"
#include "studies/diagnostics/claimed_errors.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string>

namespace ff::reports {

std::optional<Picture> claims_picture(const studies::StudyResults& results) {
    const auto& claims = results.claimed_errors;
    const auto fails = [](const studies::ClaimedErrors& each) {
        return each.finding == studies::ClaimedErrorFinding::fails;
    };
    const auto failing = std::count_if(claims.begin(), claims.end(), fails);
    const bool is_stated = std::any_of(claims.begin(), claims.end(), [](const studies::ClaimedErrors& each) {
        return each.claimant != studies::Claimant::one_run;
    });
    if (!is_stated && failing == 0) return std::nullopt;
    const studies::StudyPlan& plan = results.findings.plan;
    const MethodChoice all;
    RankingRows rows(plan, all);
    std::string heading;
    for (const PairClass pair_class : {PairClass::parallel, PairClass::adjacent, PairClass::other}) {
        for (const studies::ClaimedErrors& each : claims) {
            const studies::Cell& cell = plan.cells[each.cell];
            const std::string its_heading = heading_of(plan, cell.scene, pair_class);
            constexpr std::size_t most_rows = 40;
            if (each.pair_class != pair_class || rows.rows() == most_rows) continue;
            if (its_heading != heading) {
                if (rows.full()) break;
                rows.heading(its_heading);
                heading = its_heading;
            }
            const studies::Method& method = plan.spec.methods[cell.method];
            const double share = static_cast<double>(each.worst_held) / static_cast<double>(cell.trials);
            rows.add({.label = fmt::format("{}{}{}", method.name,
                                           method.sizes.size() > 1 ? ", " + size_label(plan, cell) : "",
                                           each.claimant == studies::Claimant::one_run ? ", as random" : ""),
                      .method = cell.method,
                      .size = size_label(plan, cell),
                      .value = share,
                      .interval = each.worst_share_interval,
                      .expected = each.promised,
                      .group = fails(each) ? "fails" : ""});
        }
    }
    RankingText text;
    text.id = "claimed-errors";
    text.title = "How often claimed errors hold";
    text.axis = "share of runs within the claimed error, on the worst pair";
    text.finding = fmt::format("{} of {} claims about errors {} not hold as often as they should.", failing,
                               claims.size(), failing == 1 ? "does" : "do");
    text.description = "The line across a row is the share in which the claim should hold. " + text.finding;
    return ranking_picture(results, text, {}, rows);
}

}  // namespace ff::reports
