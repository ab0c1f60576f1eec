#include "studies/sampler_checks/evenness_of_set.hpp"

#include "samplers/point_sets/net_parameter.hpp"
#include "stats/goodness_of_fit/discrepancy.hpp"

#include <algorithm>

namespace ff::studies {

EvennessOfSet evenness_of(const samplers::PointSet& set, std::uint32_t base) {
    EvennessOfSet found;
    stats::Coordinates coordinates(set.dimension);
    for (std::size_t d = 0; d < set.dimension; ++d) {
        for (const std::uint32_t x : set.row(0, d)) coordinates[d].push_back((x + 0.5) * 0x1p-32);
        found.largest_gap = std::max(found.largest_gap, stats::largest_gap(coordinates[d]));
    }
    if (set.points <= most_for_t_value) found.t_value = samplers::net_parameter(set, 0, base);
    if (set.points <= most_quadratic) {
        found.l2_star_discrepancy = stats::l2_star_discrepancy(coordinates);
        found.centred_discrepancy = stats::centred_discrepancy(coordinates);
    }
    return found;
}

}  // namespace ff::studies
