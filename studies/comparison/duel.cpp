#include "studies/comparison/duel.hpp"

#include "studies/comparison/contest_family.hpp"
#include "studies/run/measured_costs.hpp"

#include <algorithm>

namespace ff::studies {
namespace {

/// Seconds of different machines or builds are not comparable.
bool have_one_clock(const Context& first, const Context& second) {
    return std::ranges::all_of(std::array{"processor", "build_type"}, [&](const char* key) {
        const auto a = first.find(key);
        const auto b = second.find(key);
        return a != first.end() && b != second.end() && a->second == b->second;
    });
}

/// Both methods in one list of cells: those of the second run come after those of the first.
class Both {
  public:
    Both(const Duellist& first, const Duellist& second)
        : sides_{&first, &second}, offsets_{0, first.findings.plan.cells.size()} {
        const std::array contexts{first.cells.store().context(), second.cells.store().context()};
        for (std::size_t i = 0; i < 2; ++i) {
            const StudyPlan& plan = sides_[i]->findings.plan;
            costs_[i] =
                have_one_clock(contexts[0], contexts[1]) ? measured_costs(plan, contexts[i]) : Costs(plan.cells.size());
        }
    }

    [[nodiscard]] std::size_t side_of(std::size_t cell) const { return cell < offsets_[1] ? 0 : 1; }
    [[nodiscard]] CellOfRun in_run(std::size_t cell) const {
        const std::size_t side = side_of(cell);
        return {&sides_[side]->cells, cell - offsets_[side]};
    }

    [[nodiscard]] Field field(const std::array<std::size_t, 2>& scenes) const {
        return {
            [this, scenes](PairClass pair_class, Equal equal) {
                std::vector<Contender> all;
                for (std::size_t i = 0; i < 2; ++i) {
                    for (Contender& each : contenders(sides_[i]->findings, costs_[i], scenes[i], pair_class, equal)) {
                        if (!take(i, each)) continue;
                        all.push_back(std::move(each));
                    }
                }
                return all;
            },
            [this, scenes](PairClass pair_class, Equal equal) {
                std::vector<Rung> all;
                for (std::size_t i = 0; i < 2; ++i) {
                    auto rungs = exact_sizes(sides_[i]->findings, costs_[i], scenes[i], pair_class, equal);
                    std::erase_if(rungs, [&](const Rung& rung) { return !is_of(i, rung); });
                    take(i, rungs);
                    all.insert(all.end(), rungs.begin(), rungs.end());
                }
                return all;
            },
            [this](std::size_t cell) { return side_of(cell); },
            [this](std::size_t a, std::size_t b, PairClass pair_class) {
                return shared_noise(in_run(a), in_run(b), pair_class);
            }};
    }

  private:
    [[nodiscard]] bool is_of(std::size_t side, const Rung& rung) const {
        return sides_[side]->findings.plan.cells[rung.cell].method == sides_[side]->method;
    }
    /// Counts the cells of a side's rungs on. @return whether there are any of its method
    bool take(std::size_t side, std::vector<Rung>& rungs) const {
        if (rungs.empty() || !is_of(side, rungs.front())) return false;
        for (Rung& rung : rungs) rung.cell += offsets_[side];
        return true;
    }

    std::array<const Duellist*, 2> sides_;
    std::array<std::size_t, 2> offsets_;
    std::array<Costs, 2> costs_;
};

/// The best of each method in a contest; empty where one of them does not take part, or both are exact.
std::optional<Bout> bout_of(const Contest& contest, const Both& both) {
    Bout bout{.scene = contest.scene,
              .pair_class = contest.pair_class,
              .equal = contest.equal,
              .budget = contest.budget,
              .interval = std::nullopt,
              .times_trials = std::nullopt};
    std::array<std::optional<std::size_t>, 2> entered;  // indices into the entrants
    std::array<bool, 2> exact{false, false};
    for (std::size_t i = contest.entrants.size(); i-- > 0;) entered[both.side_of(contest.entrants[i].cell)] = i;
    for (const std::size_t cell : contest.exact) {
        exact[both.side_of(cell)] = true;
        bout.cells[both.side_of(cell)] = both.in_run(cell).cell;
    }
    if (exact[0] && exact[1]) return std::nullopt;
    for (std::size_t side = 0; side < 2; ++side) {
        if (exact[side]) continue;
        if (!entered[side]) return std::nullopt;
        bout.cells[side] = both.in_run(contest.entrants[*entered[side]].cell).cell;
    }
    bout.is_exact = bout.is_shown = exact[0] || exact[1];
    if (bout.is_exact) {
        bout.better = exact[0] ? 0 : 1;
        return bout;
    }
    bout.better = *entered[0] < *entered[1] ? 0 : 1;
    const auto [best, worst] = std::minmax(*entered[0], *entered[1]);
    const auto found = std::ranges::find_if(contest.handicaps, [&](const Handicap& handicap) {
        return handicap.better == best && handicap.worse == worst;
    });
    bout.ratio = found->ratio;
    bout.interval = found->interval;
    bout.is_shown = found->apart;
    bout.times_trials = found->times_trials;
    return bout;
}

}  // namespace

std::vector<Bout> hold_duel(const Duellist& first, const Duellist& second,
                            const std::vector<std::pair<std::size_t, std::size_t>>& scenes) {
    const Both both(first, second);
    std::vector<Bout> bouts;
    for (const auto& [in_first, in_second] : scenes) {
        std::vector<Contest> contests;
        hold(in_first, both.field({in_first, in_second}), first.findings.plan.spec, contests);
        std::erase_if(contests, [&](const Contest& contest) { return !bout_of(contest, both); });
        for (const Equal equal : {Equal::evaluations, Equal::processor_time, Equal::error}) {
            const auto most_informative = main_contests(contests, equal);
            for (const Contest& contest : contests) {
                if (contest.equal != equal) continue;
                bouts.push_back(*bout_of(contest, both));
                bouts.back().is_main = std::ranges::find(most_informative, &contest) != most_informative.end();
            }
        }
    }
    return bouts;
}

}  // namespace ff::studies
