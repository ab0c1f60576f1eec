#include "studies/comparison/contests.hpp"

#include "studies/comparison/contest_family.hpp"

#include <cmath>
#include <map>
#include <utility>

namespace ff::studies {

std::vector<Contest> hold_contests(const CellReader& cells, const Analysis& findings) {
    const Costs costs = measured_costs(findings.plan, cells.store().context());
    std::vector<Contest> contests;
    for (std::size_t scene = 0; scene < findings.plan.scenes.size(); ++scene) {
        const Field field{
            [&](PairClass pair_class, Equal equal) { return contenders(findings, costs, scene, pair_class, equal); },
            [&](PairClass pair_class, Equal equal) { return exact_sizes(findings, costs, scene, pair_class, equal); },
            [&](std::size_t cell) { return findings.plan.cells[cell].method; },
            [&](std::size_t a, std::size_t b, PairClass pair_class) {
                return shared_noise({&cells, a}, {&cells, b}, pair_class);
            }};
        hold(scene, field, findings.plan.spec, contests);
    }
    return contests;
}

double round_time_from(double seconds) {
    return std::pow(10, std::ceil(std::log10(seconds)));
}

std::vector<const Contest*> main_contests(std::span<const Contest> contests, Equal equal) {
    std::map<std::pair<std::size_t, PairClass>, const Contest*> chosen;
    for (const Contest& contest : contests) {
        if (contest.equal != equal) continue;
        const Contest*& best = chosen[{contest.scene, contest.pair_class}];
        const auto methods = [](const Contest& of) { return of.entrants.size() + of.exact.size(); };
        const std::size_t most = best == nullptr ? 0 : methods(*best);
        const bool as_many = methods(contest) == most && equal != Equal::error;  // budgets ascend
        if (methods(contest) > most || as_many) best = &contest;
    }
    std::vector<const Contest*> result;
    for (const auto& [of, contest] : chosen) result.push_back(contest);
    return result;
}

}  // namespace ff::studies
