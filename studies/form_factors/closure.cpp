#include "studies/form_factors/closure.hpp"

#include <algorithm>
#include <cstddef>

namespace ff::studies::form_factors {
namespace {

/// What may be missing of a row's sum, and what may be too much.
struct Misses {
    double missing = 0;
    double excess = 0;
};

/// Of two rows that share an entry, both miss what it lacks; where only one is known to miss anything, that counts.
double common(double first, double second) {
    return first > 0 && second > 0 ? std::min(first, second) : std::max(first, second);
}

/// A share of rays, with what may be by chance where few are lost.
double share_of(const std::pair<std::uint64_t, std::uint64_t>& lost) {
    constexpr double unseen = 3;
    return lost.first == 0
               ? 0
               : std::min(1.0, (static_cast<double>(lost.first) + unseen) / static_cast<double>(lost.second));
}

}  // namespace

void judge_closure(Matrix& matrix, const std::vector<std::pair<std::uint64_t, std::uint64_t>>& lost,
                   const Request& request) {
    double most = 0;
    for (const RowSum& row : matrix.rows) most = std::max(most, row.off_one);
    if (most > request.tolerance) {
        for (RowSum& row : matrix.rows) row.excludes_one = row.off_one > 0;
        return;
    }
    std::vector<Misses> misses(matrix.faces());
    for (std::size_t face = 0; face < matrix.faces(); ++face) {
        const RowSum& row = matrix.rows[face];
        const bool is_off = row.off_one > 0;
        misses[face].missing = std::max(is_off ? 1 - row.low : 0, share_of(lost[face])) * matrix.areas[face];
        misses[face].excess = std::max(0.0, is_off ? row.high - 1 : 0) * matrix.areas[face];
        matrix.leak = std::max({matrix.leak, row.off_one, share_of(lost[face])});
    }
    if (matrix.leak == 0) return;
    for (FaceExchange& exchange : matrix.exchanges) {
        const Misses& from = misses[exchange.from];
        const Misses& to = misses[exchange.to];
        const double smaller = std::min(matrix.areas[exchange.from], matrix.areas[exchange.to]);
        exchange.high = std::min(std::max(exchange.high, smaller), exchange.high + common(from.missing, to.missing));
        exchange.low = std::max(0.0, exchange.low - common(from.excess, to.excess));
        exchange.within = is_within(matrix, exchange, request);
    }
}

}  // namespace ff::studies::form_factors
