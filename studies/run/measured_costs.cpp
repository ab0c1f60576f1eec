#include "studies/run/measured_costs.hpp"

#include "core/estimators/added.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <utility>
#include <vector>

namespace ff::studies {

void MeasuredCosts::add(const Progress& progress) {
    const WorkUnit& unit = plan_.units[progress.unit];
    const Cell& cell = plan_.cells[unit.cell];
    const bool is_known = find_added_estimator(plan_.spec.methods[cell.method].estimator) == nullptr;
    if (is_known || progress.processor_seconds <= 0) return;
    Sum& sum = sums_[{cell.method, cell.samples}];
    sum.trials += unit.trials;
    sum.seconds += progress.processor_seconds;
}

std::string MeasuredCosts::in_words() const {
    std::vector<std::string> costs;
    for (const auto& [of, sum] : sums_) {
        const auto& [method, samples] = of;
        costs.push_back(fmt::format("{} at {}: {:.3g} s", plan_.spec.methods[method].name, samples,
                                    sum.seconds / static_cast<double>(sum.trials)));
    }
    return fmt::format("{}", fmt::join(costs, ", "));
}

}  // namespace ff::studies
