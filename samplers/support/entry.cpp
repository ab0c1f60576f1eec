#include "samplers/support/entry.hpp"

#include "core/support/error.hpp"

namespace ff::samplers {

void require_size(const SamplerInfo& info, const PointSetSpec& spec) {
    if (spec.dimension < 1 || spec.dimension > info.most_dimension)
        throw UserError("dimension = {} ({} has points of 1 to {} coordinates). Try {}.", spec.dimension, info.name,
                        info.most_dimension, info.most_dimension);
    if (info.sizes == Sizes::nodes) return;  // the number of points follows from the nodes, which the sampler checks
    const SizeProblem problem = check_size(info, spec.points, spec.dimension);
    if (problem.fatal) throw UserError(problem.message);
}

}  // namespace ff::samplers
