#include "reports/words/findings/tail_words.hpp"

#include "reports/text/labels.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace ff::reports {

std::vector<std::string> heavy_tails_in_brief(const studies::StudyResults& results) {
    const studies::StudyPlan& plan = results.findings.plan;
    std::vector<std::string> lines;
    for (const studies::CellAnalysis& found : results.findings.cells) {
        const auto of_cell = [&](const studies::HeavyTail& tail) { return tail.cell == found.cell; };
        const auto first = std::find_if(results.heavy_tails.begin(), results.heavy_tails.end(), of_cell);
        if (first == results.heavy_tails.end()) continue;
        const studies::Cell& cell = plan.cells[found.cell];
        lines.push_back(fmt::format(
            "WARNING {}: {} pairs look as if their variance were infinite (tail index {:.2f} for {}, 2 is the limit); "
            "their intervals and RMSE are not to be trusted.",
            cell_label(plan, cell), std::count_if(results.heavy_tails.begin(), results.heavy_tails.end(), of_cell),
            first->index, quantity_label(plan.scenes[cell.scene], first->pair)));
    }
    return lines;
}

}  // namespace ff::reports
