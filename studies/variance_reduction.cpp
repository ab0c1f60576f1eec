#include "studies/variance_reduction.hpp"

#include "core/exact.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace ff::studies {
namespace {

constexpr std::string_view reference_sampler = "random";

/// The cell of random points that differs from this one in the sampler and the allocation of its points only.
std::optional<std::size_t> counterpart(const StudyPlan& plan, const Cell& cell) {
    const Method& method = plan.spec.methods[cell.method];
    const auto found = std::find_if(plan.cells.begin(), plan.cells.end(), [&](const Cell& other) {
        const Method& candidate = plan.spec.methods[other.method];
        return candidate.sampler == reference_sampler && other.scene == cell.scene &&
               candidate.estimator == method.estimator && candidate.completion == method.completion &&
               other.subdivision.m == cell.subdivision.m && other.samples == cell.samples;
    });
    if (method.sampler == reference_sampler || found == plan.cells.end()) return std::nullopt;
    return static_cast<std::size_t>(found - plan.cells.begin());
}

/// Variances of classes of cells, each computed once.
class ClassVariances {
  public:
    ClassVariances(const Store& store, const Findings& findings) : store_(store), findings_(findings) {}

    const ClassErrors& of(std::size_t cell_index, PairClass pair_class) {
        const auto key = std::pair(cell_index, pair_class);
        const auto known = errors_.find(key);
        return known != errors_.end() ? known->second
                                      : errors_.emplace(key, compute(cell_index, pair_class)).first->second;
    }

  private:
    [[nodiscard]] ClassErrors compute(std::size_t cell_index, PairClass pair_class) const {
        const StudyPlan& plan = store_.plan();
        const Cell& cell = plan.cells[cell_index];
        const Scene& scene = plan.scenes[cell.scene];
        const auto exact = exact_form_factors(scene);
        const CellFindings& found = findings_.cells[cell_index];
        if (!exact || found.has_infinite_variance(pair_class)) return {};
        const CellEstimates estimates = load_estimates(store_, cell_index);
        const auto pairs = pairs_of_class(
            scene, distinct_pairs(estimates.faces, plan.spec.methods[cell.method].completion), pair_class);
        if (pairs.empty()) return {};
        return summarise_class(errors_of(estimates, pairs, *exact), pairs.size(), estimates.evaluations_per_face,
                               VarianceStatus::finite, plan.spec.level);
    }

    const Store& store_;
    const Findings& findings_;
    std::map<std::pair<std::size_t, PairClass>, ClassErrors> errors_;
};

double log_reach(const ClassErrors& errors) {
    return std::log(errors.variance_interval->high / *errors.variance);
}

}  // namespace

stats::Interval variance_ratio_interval(const ClassErrors& ours, const ClassErrors& theirs) {
    const double factor = *theirs.variance / *ours.variance;
    const double reach = std::exp(std::hypot(log_reach(ours), log_reach(theirs)));
    return {.low = factor / reach,
            .high = factor * reach,
            .level = ours.variance_interval->level,
            .method = "log_normal",
            .n = std::min(ours.variance_interval->n, theirs.variance_interval->n)};
}

std::vector<VarianceReduction> compare_with_random(const Store& store, const Findings& findings) {
    const StudyPlan& plan = store.plan();
    ClassVariances variances(store, findings);
    std::vector<VarianceReduction> reductions;
    for (std::size_t i = 0; i < plan.cells.size(); ++i) {
        const auto random = counterpart(plan, plan.cells[i]);
        if (plan.cells[i].deterministic || !random) continue;
        for (const PairClass pair_class : {PairClass::parallel, PairClass::adjacent, PairClass::other}) {
            const ClassErrors& ours = variances.of(i, pair_class);
            const ClassErrors& theirs = variances.of(*random, pair_class);
            if (!ours.variance || !theirs.variance) continue;
            VarianceReduction& found = reductions.emplace_back();
            found.cell = i;
            found.random_cell = *random;
            found.pair_class = pair_class;
            found.factor = *theirs.variance / *ours.variance;
            found.interval = variance_ratio_interval(ours, theirs);
        }
    }
    return reductions;
}

}  // namespace ff::studies
