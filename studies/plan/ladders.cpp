#include "studies/plan/ladders.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <map>

namespace ff::studies {
namespace {

constexpr std::size_t fewest_sizes = 3;

/// Ladders of one method on one scene, by what stays fixed.
std::vector<Ladder> ladders_of(const StudyPlan& plan, std::size_t scene, std::size_t method, Growth growth) {
    std::map<std::uint64_t, std::vector<std::size_t>> by_fixed;
    for (std::size_t i = 0; i < plan.cells.size(); ++i) {
        const Cell& cell = plan.cells[i];
        if (cell.scene != scene || cell.method != method) continue;
        by_fixed[growth == Growth::samples ? cell.subdivision.per_part() : cell.samples_per_patch].push_back(i);
    }
    std::vector<Ladder> ladders;
    const std::string& name = plan.spec.methods[method].name;
    for (auto& [fixed, cells] : by_fixed) {
        if (cells.size() < fewest_sizes) continue;
        std::ranges::sort(cells, {}, [&](std::size_t cell) { return evaluations_per_trial(plan, plan.cells[cell]); });
        ladders.push_back({scene, method, growth,
                           fmt::format("{} ({} {})", name, fixed, growth == Growth::samples ? "patches" : "points"),
                           cells});
    }
    if (ladders.size() == 1) ladders.front().label = name;
    return ladders;
}

}  // namespace

std::vector<Ladder> find_ladders(const StudyPlan& plan) {
    std::vector<Ladder> all;
    for (std::size_t scene = 0; scene < plan.scenes.size(); ++scene) {
        for (std::size_t method = 0; method < plan.spec.methods.size(); ++method) {
            if (estimator_info(plan.spec.methods[method]).exact) continue;
            auto ladders = ladders_of(plan, scene, method, Growth::samples);
            if (ladders.empty()) ladders = ladders_of(plan, scene, method, Growth::patches);
            all.insert(all.end(), ladders.begin(), ladders.end());
        }
    }
    return all;
}

}  // namespace ff::studies
