#include "samplers/point_sets/parts.hpp"

#include <algorithm>

namespace ff::samplers {
namespace {

constexpr std::uint64_t many = 16;  // one in so many is more than chance leaves of up to 2^28 / dimension points

}  // namespace

std::vector<Sorting> sortings(const PointSet& set, std::uint64_t which, std::uint64_t parts) {
    std::vector<bool> is_open(set.points, false);
    for (std::size_t d = 0; d < set.dimension; ++d) {
        const auto row = set.row(which, d);
        for (std::size_t i = 0; i < row.size(); ++i)
            if (part_of(row[i], parts, Edge::lower) != part_of(row[i], parts)) is_open[i] = true;
    }
    const auto open = static_cast<std::uint64_t>(std::count(is_open.begin(), is_open.end(), true));
    const auto left_out = [&](bool some) {
        PointSet rest{some ? set.points - open : set.points, set.dimension, 1, {}};
        for (std::size_t d = 0; d < set.dimension; ++d) {
            const auto row = set.row(which, d);
            for (std::size_t i = 0; i < row.size(); ++i)
                if (!some || !is_open[i]) rest.coordinate.push_back(row[i]);
        }
        return rest;
    };
    std::vector<Sorting> all{{left_out(false), Edge::upper}};
    if (open > 0) all.push_back({left_out(open * many <= set.points), Edge::lower});
    return all;
}

}  // namespace ff::samplers
