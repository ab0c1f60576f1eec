#include "reports/comparison/ratio_plot.hpp"

#include "reports/text/labels.hpp"
#include "reports/text/numbers.hpp"
#include "reports/text/text_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace ff::reports {

using studies::CellComparison;
using studies::RunComparison;

namespace {

/// An interval as a bar between 1/`reach` and `reach`, on a logarithmic scale with 1 in the middle.
std::string bar(const studies::RmseRatio& ratio, double reach) {
    constexpr int half = 15;
    const auto place = [&](double value) {
        return half + static_cast<int>(std::lround(half * std::clamp(std::log(value) / std::log(reach), -1.0, 1.0)));
    };
    const int low = place(ratio.interval->low);
    const int high = place(ratio.interval->high);
    const int middle = place(*ratio.ratio);
    std::string text;
    for (int i = 0; i <= 2 * half; ++i) text += i == middle ? "●" : i == half ? "│" : i >= low && i <= high ? "─" : " ";
    return text;
}

}  // namespace

const Scene& scene_of(const RunComparison& comparison, const CellComparison& cell) {
    const studies::StudyPlan& plan = comparison.first.plan;
    return plan.scenes[plan.cells[cell.first].scene];
}

std::string method_names(const RunComparison& comparison, const CellComparison& compared) {
    const auto name_in = [](const studies::StudyPlan& plan, std::size_t cell) -> const std::string& {
        return plan.spec.methods[plan.cells[cell].method].name;
    };
    const std::string& first = name_in(comparison.first.plan, compared.first);
    const std::string& second = name_in(comparison.second.plan, compared.second);
    return first == second ? first : fmt::format("{} | {}", first, second);
}

std::string scene_and_method(const RunComparison& comparison, const CellComparison& compared) {
    const std::string method = method_names(comparison, compared);
    const bool one_scene = comparison.first.plan.scenes.size() == 1;
    return one_scene ? method : fmt::format("{}: {}", scene_of(comparison, compared).name, method);
}

std::string ratio_text(const studies::RmseRatio& ratio) {
    const double reach = ratio.interval->width() / 2;
    return fmt::format("{} [{}, {}]", to_error(*ratio.ratio, reach), to_error(ratio.interval->low, reach),
                       to_error(ratio.interval->high, reach));
}

std::string ratio_plot(const RunComparison& comparison) {
    const auto lead = comparison.lead();
    if (!lead.ratios) return {};
    const double reach = std::max({1 / lead.ratios->low, lead.ratios->high, 1.05});
    const studies::StudyPlan& plan = comparison.first.plan;
    std::vector<std::array<std::string, 3>> rows{
        {fmt::format("RMSE of {} / RMSE of {}", comparison.names[1], comparison.names[0]),
         fmt::format("{:<15.2f}1{:>15.2f}", 1 / reach, reach), ""}};
    for (const CellComparison& compared : comparison.cells) {
        for (const studies::RmseRatio& ratio : compared.ratios) {
            if (!ratio.interval) continue;
            rows.push_back({fmt::format("{}, {}, {}", scene_and_method(comparison, compared),
                                        size_label(plan, plan.cells[compared.first]), name(ratio.pair_class)),
                            bar(ratio, reach), ratio_text(ratio)});
        }
    }
    std::size_t width = 0;
    for (const auto& row : rows) width = std::max(width, visible_length(row[0]));
    std::string out;
    for (const auto& [label, drawn, figures] : rows) {
        std::string line =
            fmt::format("{}{}  {}  {}", label, std::string(width - visible_length(label), ' '), drawn, figures);
        out += line.substr(0, line.find_last_not_of(' ') + 1) + '\n';
    }
    return out;
}

}  // namespace ff::reports
