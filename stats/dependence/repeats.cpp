#include "stats/dependence/repeats.hpp"

#include "stats/basics/moments.hpp"

#include <boost/math/special_functions/gamma.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>
#include <map>
#include <numbers>
#include <numeric>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

namespace ff::stats {
namespace {

/// Spacing of the lattice that ascending distinct values lie on; 0 where they lie on none.
/// @param rounding  relative rounding of the largest value; that of single precision unless more is known
double find_spacing(const std::vector<double>& distinct, double rounding = 0x1p-22) {
    std::vector<double> gaps;
    for (std::size_t i = 1; i < distinct.size(); ++i) gaps.push_back(distinct[i] - distinct[i - 1]);
    if (gaps.empty()) return 0;
    const double least = *std::min_element(gaps.begin(), gaps.end());
    // Values of a lattice are dense enough that some are neighbours, or nearly so.
    const double largest = std::max(std::abs(distinct.front()), std::abs(distinct.back()));
    const double none = std::min(least / 50, largest * rounding);
    double spacing = least;
    for (double gap : gaps) {
        while (gap > none) {
            const double rest = std::abs(std::remainder(gap, spacing));
            if (rest <= none) break;
            gap = spacing;
            spacing = rest;
        }
        if (spacing <= none * 2) return 0;
    }
    return spacing;
}

/// Expected number, out of n draws from a normal distribution on a lattice, of those that equal an earlier one.
/// @param crowding  n * spacing / sigma
double expected_repeats(double n, double crowding) {
    if (crowding == 0) return 0;
    constexpr double reach = 8;
    constexpr int steps = 1600;
    // Sites are hit with rate a = crowding * density, and hit a - (1 - exp(-a)) times too often.
    double sum = 0;
    for (int i = 0; i <= steps; ++i) {
        const double z = reach * (2.0 * i / steps - 1);
        const double rate = crowding * std::exp(-z * z / 2) / std::sqrt(2 * std::numbers::pi);
        sum += rate + std::expm1(-rate);
    }
    return n / crowding * sum * (2 * reach / steps);
}

/// How often a value occurs, and where first.
struct Occurrences {
    std::size_t count = 0;
    std::size_t first = 0;
    std::size_t second = 0;
};

/// Whether so few sites lie between the least and the largest value that any number of values fills them: counts of
/// rare events, or values out of a few. Their repeats say nothing.
bool is_coarse(const std::vector<double>& distinct, double spacing) {
    if (distinct.size() < 3) return true;
    const double sites =
        spacing > 0 ? (distinct.back() - distinct.front()) / spacing + 1 : std::numeric_limits<double>::infinity();
    return sites <= 1.25 * static_cast<double>(distinct.size());
}

/// Spacing of printed values over their power of ten, by the one with most digits: 1e-3 for four digits, 0 for values
/// with all of theirs.
double relative_grain(const std::vector<double>& distinct) {
    std::size_t digits = 1;
    for (const double value : distinct) {
        std::string text = fmt::format("{}", std::abs(value));  // shortest that reads back
        text.resize(std::min(text.find('e'), text.size()));
        std::erase(text, '.');
        const auto first = text.find_first_of("123456789");
        if (first != std::string::npos) digits = std::max(digits, text.find_last_not_of('0') - first + 1);
    }
    constexpr std::size_t all_digits = 15;
    return digits < all_digits ? std::pow(10.0, 1 - static_cast<double>(digits)) : 0;
}

/// Expected number of repeats, from the pairs of values on neighbouring sites: where the density hardly changes from
/// site to site, as many values fall on a site as on each of the sites beside it.
double repeats_by_neighbours(const std::map<double, Occurrences>& values, double spacing, double grain) {
    double pairs = 0;
    for (auto value = values.begin(); value != values.end(); ++value) {
        const double size = std::abs(value->first);
        const double own = grain * std::pow(10.0, std::floor(std::log10(size)));
        const double near = 1.5 * std::max(spacing, own);
        for (auto next = std::next(value); next != values.end() && next->first - value->first <= near; ++next)
            pairs += static_cast<double>(value->second.count) * static_cast<double>(next->second.count);
    }
    return pairs / 2;  // a site has neighbours on both sides
}

/// Whether a number is, to rounding, the ratio of two whole numbers so small that one real number in a thousand is:
/// below 2^20 in double precision.
bool is_ratio(double value, double rounding) {
    const double most = std::sqrt(1e-3 / rounding);
    double rest = std::abs(value);
    std::array<double, 2> above{1, std::floor(rest)};
    std::array<double, 2> below{0, 1};
    while (std::max(above[1], below[1]) < most) {
        if (std::abs(above[1] / below[1] - std::abs(value)) <= std::abs(value) * rounding) return true;
        rest = 1 / (rest - std::floor(rest));
        if (!std::isfinite(rest)) return false;
        above = {above[1], std::floor(rest) * above[1] + above[0]};
        below = {below[1], std::floor(rest) * below[1] + below[0]};
    }
    return false;
}

/// Whether more than one in a hundred differences of ascending values equals another, as those of a * i + b * j with
/// whole i and j do.
bool differences_repeat(const std::vector<double>& distinct, double grain) {
    const std::size_t some = std::min<std::size_t>(distinct.size(), 200);
    std::vector<double> differences;
    for (std::size_t i = 0; i < some; ++i) {
        for (std::size_t j = i + 1; j < some; ++j) differences.push_back(distinct[j] - distinct[i]);
    }
    std::sort(differences.begin(), differences.end());
    const double rounding = std::max(std::abs(distinct.front()), std::abs(distinct.back())) * std::max(0x1p-46, grain);
    std::size_t equal = 0;
    for (std::size_t i = 1; i < differences.size(); ++i)
        equal += differences[i] - differences[i - 1] <= rounding ? 1u : 0u;
    return 100 * equal > differences.size();
}

/// Values printed with ten digits or more; with fewer, ratios and sums of counts cannot be distinguished from real
/// numbers.
constexpr double finest_printed = 1.001e-9;

/// Whether ascending distinct values, of n in all, lie on a lattice. A lattice with so many sites that n values hardly
/// ever share one explains no repeats, and the gaps may suggest it by chance; values that occur four times each fill
/// their sites.
bool lie_on_lattice(const std::vector<double>& distinct, std::size_t n) {
    const double spacing = find_spacing(distinct);
    const auto all = static_cast<double>(n);
    const auto different = static_cast<double>(distinct.size());
    const double most_sites = all < 4 * different ? all * all / 4 : 4 * different;
    return spacing > 0 && distinct.back() - distinct.front() <= most_sites * spacing;
}

/// Whether ascending values are roots of counts, as standard errors are, or of products of counts.
bool are_roots_of_counts(const std::vector<double>& distinct, double grain) {
    const double rounding = std::max(0x1p-30, 64 * grain);
    const double largest = std::pow(std::max(std::abs(distinct.front()), std::abs(distinct.back())), 2);
    std::vector<double> squares;
    for (const double value : distinct) {
        const double square = value * std::abs(value);
        if (squares.empty() || square - squares.back() > rounding * largest) squares.push_back(square);
    }
    return find_spacing(squares, rounding) > 1000 * rounding * largest;  // a finer one is made by chance
}

/// Up to this many different values each of them counts, including the least and the largest.
constexpr std::size_t most_few = 4;

/// Whether ascending distinct values, of n in all, are real numbers, which chance never makes equal.
/// @param coarsest  the largest relative_grain that they may have
bool are_real(const std::vector<double>& distinct, std::size_t n, double coarsest) {
    const double grain = relative_grain(distinct);
    if (distinct.size() < 3 || grain > coarsest || lie_on_lattice(distinct, n)) return false;
    if (are_roots_of_counts(distinct, grain)) return false;
    const double rounding = std::max(0x1p-50, grain);
    const auto ratios = static_cast<std::size_t>(
        std::count_if(distinct.begin(), distinct.end(), [&](double value) { return is_ratio(value, rounding); }));
    return 4 * ratios < distinct.size() && !differences_repeat(distinct, grain);
}

/// The same for two to four values: none is 0 or short, and neither they, nor their differences, nor the ratios of
/// these are ratios of whole numbers, as those of shifted or weighted counts are.
bool are_few_reals(const std::vector<double>& distinct) {
    if (distinct.size() < 2 || distinct.size() > most_few || relative_grain(distinct) > 0) return false;
    constexpr double exact = 0x1p-50;
    for (std::size_t i = 0; i < distinct.size(); ++i) {
        if (distinct[i] == 0 || is_ratio(distinct[i], exact)) return false;
        for (std::size_t j = 0; j < i; ++j) {
            const double gap = distinct[i] - distinct[j];
            const double rounding = std::abs(distinct[i]) / gap * exact;
            if (is_ratio(distinct[j] / distinct[i], 2 * exact) || is_ratio(gap, rounding)) return false;
            if (i > 1 && is_ratio(gap / (distinct[1] - distinct[0]), 4 * rounding)) return false;
        }
    }
    return true;
}

}  // namespace

std::optional<Repeats> find_repeats(std::span<const double> values) {
    std::map<double, Occurrences> seen;
    for (std::size_t i = 0; i < values.size(); ++i) {
        Occurrences& here = seen[values[i] + 0.0];  // -0 is 0
        if (here.count++ == 0) here.first = i;
        if (here.count == 2) here.second = i;
    }
    std::vector<double> distinct;
    for (const auto& [value, here] : seen) distinct.push_back(value);
    Repeats found;
    found.in_all = values.size() - distinct.size();
    const double spacing = find_spacing(distinct);
    if (are_few_reals(distinct) && found.in_all > distinct.size()) {
        found.repeats = found.in_all;
        const auto later = std::min_element(seen.begin(), seen.end(), [](const auto& a, const auto& b) {
            return std::pair(a.second.count < 2, a.second.second) < std::pair(b.second.count < 2, b.second.second);
        });
        found.earlier = later->second.first;
        found.later = later->second.second;
        return found;
    }
    if (is_coarse(distinct, spacing)) return std::nullopt;

    std::map<double, Occurrences> inner;
    std::size_t repeating = 0;  // values that do
    for (const auto& [value, here] : seen) {
        if (value == distinct.front() || value == distinct.back() || value == 0) continue;
        inner.emplace(value, here);
        found.repeats += here.count - 1;
        repeating += here.count > 1;
        if (here.count == 1 || (found.later > 0 && here.second > found.later)) continue;
        found.earlier = here.first;
        found.later = here.second;
    }
    const auto n = static_cast<double>(values.size());
    if (found.repeats == 0) return std::nullopt;
    found.certain = repeating > 1 && are_real(distinct, values.size(), finest_printed);
    const double grain = relative_grain(distinct);
    const double normal =
        distinct.size() > 1 ? expected_repeats(n, n * spacing / *moments_of(values).standard_deviation()) : 0;
    const double nearby = repeats_by_neighbours(inner, spacing, grain);
    found.expected = normal > 0 ? normal : nearby;
    if (spacing == 0 && grain == 0) return found;  // p = 0
    constexpr double uneven = 1.3;                 // factor that a steep density adds on its highest sites
    const auto repeats = static_cast<double>(found.repeats);
    found.p = std::max(normal > 0 ? boost::math::gamma_p(repeats, normal) : 0,
                       boost::math::gamma_p(repeats, uneven * (nearby + 1)));
    return found;
}

std::size_t repeated_trials(std::span<const std::span<const double>> series) {
    const auto is_finite = [](double value) { return std::isfinite(value); };
    for (const auto values : series) {
        if (!std::all_of(values.begin(), values.end(), is_finite)) return 0;
    }
    std::vector<std::size_t> order(series.empty() ? 0 : series.front().size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    const auto is_before = [&](std::size_t a, std::size_t b) {
        const auto differing =
            std::find_if(series.begin(), series.end(), [&](const auto values) { return values[a] != values[b]; });
        return differing != series.end() && (*differing)[a] < (*differing)[b];
    };
    std::sort(order.begin(), order.end(), is_before);
    std::vector<std::pair<std::size_t, std::size_t>> repeating;  // number of repeats, trial
    std::size_t repeats = 0;
    std::size_t different = 0;
    for (std::size_t begin = 0, end = 0; begin < order.size(); begin = end) {
        while (end < order.size() && !is_before(order[begin], order[end])) ++end;
        repeats += end - begin - 1;
        ++different;
        if (end - begin > 1) repeating.emplace_back(end - begin - 1, order[begin]);
    }
    if (repeating.size() < 2) return 0;
    std::iter_swap(repeating.begin(), std::max_element(repeating.begin(), repeating.end()));
    bool are_few = different <= most_few;
    for (const auto values : series) {
        std::vector<double> distinct(values.begin(), values.end());
        std::sort(distinct.begin(), distinct.end());
        distinct.erase(std::unique(distinct.begin(), distinct.end()), distinct.end());
        const auto counts = [&](const auto& trial) {
            const double value = values[trial.second];
            return value != distinct.front() && value != distinct.back() && value != 0;
        };
        if (are_real(distinct, values.size(), 0) && std::any_of(std::next(repeating.begin()), repeating.end(), counts))
            return repeats;
        are_few = are_few && are_few_reals(distinct);
    }
    return are_few ? repeats : 0;
}

std::optional<std::size_t> find_period(std::span<const double> values, double alpha) {
    const std::size_t n = values.size();
    std::unordered_map<double, double> counts;
    for (const double value : values) ++counts[value];
    double coincidence = 0;  // probability that two values are equal
    for (const auto& [value, count] : counts) coincidence += std::pow(count / static_cast<double>(n), 2);
    for (std::size_t lag = 1; lag <= n / 2; ++lag) {
        if (!std::equal(values.begin() + static_cast<std::ptrdiff_t>(lag), values.end(), values.begin())) continue;
        const double by_chance = static_cast<double>(n) / 2 * std::pow(coincidence, static_cast<double>(n - lag));
        return by_chance <= alpha ? std::optional(lag) : std::nullopt;
    }
    return std::nullopt;
}

}  // namespace ff::stats
