#include "studies/run/measured_costs.hpp"

#include "core/estimators/added.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <sstream>
#include <utility>

namespace ff::studies {
namespace {

void add_to(MeasuredCost& sum, const MeasuredCost& more) {
    sum.trials += more.trials;
    sum.seconds += more.seconds;
    sum.squared_seconds += more.squared_seconds;
}

/// The key on which trials, and their cost, depend.
std::string key_of(const StudyPlan& plan, const Cell& cell) {
    const Method& method = plan.spec.methods[cell.method];
    const std::string key = fmt::format("{:08x}{:08x}", cell.key.word0, cell.key.word1);
    return method.tracer == TracerChoice::automatic ? key : fmt::format("{}-{}", key, name(method.tracer));
}

}  // namespace

double MeasuredCost::relative_error() const {
    // The effect of caches, clock and other programs on all trials of a cell alike, and the extra time of the first
    // trials.
    constexpr double of_the_machine = 0.1;
    constexpr double to_settle = 1e-3;  // seconds
    const auto n = static_cast<double>(trials);
    const double variance = trials < 2 ? 0 : std::max(0.0, squared_seconds - seconds * seconds / n) / (n - 1);
    return std::hypot(std::sqrt(variance / n) / mean(), of_the_machine, to_settle / seconds);
}

void MeasuredCosts::add(const RunProgress& progress) {
    if (progress.processor_seconds <= 0) return;
    const WorkUnit& unit = plan_.units[progress.unit];
    add_to(of_cells_[unit.cell], {unit.trials, progress.processor_seconds, progress.processor_seconds_squared});
}

std::string MeasuredCosts::in_words() const {
    std::map<std::pair<std::size_t, std::uint64_t>, MeasuredCost> sums;  // keys: method and size
    for (std::size_t i = 0; i < of_cells_.size(); ++i) {
        const Cell& cell = plan_.cells[i];
        const bool is_known = find_added_estimator(plan_.spec.methods[cell.method].estimator) == nullptr;
        if (!is_known && of_cells_[i].trials > 0) add_to(sums[{cell.method, cell.samples_per_patch}], of_cells_[i]);
    }
    std::vector<std::string> costs;
    for (const auto& [of, sum] : sums) {
        const std::string size = of.second > 0 ? fmt::format(" at {}", of.second) : "";
        costs.push_back(fmt::format("{}{}: {:.3g} s", plan_.spec.methods[of.first].name, size, sum.mean()));
    }
    return fmt::format("{}", fmt::join(costs, ", "));
}

std::string MeasuredCosts::in_context() const {
    std::map<std::string, MeasuredCost> sums;
    for (std::size_t i = 0; i < of_cells_.size(); ++i) {
        if (of_cells_[i].trials > 0) add_to(sums[key_of(plan_, plan_.cells[i])], of_cells_[i]);
    }
    std::vector<std::string> entries;
    for (const auto& [key, sum] : sums)
        entries.push_back(fmt::format("{}:{}:{:.5g}:{:.5g}", key, sum.trials, sum.seconds, sum.squared_seconds));
    return fmt::format("{}", fmt::join(entries, "; "));
}

std::vector<std::optional<MeasuredCost>> measured_costs(const StudyPlan& plan, const Context& context) {
    std::map<std::string, MeasuredCost, std::less<>> sums;
    const auto found = context.find(std::string(costs_key));
    std::istringstream entries(found == context.end() ? std::string() : found->second);
    for (std::string entry; entries >> entry;) {
        std::ranges::replace(entry, ':', ' ');
        std::istringstream parts(entry);
        std::string key;
        MeasuredCost cost;
        if (parts >> key >> cost.trials >> cost.seconds >> cost.squared_seconds && cost.trials > 0 && cost.seconds > 0)
            add_to(sums[key], cost);
    }
    std::vector<std::optional<MeasuredCost>> costs;
    for (const Cell& cell : plan.cells) {
        const auto known = sums.find(key_of(plan, cell));
        costs.push_back(known == sums.end() ? std::nullopt : std::optional(known->second));
    }
    return costs;
}

}  // namespace ff::studies
