#include "studies/form_factors/closure.hpp"

#include "stats/basics/distributions.hpp"
#include "studies/form_factors/sampled_row.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace ff::studies::form_factors {
namespace {

/// How much may be missing from a row's sum, and by how much it may be too large.
struct Misses {
    double missing = 0;
    double excess = 0;
};

/// The part that an entry lacks is missing from both rows that share it; where only one of them is known to miss
/// anything, that one counts.
double common(double first, double second) {
    return first > 0 && second > 0 ? std::min(first, second) : std::max(first, second);
}

/// A share of lost rays, with an allowance for chance where few are lost.
double share_of(const std::pair<std::uint64_t, std::uint64_t>& lost) {
    constexpr double unseen = 3;
    return lost.first == 0
               ? 0
               : std::min(1.0, (static_cast<double>(lost.first) + unseen) / static_cast<double>(lost.second));
}

/// By how much the entries of a row cannot add up to 1, whatever chance did to them, in areas of exchange.
std::vector<Misses> misses_of_entries(const Matrix& matrix) {
    constexpr double rounding = 1e-12;
    const double widest = widest_by_chance(matrix);
    std::vector<std::pair<double, double>> sums(matrix.faces());
    for (const FaceExchange& exchange : matrix.exchanges) {
        const auto [low, high] = widened(exchange, exchange.is_sampled() ? widest : 1);
        const auto add = [&, least = low, most = high](std::size_t face) {
            sums[face].first += least;
            sums[face].second += most;
        };
        add(exchange.from);
        if (exchange.to != exchange.from) add(exchange.to);
    }
    std::vector<Misses> misses(matrix.faces());
    for (std::size_t face = 0; face < matrix.faces(); ++face) {
        const auto& [low, high] = sums[face];
        const double area = matrix.areas[face];
        if (area - high > rounding * area) misses[face].missing = area - high;
        if (low - area > rounding * area) misses[face].excess = low - area;
    }
    return misses;
}

}  // namespace

std::pair<double, double> widened(const FaceExchange& exchange, double factor) {
    return {exchange.low - (factor - 1) * (exchange.value - exchange.low),
            exchange.high + (factor - 1) * (exchange.high - exchange.value)};
}

double widest_by_chance(const Matrix& matrix) {
    constexpr double chance = 1e-6;
    constexpr auto freedom = static_cast<double>(randomisations - 1);
    const auto sampled = std::ranges::count_if(matrix.exchanges, &FaceExchange::is_sampled);
    const double tail = (1 - matrix.entry_level) / 2;
    const double smaller = chance / 2 / static_cast<double>(std::max<std::ptrdiff_t>(1, sampled));
    return tail <= smaller ? 1 : stats::student_critical(freedom, smaller) / stats::student_critical(freedom, tail);
}

void judge_closure(Matrix& matrix, const LostRays& lost, bool add_up, const Request& request) {
    double most = 0;
    for (const RowSum& row : matrix.rows) most = std::max(most, row.off_one);
    if (most > request.tolerance) {
        for (RowSum& row : matrix.rows) row.excludes_one = row.off_one > 0;
        return;
    }
    // Entries may be known better than the row's sum is, which has to allow for what no point has met.
    std::vector<Misses> misses(matrix.faces());
    if (add_up) misses = misses_of_entries(matrix);
    for (std::size_t face = 0; face < matrix.faces(); ++face) {
        const RowSum& row = matrix.rows[face];
        const double area = matrix.areas[face];
        Misses& own = misses[face];
        if (std::max(own.missing, own.excess) > request.tolerance * area)
            own = {};  // no gap of that size is allowed for
        const bool is_off = row.off_one > 0;
        if (is_off || own.missing > 0 || own.excess > 0) matrix.leak = std::max(matrix.leak, std::abs(1 - row.value));
        own.missing = std::max({own.missing, is_off ? (1 - row.low) * area : 0, share_of(lost[face]) * area});
        own.excess = std::max(own.excess, is_off ? (row.high - 1) * area : 0);
        matrix.leak = std::max(matrix.leak, share_of(lost[face]));
    }
    if (matrix.leak == 0) return;
    const auto widen = [&](FaceExchange& exchange, double missing, double excess) {
        const double limit = std::max(exchange.high, matrix.smaller_area(exchange));
        exchange.high = std::min(limit, exchange.high + missing);
        exchange.low = std::max(0.0, exchange.low - excess);
    };
    const auto most_missing = [&](std::size_t face) {
        return add_up ? std::max(0.0, 1 - matrix.rows[face].low) * matrix.areas[face] : matrix.areas[face];
    };
    for (FaceExchange& exchange : matrix.exchanges) {
        const Misses& from = misses[exchange.from];
        const Misses& to = misses[exchange.to];
        const double most_of_both = std::min(most_missing(exchange.from), most_missing(exchange.to));
        widen(exchange, std::min(most_of_both, common(from.missing, to.missing)), common(from.excess, to.excess));
    }
    // A row may miss more than all that it shares with others.
    const std::vector<Misses> left = add_up ? misses_of_entries(matrix) : std::vector<Misses>(matrix.faces());
    for (FaceExchange& exchange : matrix.exchanges) {
        const auto at_most = [&](double Misses::*which, std::size_t face) {
            return left[face].*which <= request.tolerance * matrix.areas[face] ? left[face].*which : 0;
        };
        widen(exchange, std::max(at_most(&Misses::missing, exchange.from), at_most(&Misses::missing, exchange.to)),
              std::max(at_most(&Misses::excess, exchange.from), at_most(&Misses::excess, exchange.to)));
        exchange.within = is_within(matrix, exchange, request);
    }
}

}  // namespace ff::studies::form_factors
