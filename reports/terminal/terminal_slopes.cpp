#include "reports/tables/tables.hpp"
#include "reports/terminal/terminal_sections.hpp"
#include "reports/text/text_table.hpp"

#include <fmt/format.h>

namespace ff::reports {

std::string terminal_slopes(const studies::StudyResults& results, const TextStyle& style) {
    if (results.slopes.empty()) return {};
    return fmt::format("\nSlopes of ln(error) on ln(N), ± half of the {:g} % interval\n{}",
                       100 * results.findings.plan.spec.level, text_table(slopes_table(results), style));
}

}  // namespace ff::reports
