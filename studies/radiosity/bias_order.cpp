#include "studies/radiosity/bias_order.hpp"

#include "stats/convergence/line_fit.hpp"
#include "studies/plan/ladders.hpp"

#include <cmath>

namespace ff::studies::radiosity {
namespace {

constexpr double certain = 3;      // standard errors
constexpr double rounding = 1e-9;  // of a solution of a system with condition 1e6, relative

void fit(BiasOrder& order, double level) {
    std::vector<double> x, y, variances;
    for (const BiasOrder::Point& point : order.points) {
        if (std::abs(point.bias) < certain * point.error) return;
        x.push_back(std::log(point.evaluations));
        y.push_back(std::log(std::abs(point.bias)));
        variances.push_back(std::pow(point.error / point.bias, 2));
    }
    if (const auto line = stats::fit_line(x, y, variances)) {
        order.slope = line->slope;
        order.interval = stats::slope_interval_normal(*line, level);
    }
}

}  // namespace

std::vector<BiasOrder> bias_orders(const StudyPlan& plan, const Results& results) {
    std::vector<BiasOrder> orders;
    for (const Ladder& ladder : find_ladders(plan)) {
        if (ladder.growth != Growth::samples || plan.cells[ladder.cells.front()].deterministic) continue;
        for (const Treatment treatment : all_treatments) {
            for (std::size_t setting = 0; setting < plan.spec.radiosity->reflectance.size(); ++setting) {
                BiasOrder order{ladder.label, ladder.scene, treatment, setting, {}, {}, {}};
                for (const std::size_t cell : ladder.cells) {
                    const Consequences* found = results.find(cell, treatment);
                    if (found->settings.empty()) continue;
                    const auto& exitance = found->settings[setting].exitance;
                    if (exitance.empty() || exitance.front().std.value_or(0) <= rounding * exitance.front().exact)
                        continue;
                    const ExitanceStatistics& all = exitance.front();
                    const Cell& planned = plan.cells[cell];
                    order.points.push_back(
                        {cell, static_cast<double>(planned.samples_per_patch * planned.subdivision.per_part()),
                         *all.bias / all.exact, *all.std / std::sqrt(static_cast<double>(found->trials)) / all.exact});
                }
                if (order.points.size() != ladder.cells.size()) continue;
                fit(order, plan.spec.level);
                orders.push_back(std::move(order));
            }
        }
    }
    return orders;
}

}  // namespace ff::studies::radiosity
