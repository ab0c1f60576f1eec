#include "reports/csv/csv.hpp"
#include "reports/csv/csv_field.hpp"
#include "reports/text/labels.hpp"
#include "reports/text/numbers.hpp"

#include <fmt/format.h>

#include <vector>

namespace ff::reports {
namespace {

std::string slope_fields(const Scene& scene, const studies::Slope& slope) {
    const auto& interval = slope.interval;
    const std::vector<std::string> fields{std::string(name(slope.pair_class)),
                                          slope.pair ? csv_field(from_label(scene, *slope.pair)) : std::string(),
                                          slope.pair ? csv_field(to_label(scene, *slope.pair)) : std::string(),
                                          std::string(studies::name(slope.error)),
                                          exact(slope.slope),
                                          interval ? exact(interval->low) : std::string(),
                                          interval ? exact(interval->high) : std::string(),
                                          slope.expected ? exact(slope.expected->rate) : std::string(),
                                          exact(slope.lack_of_fit_p),
                                          std::to_string(slope.points)};
    return fmt::format("{}", fmt::join(fields, ","));
}

}  // namespace

void write_slopes_csv(std::ostream& out, const studies::StudyResults& results) {
    out << "study,scene,method,pair_class,from_face,to_face,statistic,slope,slope_ci_low,slope_ci_high,expected,"
           "lack_of_fit_p,points\n";
    const studies::StudyPlan& plan = results.findings.plan;
    for (const studies::LadderSlopes& ladder : results.slopes) {
        const Scene& scene = plan.scenes[ladder.ladder.scene];
        const std::string prefix =
            fmt::format("{},{},{}", csv_field(plan.spec.name), csv_field(scene.name), csv_field(ladder.ladder.label));
        const auto write = [&](const studies::Slope& slope) {
            out << prefix << ',' << slope_fields(scene, slope) << '\n';
        };
        for (const studies::ClassSlopes& found : ladder.classes) {
            write(found.rmse);
            write(found.median);
        }
        for (const studies::Slope& slope : ladder.pairs) write(slope);
    }
}

}  // namespace ff::reports
