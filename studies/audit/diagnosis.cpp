#include "studies/audit/diagnosis.hpp"

#include "core/contract.hpp"

#include <algorithm>
#include <optional>

namespace ff::studies {
namespace {

using Conflict = std::vector<std::size_t>;

/// Branch and bound for the cheapest set of suspects that has one of every conflict.
class HittingSet {
  public:
    HittingSet(const ConstraintSystem& system, const std::vector<Conflict>& conflicts,
               std::optional<std::size_t> spared, double limit)
        : system_(system), conflicts_(conflicts), spared_(spared), chosen_(system.suspects.size()), bound_(limit) {
        search(0);
    }
    [[nodiscard]] const std::optional<Blame>& best() const { return best_; }
    [[nodiscard]] double cost() const { return bound_; }

  private:
    [[nodiscard]] bool is_hit(const Conflict& conflict) const {
        return std::any_of(conflict.begin(), conflict.end(), [&](std::size_t s) { return chosen_[s]; });
    }

    void search(double cost) {
        constexpr double equal = 1e-9;
        const Conflict* smallest = nullptr;
        for (const Conflict& conflict : conflicts_) {
            if (is_hit(conflict)) continue;
            if (smallest == nullptr || conflict.size() < smallest->size()) smallest = &conflict;
        }
        if (smallest == nullptr) {
            best_ = chosen_;
            bound_ = cost - equal;
            return;
        }
        for (const std::size_t suspect : *smallest) {
            const double with = cost + system_.suspects[suspect].cost;
            if (suspect == spared_ || with > bound_) continue;
            chosen_[suspect] = true;
            search(with);
            chosen_[suspect] = false;
        }
    }

    const ConstraintSystem& system_;
    const std::vector<Conflict>& conflicts_;
    std::optional<std::size_t> spared_;
    Blame chosen_;
    double bound_;
    std::optional<Blame> best_;
};

/// The cheapest diagnosis without `spared` that costs at most `limit`; adds the conflicts it comes across.
std::optional<Diagnosis> cheapest(const ConstraintSystem& system, std::vector<Conflict>& conflicts,
                                  std::optional<std::size_t> spared, double limit) {
    for (;;) {
        const HittingSet hitting(system, conflicts, spared, limit);
        if (!hitting.best()) return std::nullopt;
        const Blame& blame = *hitting.best();
        if (auto ranges = propagate(system, blame)) {
            Diagnosis diagnosis{.cost = hitting.cost(), .ranges = std::move(*ranges)};
            for (std::size_t s = 0; s < blame.size(); ++s) {
                if (blame[s]) diagnosis.blamed.push_back(s);
            }
            return diagnosis;
        }
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

}  // namespace

std::vector<std::size_t> find_conflict(const ConstraintSystem& system, const Blame& blame) {
    if (propagate(system, blame)) return {};
    Blame without = blame;
    Conflict conflict;
    for (std::size_t s = 0; s < system.suspects.size(); ++s) {
        if (blame[s]) continue;
        without[s] = true;
        if (propagate(system, without)) {  // needed for the contradiction
            without[s] = false;
            conflict.push_back(s);
        }
    }
    FF_ENSURE(!conflict.empty());
    return conflict;
}

std::vector<Diagnosis> diagnose(const ConstraintSystem& system) {
    double everything = 0;
    for (const Suspect& suspect : system.suspects) everything += suspect.cost;
    std::vector<Conflict> conflicts;
    std::vector<Diagnosis> found;
    auto best = cheapest(system, conflicts, std::nullopt, everything);
    FF_ENSURE(best.has_value());
    if (!best) return found;
    found.push_back(std::move(*best));
    const std::vector<std::size_t> blamed = found.front().blamed;
    for (const std::size_t suspect : blamed) {
        auto other = cheapest(system, conflicts, suspect, found.front().cost + 0.5);
        if (!other) continue;
        const bool known =
            std::any_of(found.begin(), found.end(), [&](const Diagnosis& d) { return d.blamed == other->blamed; });
        if (!known) found.push_back(std::move(*other));
    }
    return found;
}

}  // namespace ff::studies
