#include "reports/pictures/pictures.hpp"
#include "reports/pictures/ranking_rows.hpp"
#include "reports/text/labels.hpp"
#include "studies/comparison/rivals.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <map>
#include <set>
#include <string_view>

namespace ff::reports {
namespace {

/// Sizes that are compared: from a power of two to the next. A ladder has one size in each.
struct Octave {
    std::map<std::uint64_t, std::size_t> sizes;  ///< evaluations per face, with how many cells have them
    std::set<std::size_t> methods;
    std::vector<std::size_t> cells;

    /// The size that most cells have.
    [[nodiscard]] std::uint64_t usual() const {
        return std::max_element(sizes.begin(), sizes.end(),
                                [](const auto& a, const auto& b) { return a.second < b.second; })
            ->first;
    }
};

std::map<int, Octave> octaves_of(const studies::Analysis& findings) {
    std::map<int, Octave> octaves;
    for (const studies::CellAnalysis& found : findings.cells) {
        if (found.evaluations_per_face == 0) continue;
        Octave& octave = octaves[static_cast<int>(std::bit_width(found.evaluations_per_face))];
        ++octave.sizes[found.evaluations_per_face];
        octave.methods.insert(findings.plan.cells[found.cell].method);
        octave.cells.push_back(found.cell);
    }
    std::erase_if(octaves, [](const auto& each) { return each.second.methods.size() < 2; });
    return octaves;
}

/// The method, with its size where that is not the usual one or where it has several.
std::string label_of(const studies::Analysis& findings, const Octave& octave, std::size_t cell) {
    const studies::StudyPlan& plan = findings.plan;
    const auto is_another = [&](std::size_t other) {
        return other != cell && plan.cells[other].method == plan.cells[cell].method &&
               plan.cells[other].scene == plan.cells[cell].scene;
    };
    if (std::any_of(octave.cells.begin(), octave.cells.end(), is_another)) return cell_label(plan, plan.cells[cell]);
    const std::string& method = plan.spec.methods[plan.cells[cell].method].name;
    const std::uint64_t size = findings.cells[cell].evaluations_per_face;
    return size == octave.usual() ? method : fmt::format("{} ({})", method, size);
}

}  // namespace

std::vector<Picture> errors_at_sizes(const studies::StudyResults& results, const MethodChoice& methods) {
    const studies::Analysis& findings = results.findings;
    const studies::StudyPlan& plan = findings.plan;
    std::vector<Picture> pictures;
    for (const auto& entry : octaves_of(findings)) {
        const auto& octave = entry.second;
        RankingRows rows(plan, methods);
        for (std::size_t scene = 0; scene < plan.scenes.size(); ++scene) {
            std::vector<std::size_t> cells = octave.cells;
            std::erase_if(cells, [&](std::size_t cell) { return plan.cells[cell].scene != scene; });
            const auto luck = std::stable_partition(cells.begin(), cells.end(), [&](std::size_t cell) {
                return !studies::may_be_luck(plan, plan.cells[cell]);
            });
            const std::vector<std::size_t> unranked(luck, cells.end());
            cells.erase(luck, cells.end());
            for (const PairClass pair_class : {PairClass::parallel, PairClass::adjacent, PairClass::other}) {
                const auto ranked = studies::rank_errors(findings, cells, pair_class, plan.spec.level);
                const auto others = studies::rank_errors(findings, unranked, pair_class, plan.spec.level);
                if (ranked.size() + others.size() < 2 || rows.full()) continue;
                rows.heading(heading_of(plan, scene, pair_class));
                const auto add = [&](const studies::Ranked& each, const std::string& group) {
                    RankedMethod row = ranked_cell(plan, each, group);
                    row.label = label_of(findings, octave, each.index);
                    rows.add(row);
                };
                for (const studies::Ranked& each : ranked) add(each, letter(ranked, each));
                for (const studies::Ranked& each : others) add(each, "");
            }
        }
        if (rows.rows() < 2) continue;
        const std::string name = fmt::format("errors at {} evaluations per face", octave.usual());
        const auto any = [&](auto holds) {
            return std::any_of(octave.cells.begin(), octave.cells.end(),
                               [&](std::size_t cell) { return holds(plan.cells[cell]); });
        };
        const auto is_luck = [&](const studies::Cell& cell) { return studies::may_be_luck(plan, cell); };
        const std::string_view barless =
            any([&](const studies::Cell& cell) { return cell.deterministic && !is_luck(cell); })
                ? " Without bars: deterministic methods."
                : "";
        const std::string_view luck =
            any(is_luck) ? " Last, without a letter: point sets that are not randomised, whose one error may be luck."
                         : "";
        const std::string_view other_sizes =
            octave.sizes.size() > 1 ? " Methods made for other sizes are shown at theirs, named in brackets." : "";
        pictures.push_back(ranking_picture(
            results,
            {fmt::format("errors-at-{}", octave.usual()),
             fmt::format("Errors at {} evaluations per face, smallest first.", octave.usual()), "RMSE of a run",
             fmt::format("Bars: {:g} % intervals. {}{}{}{}", 100 * plan.spec.level,
                         letters_in_words(plan.spec.level, " in a block"), barless, luck, other_sizes),
             "", true},
            methods, rows));
        pictures.back().name = name;
    }
    return pictures;
}

}  // namespace ff::reports
