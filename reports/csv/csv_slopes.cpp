#include "reports/csv/csv.hpp"
#include "reports/csv/csv_records.hpp"
#include "reports/json/json_slopes.hpp"

namespace ff::reports {
void write_slopes_csv(std::ostream& out, const studies::StudyResults& results) {
    CsvRecords csv(out,
                   "study,scene,method,pair_class,from_face,to_face,statistic,slope,slope_ci_low=interval/low,"
                   "slope_ci_high=interval/high,expected=expected/rate,lack_of_fit_p,points");
    const studies::StudyPlan& plan = results.findings.plan;
    for (const studies::LadderSlopes& ladder : results.slopes) {
        const Scene& scene = plan.scenes[ladder.ladder.scene];
        const auto write = [&](const studies::Slope& slope) {
            Json record{{"study", plan.spec.name}, {"scene", scene.name}, {"method", ladder.ladder.label}};
            record.update(slope_json(scene, slope));
            csv.add(record);
        };
        for (const studies::ClassSlopes& found : ladder.classes) {
            write(found.rmse);
            write(found.median);
        }
        for (const studies::Slope& slope : ladder.pairs) write(slope);
    }
}

}  // namespace ff::reports
