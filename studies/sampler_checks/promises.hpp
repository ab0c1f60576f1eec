#pragma once

#include "samplers/point_sets/point_set.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace ff::studies {

enum class PromiseKind {
    latin,       ///< one point in each of n slices of every coordinate
    net,         ///< base^t points in every elementary interval of volume base^t / n
    stratified,  ///< one point in each of k^d cells, n = k^d
    lattice,     ///< points are a group modulo 1 of multiples of 1/n, shifted
};

/// A structure that the author of a sampler says every set has.
struct Promise {
    PromiseKind kind = PromiseKind::latin;
    std::uint32_t t = 0;  ///< t-value of a net; 0 otherwise

    bool operator==(const Promise&) const = default;
};

/// "latin", "net:T", "stratified" or "lattice". @throws UserError otherwise
Promise parse_promise(std::string_view text);

/// "net:2".
std::string name_of(const Promise& promise);

/// Why sets of this size cannot have the structure; empty where they can.
std::string why_impossible(const Promise& promise, std::uint64_t points, std::size_t dimension, std::uint32_t base);

/// Where a set breaks the promise: "coordinate 3: slice 17 of 64 has 2 points", all counted from 0. Empty where it
/// keeps it. @param base  of a net  @pre which < set.sets, and `why_impossible` is empty
std::optional<std::string> broken_by(const Promise& promise, const samplers::PointSet& set, std::uint64_t which,
                                     std::uint32_t base);

}  // namespace ff::studies
