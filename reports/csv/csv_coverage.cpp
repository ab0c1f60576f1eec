#include "reports/csv/csv.hpp"
#include "reports/csv/csv_field.hpp"
#include "reports/text/numbers.hpp"

#include <fmt/format.h>

namespace ff::reports {

void write_coverage_csv(std::ostream& out, const studies::StudyResults& results) {
    out << "study,scene,method,patches_per_face,samples_per_patch,pair_class,interval_method,replicates,mean_trials,"
           "intervals,covered,coverage,coverage_ci_low,coverage_ci_high,level,short_of_nominal\n";
    const studies::StudyPlan& plan = results.findings.plan;
    for (const studies::Coverage& row : results.coverage) {
        const studies::Cell& cell = plan.cells[row.cell];
        out << fmt::format("{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{}\n", csv_field(plan.spec.name),
                           csv_field(plan.scenes[cell.scene].name), csv_field(plan.spec.methods[cell.method].name),
                           cell.subdivision.per_part(), cell.samples, name(row.pair_class), studies::name(row.rule),
                           row.replicates, exact(row.mean_trials), row.intervals, row.covered, exact(row.share()),
                           exact(row.actual.low), exact(row.actual.high), exact(plan.spec.level),
                           row.short_of_nominal ? "true" : "false");
    }
}

}  // namespace ff::reports
