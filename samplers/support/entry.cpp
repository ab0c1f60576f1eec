#include "samplers/support/entry.hpp"

#include <algorithm>

#include <fmt/format.h>

namespace ff::samplers {

void weigh_equally(const PointBlock& cells, std::uint64_t points, WeightedBlock& block) {
    for (std::size_t d = 0; d < block.dimension; ++d) {
        for (std::size_t i = 0; i < block.size; ++i) {
            block.coordinate[d][i] = (cells.coordinate[d][i] + 0.5) * 0x1p-32;
        }
    }
    std::fill_n(block.weight.begin(), block.size, 1.0 / static_cast<double>(points));
}

void require_size(const SamplerInfo& info, const PointSetSpec& spec) {
    if (spec.dimension < 1 || spec.dimension > info.most_dimension)
        throw UserError(fmt::format("dimension = {} ({} has points of 1 to {} coordinates). Try {}.", spec.dimension,
                                    info.name, info.most_dimension, info.most_dimension));
    if (info.sizes == Sizes::nodes) return;  // the number of points follows from the nodes, which the sampler checks
    const SizeProblem problem = check_size(info, spec.points, spec.dimension);
    if (problem.fatal) throw UserError(problem.message);
}

}  // namespace ff::samplers
