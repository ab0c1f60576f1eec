#include "reports/words/cells_in_between.hpp"

#include <iterator>

namespace ff::reports {

std::set<std::size_t> cells_in_between(const studies::StudyResults& results) {
    std::set<std::size_t> hidden;
    for (const studies::LadderSlopes& ladder : results.slopes) {
        const auto& cells = ladder.ladder.cells;
        if (cells.size() < studies::long_ladder) continue;
        hidden.insert(std::next(cells.begin()), std::prev(cells.end()));
    }
    for (const studies::OcclusionSeries& series : results.occlusion) {
        for (const studies::HiddenPair& scene : series.scenes) {
            for (const studies::CellAnalysis& found : results.findings.cells) {
                if (results.findings.plan.cells[found.cell].scene == scene.scene) hidden.insert(found.cell);
            }
        }
    }
    for (const studies::CellAnalysis& found : results.findings.cells) {
        const bool remarkable =
            found.lost_rays > 0 || (found.bias && found.bias_finding == studies::BiasFinding::biased);
        if (remarkable || found.equivalence == studies::EquivalenceFinding::refuted) hidden.erase(found.cell);
    }
    for (const studies::Rivalry& rivalry : results.rivals) {
        if (!results.occlusion.empty()) break;
        hidden.erase(results.findings.cells[rivalry.better].cell);
        if (rivalry.worse) hidden.erase(results.findings.cells[*rivalry.worse].cell);
    }
    return hidden;
}

}  // namespace ff::reports
