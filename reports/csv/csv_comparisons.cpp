#include "reports/csv/csv.hpp"
#include "reports/csv/csv_field.hpp"
#include "reports/csv/csv_records.hpp"
#include "reports/json/json_cells.hpp"
#include "reports/json/json_laboratory.hpp"
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
    CsvRecords csv(out,
                   "study,scene,method,patches_per_face,samples_per_patch,pair_class,claimant,promised,claims,held,"
                   "worst_from,worst_to,worst_held,worst_share_ci_low=worst_share_interval/low,"
                   "worst_share_ci_high=worst_share_interval/high,median_ratio,largest_ratio,finding");
    const studies::StudyPlan& plan = results.findings.plan;
    const Json rows = claimed_errors_json(results);
    for (std::size_t i = 0; i < rows.size(); ++i) {
        const studies::ClaimedErrors& row = results.claimed_errors[i];
        const studies::Cell& cell = plan.cells[row.cell];
        Json record = in_cell(plan, row.cell, rows[i]);
        record["samples_per_patch"] = cell.samples;  // 0 for none
        record["worst_from"] = from_label(plan.scenes[cell.scene], row.worst);
        record["worst_to"] = to_label(plan.scenes[cell.scene], row.worst);
        csv.add(record);
    }
}

void write_coverage_csv(std::ostream& out, const studies::StudyResults& results) {
    CsvRecords csv(out,
                   "study,scene,method,patches_per_face,samples_per_patch,pair_class,interval_method,replicates,"
                   "mean_trials,intervals,covered,coverage,coverage_ci_low=coverage_interval/low,"
                   "coverage_ci_high=coverage_interval/high,level,short_of_nominal");
    const Json rows = coverage_json(results);
    const studies::StudyPlan& plan = results.findings.plan;
    for (std::size_t i = 0; i < rows.size(); ++i) {
        Json record = in_cell(plan, results.coverage[i].cell, rows[i]);
        record["samples_per_patch"] = plan.cells[results.coverage[i].cell].samples;  // 0 for none
        csv.add(record);
    }
}

}  // namespace ff::reports
