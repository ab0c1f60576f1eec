#include "studies/gates/gate.hpp"

#include "core/contract.hpp"
#include "stats/multiplicity.hpp"

#include <algorithm>

namespace ff::studies {

Levels levels_of(const GatesSpec& spec, std::size_t comparisons) {
    FF_EXPECT(comparisons >= 1 && spec.looks >= 1);
    const std::size_t questions = std::max<std::size_t>(1, spec.gates.size()) * spec.looks * comparisons;
    return {.fail_alpha = stats::bonferroni_level(spec.alpha, questions),
            .pass_alpha = spec.pass_alpha / static_cast<double>(spec.looks),
            .power = spec.power};
}

bool is_binomial(IntervalMethod method) {
    return method == IntervalMethod::wilson || method == IntervalMethod::clopper_pearson ||
           method == IntervalMethod::wald;
}

}  // namespace ff::studies
