#include "studies/sampler_checks/promises.hpp"

#include "core/support/contract.hpp"
#include "core/support/error.hpp"
#include "core/support/excerpt.hpp"
#include "core/support/words.hpp"
#include "samplers/point_sets/net_parameter.hpp"
#include "samplers/support/sizes.hpp"
#include "studies/sampler_checks/point_groups.hpp"
#include "studies/sampler_checks/structure.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace ff::studies {
namespace {

/// The number of the fullest cell of k^d, where one has more than one point.
struct FullCell {
    std::uint64_t cell = 0;
    std::uint64_t points = 0;
};

std::optional<FullCell> full_cell(const samplers::PointSet& set, std::uint64_t which, std::uint64_t k) {
    std::optional<FullCell> found;
    for (const samplers::Sorting& sorting : samplers::sortings(set, which, k)) {
        const auto counts = points_of_cells(sorting, k);
        const auto fullest = std::ranges::max_element(counts);
        if (*fullest <= 1) return std::nullopt;
        if (!found) found = FullCell{static_cast<std::uint64_t>(fullest - counts.begin()), *fullest};
    }
    return found;
}

std::optional<std::string> not_latin(const samplers::PointSet& set, std::uint64_t which) {
    for (std::size_t d = 0; d < set.dimension; ++d) {
        if (const auto full = full_cell(projection(set, which, {d}), 0, set.points))
            return fmt::format("coordinate {}: slice {} of {} has {} points", d, full->cell, set.points, full->points);
    }
    return std::nullopt;
}

std::optional<std::string> not_stratified(const samplers::PointSet& set, std::uint64_t which) {
    const std::uint64_t k = samplers::floor_root(set.points, set.dimension);
    const auto full = full_cell(set, which, k);
    if (!full) return std::nullopt;
    std::string place;
    std::uint64_t left = full->cell;
    for (std::size_t d = 0; d < set.dimension; ++d, left /= k)
        place += fmt::format("{}{}", place.empty() ? "" : ", ", left % k);
    return fmt::format("cell ({}) of {}^{} has {} points", place, k, set.dimension, full->points);
}

std::optional<std::string> not_a_net(const samplers::PointSet& set, std::uint64_t which, std::uint32_t base,
                                     std::uint32_t t) {
    const auto crowded = samplers::crowded_interval(set, which, base, t);
    if (!crowded) return std::nullopt;
    std::string place;
    for (std::size_t d = 0; d < set.dimension; ++d) {
        if (crowded->digits[d] == 0) continue;
        place += fmt::format("{}part {} of {} of coordinate {}", place.empty() ? "" : ", ", crowded->number[d],
                             samplers::integer_power(base, crowded->digits[d]), d);
    }
    return fmt::format("{}: {} points, not {}", place, crowded->points, samplers::integer_power(base, t));
}

std::optional<std::string> not_a_lattice(const samplers::PointSet& set, std::uint64_t which) {
    const auto off = first_off_lattice(set, which);
    if (!off) return std::nullopt;
    return fmt::format("point {}: no lattice of {} points has it and those before it", *off, set.points);
}

}  // namespace

Promise parse_promise(std::string_view text) {
    if (text == "latin") return {PromiseKind::latin};
    if (text == "stratified") return {PromiseKind::stratified};
    if (text == "lattice") return {PromiseKind::lattice};
    if (text.starts_with("net:")) {
        if (const auto t = parse_bare_number<std::uint32_t>(text.substr(4))) return {PromiseKind::net, *t};
    }
    throw UserError("--promises {}. It is latin, net:T with a number T, stratified or lattice.", excerpt(text));
}

std::string name_of(const Promise& promise) {
    constexpr std::array<std::string_view, 4> names{"latin", "net", "stratified", "lattice"};
    const std::string_view name = names[static_cast<std::size_t>(promise.kind)];
    return promise.kind == PromiseKind::net ? fmt::format("{}:{}", name, promise.t) : std::string(name);
}

std::string why_impossible(const Promise& promise, std::uint64_t points, std::size_t dimension, std::uint32_t base) {
    const std::uint64_t k = samplers::floor_root(points, dimension);
    const std::uint64_t power = samplers::integer_power(base, samplers::count_digits(points, base));
    switch (promise.kind) {
        case PromiseKind::latin:
            break;
        case PromiseKind::stratified:
            if (samplers::integer_power(k, dimension) != points)
                return fmt::format("{} points are no k^{} cells", points, dimension);
            break;
        case PromiseKind::net:
            if (points != 1 && power != points) return fmt::format("{} points are no power of {}", points, base);
            if (points > most_for_t_value)
                return fmt::format("nets of more than {} points are not examined", most_for_t_value);
            if (points == 1 || promise.t > samplers::count_digits(points, base))
                return fmt::format("t is at most {}", points == 1 ? 0 : samplers::count_digits(points, base));
            break;
        case PromiseKind::lattice:
            if (points > most_for_groups)
                return fmt::format("lattices of more than {} points are not examined", most_for_groups);
            break;
    }
    return {};
}

std::optional<std::string> broken_by(const Promise& promise, const samplers::PointSet& set, std::uint64_t which,
                                     std::uint32_t base) {
    FF_EXPECT(which < set.sets);
    switch (promise.kind) {
        case PromiseKind::latin:
            return not_latin(set, which);
        case PromiseKind::net:
            return not_a_net(set, which, base, promise.t);
        case PromiseKind::stratified:
            return not_stratified(set, which);
        case PromiseKind::lattice:
            break;
    }
    return not_a_lattice(set, which);
}

}  // namespace ff::studies
