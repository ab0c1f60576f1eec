#include "studies/audit/diagnosis.hpp"

#include "core/support/contract.hpp"

#include <algorithm>
#include <cstdint>
#include <deque>
#include <limits>
#include <optional>
#include <set>
#include <span>

namespace ff::studies::audit {
namespace {

using Conflict = std::vector<std::size_t>;
using Spared = std::set<std::size_t>;  ///< suspects that must not be blamed

bool is_hit(const Conflict& conflict, const Blame& blame) {
    return std::ranges::any_of(conflict, [&](std::size_t s) { return blame[s]; });
}

/// The budget that a search has left: some seconds, since its time may double with every conflict.
struct Budget {
    std::uint64_t steps = 50'000'000;
};

/// Branch and bound for the cheapest set of suspects that has one of every conflict.
class HittingSet {
  public:
    HittingSet(const ConstraintSystem& system, const std::vector<Conflict>& conflicts, const Spared& spared,
               double limit, Budget& budget)
        : system_(system),
          conflicts_(conflicts),
          budget_(budget),
          chosen_(system.suspects.size()),
          excluded_(system.suspects.size()),
          bound_(limit) {
        for (const std::size_t s : spared) excluded_[s] = true;
        search(0);
    }
    [[nodiscard]] const std::optional<Blame>& best() const { return best_; }

  private:
    /// The remaining work: the conflict with the fewest ways to hit it, and the least cost of hitting all conflicts.
    struct Rest {
        std::optional<Conflict> narrowest;  ///< only suspects that may be chosen
        double least_cost = 0;
    };
    [[nodiscard]] Rest rest() const {
        Rest rest;
        Blame touched(system_.suspects.size());
        for (const Conflict& conflict : conflicts_) {
            if (is_hit(conflict, chosen_)) continue;
            Conflict free;
            double cheapest = std::numeric_limits<double>::infinity();
            bool disjoint = true;
            for (const std::size_t s : conflict) {
                if (excluded_[s]) continue;
                free.push_back(s);
                cheapest = std::min(cheapest, system_.suspects[s].cost);
                disjoint = disjoint && !touched[s];
            }
            if (disjoint) {
                rest.least_cost += cheapest;
                for (const std::size_t s : free) touched[s] = true;
            }
            if (!rest.narrowest || free.size() < rest.narrowest->size()) rest.narrowest = std::move(free);
        }
        return rest;
    }

    void search(double cost) {
        constexpr double equal = 1e-9;
        std::uint64_t steps = 0;
        for (const Conflict& conflict : conflicts_) steps += conflict.size();
        budget_.steps -= std::min(budget_.steps, steps);
        if (budget_.steps == 0) return;
        const Rest rest = this->rest();
        if (cost + rest.least_cost > bound_) return;
        if (!rest.narrowest) {
            best_ = chosen_;
            bound_ = cost - equal;
            return;
        }
        for (const std::size_t suspect : *rest.narrowest) {
            chosen_[suspect] = true;
            search(cost + system_.suspects[suspect].cost);
            chosen_[suspect] = false;
            excluded_[suspect] = true;  // sets with it have been searched
        }
        for (const std::size_t suspect : *rest.narrowest) excluded_[suspect] = false;
    }

    const ConstraintSystem& system_;
    const std::vector<Conflict>& conflicts_;
    Budget& budget_;
    Blame chosen_;
    Blame excluded_;
    double bound_;
    std::optional<Blame> best_;
};

Diagnosis diagnosis_of(const ConstraintSystem& system, const Blame& blame, std::vector<Range> ranges) {
    Diagnosis diagnosis{.ranges = std::move(ranges)};
    for (std::size_t s = 0; s < blame.size(); ++s) {
        if (!blame[s]) continue;
        diagnosis.blamed.push_back(s);
        diagnosis.cost += system.suspects[s].cost;
    }
    return diagnosis;
}

/// The suspect in most of the conflicts that are not hit, by its cost.
std::optional<std::size_t> busiest(const ConstraintSystem& system, const std::vector<Conflict>& conflicts,
                                   const Blame& blame) {
    std::vector<double> share(system.suspects.size(), 0.0);
    for (const Conflict& conflict : conflicts) {
        if (is_hit(conflict, blame)) continue;
        for (const std::size_t s : conflict) share[s] += 1 / system.suspects[s].cost;
    }
    const auto most = std::ranges::max_element(share);
    if (most == share.end() || *most == 0) return std::nullopt;
    return static_cast<std::size_t>(most - share.begin());
}

/// Blames the busiest suspect until nothing is contradictory, then spares whoever is not needed, late ones first.
Diagnosis find_greedily(const ConstraintSystem& system, std::vector<Conflict> conflicts) {
    Blame blame(system.suspects.size(), false);
    std::vector<std::size_t> order;
    for (;;) {
        while (const auto suspect = busiest(system, conflicts, blame)) {
            blame[*suspect] = true;
            order.push_back(*suspect);
        }
        if (propagate(system, blame)) break;
        conflicts.push_back(find_conflict(system, blame));
    }
    for (auto suspect = order.rbegin(); suspect != order.rend(); ++suspect) {
        blame[*suspect] = false;
        if (!propagate(system, blame)) blame[*suspect] = true;
    }
    Diagnosis diagnosis = diagnosis_of(system, blame, propagate(system, blame).value());
    diagnosis.proven = false;
    return diagnosis;
}

/// The cheapest diagnosis without `spared` that costs at most `limit`; adds the conflicts it comes across. Empty where
/// there is none or the budget is used up.
std::optional<Diagnosis> cheapest(const ConstraintSystem& system, std::vector<Conflict>& conflicts,
                                  const Spared& spared, double limit, Budget& budget) {
    constexpr std::size_t most_conflicts = 60;  // conflicts that are worth finding for an alternative
    for (;;) {
        const HittingSet hitting(system, conflicts, spared, limit, budget);
        if (!hitting.best() || budget.steps == 0) return std::nullopt;
        const Blame& blame = *hitting.best();
        if (auto ranges = propagate(system, blame)) return diagnosis_of(system, blame, std::move(*ranges));
        if (!spared.empty() && conflicts.size() > most_conflicts) return std::nullopt;
        // Several disjoint conflicts at a time save rounds.
        Blame more = blame;
        while (!propagate(system, more)) {
            const Conflict conflict = find_conflict(system, more);
            if (conflict.empty()) return std::nullopt;
            conflicts.push_back(conflict);
            for (const std::size_t s : conflicts.back()) more[s] = true;
        }
    }
}

void set(Blame& blame, std::span<const std::size_t> suspects, bool value) {
    for (const std::size_t s : suspects) blame[s] = value;
}

/// Blames those of `order` that the contradiction does not need, early ones first, and adds the others to `conflict`:
/// by halves, so that few of many cost few propagations. @pre it is there without blaming any of them
void narrow(const ConstraintSystem& system, std::span<const std::size_t> order, Blame& blame, Conflict& conflict) {
    set(blame, order, true);
    if (!propagate(system, blame)) return;  // it needs none of them
    if (order.size() == 1) {
        blame[order.front()] = false;
        conflict.push_back(order.front());
        return;
    }
    const auto early = order.first(order.size() / 2);
    const auto late = order.subspan(order.size() / 2);
    set(blame, order, false);
    narrow(system, early, blame, conflict);
    narrow(system, late, blame, conflict);
}

}  // namespace

std::vector<std::size_t> find_conflict(const ConstraintSystem& system, const Blame& blame) {
    if (propagate(system, blame)) return {};
    std::vector<std::size_t> order;
    for (std::size_t s = 0; s < system.suspects.size(); ++s) {
        if (!blame[s]) order.push_back(s);
    }
    // Cheap suspects are the weak relations: conflicts without them are smaller and fewer.
    std::ranges::stable_sort(order, {}, [&](std::size_t s) { return system.suspects[s].cost; });
    Blame without = blame;
    Conflict conflict;
    narrow(system, order, without, conflict);
    FF_ENSURE(!conflict.empty());
    return conflict;
}

std::optional<Diagnosis> find_cheapest(const ConstraintSystem& system, double limit) {
    std::vector<Conflict> conflicts;
    Budget budget;
    auto diagnosis = cheapest(system, conflicts, {}, limit, budget);
    if (!diagnosis && budget.steps == 0) diagnosis = find_greedily(system, std::move(conflicts));
    return diagnosis && diagnosis->cost <= limit ? std::move(diagnosis) : std::nullopt;
}

std::vector<Diagnosis> diagnose(const ConstraintSystem& system) {
    double limit = 0;
    for (const Suspect& suspect : system.suspects) limit += suspect.cost;
    constexpr double half_a_figure = 0.5;
    constexpr int most_searches = 60;
    std::vector<Conflict> conflicts;
    std::vector<Diagnosis> found;
    Budget budget;
    std::set<Spared> seen{{}};
    std::deque<Spared> open{{}};
    for (int search = 0; search < most_searches && !open.empty() && found.size() < most_diagnoses; ++search) {
        const Spared spared = open.front();
        open.pop_front();
        auto diagnosis = cheapest(system, conflicts, spared, limit, budget);
        FF_ENSURE(diagnosis || !spared.empty() || budget.steps == 0);
        if (!diagnosis && found.empty()) return {find_greedily(system, std::move(conflicts))};
        if (!diagnosis) continue;
        if (found.empty()) limit = diagnosis->cost + half_a_figure;
        // Whatever differs from this diagnosis spares one of its suspects.
        for (const std::size_t suspect : diagnosis->blamed) {
            Spared more = spared;
            more.insert(suspect);
            if (seen.insert(more).second) open.push_back(std::move(more));
        }
        const auto known = std::ranges::find(found, diagnosis->blamed, &Diagnosis::blamed);
        if (known == found.end()) found.push_back(std::move(*diagnosis));
    }
    return found;
}

}  // namespace ff::studies::audit
