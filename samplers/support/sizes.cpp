#include "samplers/support/sizes.hpp"

#include "core/support/contract.hpp"

#include <algorithm>
#include <bit>
#include <iterator>
#include <string>

#include <fmt/format.h>

namespace ff::samplers {
namespace {

/// "625 = 5^4", or the two sizes around `points` where both exist.
std::string nearest_powers(std::uint64_t points, std::size_t dimension) {
    const std::uint64_t below = floor_root(points, dimension);
    const std::uint64_t above_size = integer_power(below + 1, dimension);
    std::string nearest = fmt::format("{} = {}^{}", integer_power(below, dimension), below, dimension);
    if (above_size <= max_points) nearest += fmt::format(" or {} = {}^{}", above_size, below + 1, dimension);
    return nearest;
}

SizeProblem check_power(const SamplerInfo& info, std::uint64_t points, std::size_t dimension) {
    if (integer_power(floor_root(points, dimension), dimension) == points) return {};
    return {fmt::format("{} points ({} puts one point into each of k^{} cells). Nearest: {}.", points, info.name,
                        dimension, nearest_powers(points, dimension)),
            true};
}

/// "625 = 5^4", or "2 * 5^4".
std::string describe(std::uint64_t size, const SamplerInfo& info, std::uint32_t exponent) {
    const std::string factor = info.multiple == 1 ? "" : fmt::format("{} * ", info.multiple);
    return fmt::format("{} = {}{}^{}", size, factor, info.base, exponent);
}

/// Sizes multiple * base^m keep the net property.
SizeProblem check_powers(const SamplerInfo& info, std::uint64_t points) {
    const std::uint32_t digits = count_digits(std::max<std::uint64_t>(points / info.multiple, 1) + 1, info.base);
    const std::uint64_t below = info.multiple * integer_power(info.base, digits - 1);
    if (points == below) return {};
    std::string nearest = describe(below, info, digits - 1);
    if (below * info.base <= max_points) nearest += " or " + describe(below * info.base, info, digits);
    return {fmt::format("{} points ({} has its net property at {} only). Nearest: {}.", points, info.name,
                        sizes_in_words(info), nearest),
            false};
}

/// A set is used from its first point on: any size up to the largest.
SizeProblem check_at_hand(const SamplerInfo& info, std::uint64_t points, std::size_t dimension) {
    if (dimension > info.most_dimension)
        return {fmt::format("points of {} coordinates ({} has {}). Use another estimator, or more columns.", dimension,
                            info.name, info.most_dimension),
                true};
    const auto set = std::lower_bound(info.at_hand.begin(), info.at_hand.end(), points);
    if (set == info.at_hand.end())
        return {fmt::format("{} points ({} has {}). Take fewer samples.", points, info.name, sizes_in_words(info)),
                true};
    if (*set == points) return {};
    return {fmt::format("{} points (the first of {} of {}, which need not be spread as well). Nearest: {}.", points,
                        *set, info.name, *set),
            false};
}

/// The smallest size of at least `points` that the sampler is made for.
std::uint64_t next_size(const SamplerInfo& info, std::uint64_t points, std::size_t dimension) {
    switch (info.sizes) {
        case Sizes::powers: {
            std::uint64_t size = info.multiple;
            while (size < points) size *= info.base;
            return size;
        }
        case Sizes::fourth_power:
            return integer_power(floor_root(points - 1, dimension) + 1, dimension);
        case Sizes::any:
        case Sizes::nodes:
            break;
    }
    return std::bit_ceil(points);
}

}  // namespace

std::uint32_t count_digits(std::uint64_t points, std::uint32_t base) {
    FF_EXPECT(base >= 2 && points <= max_points + 1);
    std::uint32_t digits = 1;
    for (std::uint64_t size = base; size < points; size *= base) ++digits;
    return digits;
}

std::uint64_t floor_root(std::uint64_t points, std::size_t dimension) {
    FF_EXPECT(points <= max_points && dimension >= 1);
    if (dimension == 1) return points;
    std::uint64_t low = 0;
    std::uint64_t high = 1 + (std::uint64_t{1} << (32 + dimension - 1) / dimension);  // high^dimension > 2^32
    while (high - low > 1) {
        const std::uint64_t middle = (low + high) / 2;
        (integer_power(middle, dimension) <= points ? low : high) = middle;
    }
    return low;
}

std::string sizes_in_words(const SamplerInfo& info) {
    if (!info.at_hand.empty()) return fmt::format("sets of {} points", fmt::join(info.at_hand, ", "));
    switch (info.sizes) {
        case Sizes::any:
            return "any number of points";
        case Sizes::powers:
            return info.multiple == 1 ? fmt::format("powers of {}", info.base)
                                      : fmt::format("{} times powers of {}", info.multiple, info.base);
        case Sizes::fourth_power:
            return "fourth powers k^4";
        case Sizes::nodes:
            break;
    }
    return "n nodes a side, 1 to 64";
}

SizeProblem check_size(const SamplerInfo& info, std::uint64_t points, std::size_t dimension) {
    if (points == 0) return {fmt::format("0 points ({} needs at least one). Try 625.", info.name), true};
    if (points > max_points)
        return {fmt::format("{} points (the index of a point has 32 bits). Use at most {} = 2^32, and more trials.",
                            points, max_points),
                true};
    if (!info.at_hand.empty()) return check_at_hand(info, points, dimension);
    switch (info.sizes) {
        case Sizes::any:
        case Sizes::nodes:
            return {};
        case Sizes::powers:
            return check_powers(info, points);
        case Sizes::fourth_power:
            return check_power(info, points, dimension);
    }
    return {};
}

std::vector<std::uint64_t> size_ladder(const SamplerInfo& info, std::uint64_t low, std::uint64_t high,
                                       std::size_t dimension) {
    FF_EXPECT(1 <= low && low <= high && high <= max_points && info.sizes != Sizes::nodes);
    std::vector<std::uint64_t> sizes;
    if (!info.at_hand.empty()) {
        std::copy_if(info.at_hand.begin(), info.at_hand.end(), std::back_inserter(sizes),
                     [&](std::uint64_t size) { return low <= size && size <= high; });
        return sizes;
    }
    for (std::uint64_t octave = std::bit_floor(low); octave <= high; octave *= 2) {
        const std::uint64_t size = next_size(info, std::max(octave, low), dimension);
        if (size < 2 * octave && size <= high) sizes.push_back(size);
    }
    return sizes;
}

}  // namespace ff::samplers
