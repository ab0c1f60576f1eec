#include "reports/labels.hpp"
#include "reports/slope_words.hpp"
#include "reports/terminal_sections.hpp"

#include <fmt/format.h>

namespace ff::reports {

std::string terminal_slopes(const studies::StudyResults& results) {
    if (results.slopes.empty()) return {};
    const studies::StudyPlan& plan = results.findings.plan;
    std::string out =
        fmt::format("\nSlopes of ln(error) on ln(N), ± half of the {:g} % interval\n", 100 * plan.spec.level);
    out += fmt::format("{:<15} {:<22} {:<8}  {:>10}  {:>10}  {:<14}  {}\n", "method", "sizes", "pairs", "RMSE",
                       "median", "theory", "verdict");
    for (const studies::LadderSlopes& ladder : results.slopes) {
        const std::string scene = plan.scenes.size() == 1 ? std::string() : plan.scenes[ladder.ladder.scene].name + " ";
        std::string method = scene + ladder.ladder.label;
        std::string sizes = sizes_text(plan, ladder.ladder);
        for (const studies::ClassSlopes& found : ladder.classes) {
            out += fmt::format("{:<15} {:<22} {:<8}  {:>10}  {:>10}  {:<14}  {}\n", method, sizes,
                               name(found.pair_class), slope_text(found.rmse), slope_text(found.median),
                               expected_text(found.judged()), finding_in_words(found));
            method.clear();
            sizes.clear();
        }
    }
    return out;
}

}  // namespace ff::reports
