#include "reports/pictures/answer_svg.hpp"
#include "reports/pictures/method_styles.hpp"
#include "reports/pictures/svg_text.hpp"
#include "reports/text/labels.hpp"
#include "reports/text/numbers.hpp"
#include "studies/comparison/decisions.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <utility>
#include <vector>

namespace ff::reports {
namespace {

constexpr double kinds_width = 190;
constexpr double cell_width = 170;
constexpr double cell_height = 54;
constexpr double line_height = 16;
constexpr double header_height = 44;

/// The names of the methods, those in colour first, on two lines, and in how many cases they are best.
/// @param decision  null where methods cannot be compared
std::string cell_svg(const studies::Decision* decision, const std::vector<MethodStyle>& styles, double x, double y) {
    std::vector<const MethodStyle*> best;
    if (decision != nullptr) {
        for (const std::size_t method : studies::most_often_best(*decision)) best.push_back(&styles[method]);
    }
    if (best.empty()) return svg_text(x + 12, y + cell_height / 2, R"( fill="#595959")", "–");
    std::stable_partition(best.begin(), best.end(), [](const MethodStyle* style) { return style->in_colour; });
    std::vector<std::string> lines{best[0]->method};
    if (best.size() == 2) lines.push_back(best[1]->method);
    if (best.size() > 2) lines.push_back(fmt::format("and {} more", best.size() - 1));
    std::string out = fmt::format(
        "<rect x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" height=\"{:.1f}\" fill=\"{}\" fill-opacity=\"0.2\"/>\n",
        x + 1, y + 1, cell_width - 2, cell_height - 2, best[0]->colour);
    for (std::size_t i = 0; i < lines.size(); ++i)
        out += svg_text(x + 8, y + line_height * static_cast<double>(i + 1), "", lines[i]);
    return out + svg_text(x + 8, y + line_height * 3, R"( font-size="11" fill="#595959")",
                          fmt::format("{} of {}", decision->choices.front().best, counted(decision->cases, "case")));
}

}  // namespace

std::optional<std::string> decisions_svg(const studies::StudyResults& results) {
    const studies::StudyPlan& plan = results.findings.plan;
    if (plan.scenes.size() < 2 || !results.occlusion.empty()) return std::nullopt;
    const auto times = studies::decide_by_time(plan, results.contests);
    const auto styles = method_styles(results);
    std::string content = svg_text(8, line_height, " font-weight=\"bold\"", "pairs");
    std::map<studies::PairKind, double> rows;  // with their heights
    for (const studies::TimedDecisions& each : times) {
        for (const studies::Decision& decision : each.decisions) rows.emplace(decision.kind, 0);
    }
    double bottom = header_height;
    for (auto& [kind, height] : rows) {
        height = std::exchange(bottom, bottom + cell_height);
        content += svg_text(8, height + line_height, "", kind_in_words(kind));
    }
    double x = kinds_width;
    for (const studies::TimedDecisions& each : times) {
        content += svg_text(x + 8, line_height, " font-weight=\"bold\"", fmt::format("in {:g} s", each.seconds));
        for (const auto& [kind, height] : rows) {
            const auto decision = std::ranges::find(each.decisions, kind, &studies::Decision::kind);
            content += cell_svg(decision == each.decisions.end() ? nullptr : &*decision, styles, x, height);
        }
        x += cell_width;
    }
    content +=
        svg_text(8, 2 * line_height, R"( font-size="11" fill="#595959")",
                 times.empty() ? "There is no round processor time at which methods can be compared."
                               : "Best in the most cases: nothing is shown to have a smaller mean square error.");
    constexpr double note_width = 480;
    return svg_drawing(std::max(x, note_width), bottom + 8,
                       "Which method to take on each kind of pairs (rows) in how much processor time (columns)",
                       content);
}

}  // namespace ff::reports
