#include "studies/verdicts/gate.hpp"

#include "core/support/contract.hpp"
#include "core/support/error.hpp"
#include "stats/error_rates/multiplicity.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace ff::studies::gates {

Levels levels_of(const Spec& spec, std::size_t comparisons) {
    FF_EXPECT(comparisons >= 1 && spec.looks >= 1);
    const std::size_t questions = std::max<std::size_t>(1, spec.gates.size()) * spec.looks * comparisons;
    const double shared = stats::bonferroni_level(spec.alpha, questions);
    if (shared < smallest_shared_alpha)
        throw UserError(fmt::format(
            "{}: alpha = {:g} (shared among {} comparisons it is below {:g}, which is not computed). Raise it.",
            spec.name, spec.alpha, questions, smallest_shared_alpha));
    return {.fail_alpha = shared, .pass_alpha = spec.pass_alpha / static_cast<double>(spec.looks), .power = spec.power};
}

Levels levels_at_one_look(Spec spec, std::size_t comparisons) {
    spec.looks = 1;
    return levels_of(spec, comparisons);
}

bool is_binomial(IntervalMethod method) {
    return method == IntervalMethod::wilson || method == IntervalMethod::clopper_pearson ||
           method == IntervalMethod::wald;
}

}  // namespace ff::studies::gates
