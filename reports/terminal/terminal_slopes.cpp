#include "reports/tables/tables.hpp"
#include "reports/terminal/terminal_sections.hpp"
#include "reports/text/text_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string_view>
#include <vector>

namespace ff::reports {

std::string terminal_slopes(const studies::StudyResults& results, Colour colour) {
    if (results.slopes.empty()) return {};
    std::string out = fmt::format("\nSlopes of ln(error) on ln(N), ± half of the {:g} % interval\n",
                                  100 * results.findings.plan.spec.level);
    const Table table = slopes_table(results);
    std::array<std::size_t, 7> widths{15, 22, 8, 10, 10, 14, 0};
    for (const auto& row : table.rows) {
        for (std::size_t i = 0; i < row.size(); ++i) widths.at(i) = std::max(widths.at(i), visible_length(row[i].text));
    }
    const auto line = [&](const std::vector<std::string_view>& text, const std::string& verdict) {
        out += fmt::format("{:<{}} {:<{}} {:<{}}  {:>{}}  {:>{}}  {:<{}}  {}\n", text[0], widths[0], text[1], widths[1],
                           text[2], widths[2], text[3], widths[3], text[4], widths[4], text[5], widths[5], verdict);
    };
    line({"method", "sizes", "pairs", "RMSE", "median", "theory"}, "verdict");
    for (const auto& row : table.rows) {
        line({row[0].text, row[1].text, row[2].text, row[3].text, row[4].text, row[5].text},
             painted(row[6].text, row[6].mark, colour));
    }
    return out;
}

}  // namespace ff::reports
