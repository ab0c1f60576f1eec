#include "reports/csv/csv.hpp"
#include "reports/csv/csv_field.hpp"
#include "reports/csv/csv_records.hpp"
#include "reports/json/json_cells.hpp"
#include "reports/json/json_laboratory.hpp"
#include "reports/text/labels.hpp"
#include "reports/text/numbers.hpp"

#include <fmt/format.h>

namespace ff::reports {

void write_comparisons_csv(std::ostream& out, const studies::StudyResults& results, Timed timed) {
    CsvRecords csv(out,
                   "study,scene,pair_class,equal,budget,better=better/method,"
                   "better_patches_per_face=better/patches_per_face,better_samples_per_patch=better/samples_per_patch,"
                   "better_repeats=better/repeats,better_group=better/group,worse=worse/method,"
                   "worse_patches_per_face=worse/patches_per_face,worse_samples_per_patch=worse/samples_per_patch,"
                   "worse_repeats=worse/repeats,worse_group=worse/group,ratio,ratio_ci_low=interval/low,"
                   "ratio_ci_high=interval/high,level,apart");
    const studies::StudySpec& spec = results.findings.plan.spec;
    for (Json& contest : contests_json(results, timed)) {
        const Json ratios = std::move(contest["ratios"]);
        const Json entrants = std::move(contest["entrants"]);
        contest.update({{"study", spec.name}, {"level", spec.level}});
        for (Json ratio : ratios) {
            for (const char* side : {"better", "worse"}) ratio[side] = entrants[ratio[side].get<std::size_t>()];
            ratio.update(contest);
            csv.add(ratio);
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
        const Scene& scene = plan.scenes[plan.cells[row.cell].scene];
        Json record = in_cell(plan, row.cell, rows[i]);
        record["worst_from"] = from_label(scene, row.worst_pair);
        record["worst_to"] = to_label(scene, row.worst_pair);
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
    for (std::size_t i = 0; i < rows.size(); ++i) csv.add(in_cell(plan, results.coverage[i].cell, rows[i]));
}

}  // namespace ff::reports
