#include "reports/csv/csv.hpp"
#include "reports/csv/csv_field.hpp"
#include "reports/text/labels.hpp"
#include "reports/text/numbers.hpp"

#include <fmt/format.h>

namespace ff::reports {
namespace {

std::string entrant_fields(const studies::StudyPlan& plan, const studies::Entrant& entrant) {
    const studies::Cell& cell = plan.cells[entrant.cell];
    return fmt::format("{},{},{},{},{}", csv_field(plan.spec.methods[cell.method].name), cell.subdivision.per_part(),
                       cell.samples, exact(entrant.repeats), entrant.group + 1);
}

}  // namespace

void write_comparisons_csv(std::ostream& out, const studies::StudyResults& results, Timed timed) {
    out << "study,scene,pair_class,equal,budget,better,better_patches_per_face,better_samples_per_patch,better_repeats,"
           "better_group,worse,worse_patches_per_face,worse_samples_per_patch,worse_repeats,worse_group,ratio,"
           "ratio_ci_low,ratio_ci_high,level\n";
    const studies::StudyPlan& plan = results.findings.plan;
    for (const studies::Contest& contest : results.contests) {
        if ((contest.equal == studies::Equal::processor_time) != (timed == Timed::yes)) continue;
        for (const studies::Handicap& handicap : contest.handicaps) {
            const auto& interval = handicap.interval;
            out << fmt::format(
                "{},{},{},{},{},{},{},{},{},{},{}\n", csv_field(plan.spec.name),
                csv_field(plan.scenes[contest.scene].name), name(contest.pair_class), studies::name(contest.equal),
                exact(contest.budget), entrant_fields(plan, contest.entrants[handicap.better]),
                entrant_fields(plan, contest.entrants[handicap.worse]), exact(handicap.ratio),
                interval ? exact(interval->low) : "", interval ? exact(interval->high) : "", exact(plan.spec.level));
        }
    }
}

void write_claimed_errors_csv(std::ostream& out, const studies::StudyResults& results) {
    out << "study,scene,method,patches_per_face,samples_per_patch,pair_class,claimant,promised,claims,held,worst_from,"
           "worst_to,worst_held,worst_share_ci_low,worst_share_ci_high,median_ratio,largest_ratio,finding\n";
    const studies::StudyPlan& plan = results.findings.plan;
    for (const studies::ClaimedErrors& row : results.claimed_errors) {
        const studies::Cell& cell = plan.cells[row.cell];
        const Scene& scene = plan.scenes[cell.scene];
        out << fmt::format("{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{}\n", csv_field(plan.spec.name),
                           csv_field(scene.name), csv_field(plan.spec.methods[cell.method].name),
                           cell.subdivision.per_part(), cell.samples, name(row.pair_class), studies::name(row.claimant),
                           exact(row.promised), row.claims, row.held, csv_field(from_label(scene, row.worst)),
                           csv_field(to_label(scene, row.worst)), row.worst_held, exact(row.worst_share.low),
                           exact(row.worst_share.high), exact(row.median_ratio), exact(row.largest_ratio),
                           row.finding == studies::ClaimFinding::fails ? "fails" : "not_refuted");
    }
}

}  // namespace ff::reports
