#include "stats/dependence/independence.hpp"

#include "core/support/contract.hpp"
#include "stats/basics/distributions.hpp"

#include <numeric>
#include <vector>

namespace ff::stats {

std::optional<double> p_of_independence(std::span<const double> values, std::size_t repetitions) {
    constexpr std::size_t fewest_repetitions = 4;
    if (repetitions < fewest_repetitions) return std::nullopt;
    FF_EXPECT(values.size() % repetitions == 0);
    // With variables as vectors of length 1 around their means, the sum of all squared products of two variables, which
    // are correlation coefficients, is that of the squared entries of the sum of their outer products.
    std::vector<double> outer(repetitions * repetitions);
    std::vector<double> centred(repetitions);
    double variables = 0;
    for (std::size_t first = 0; first < values.size(); first += repetitions) {
        const auto variable = values.subspan(first, repetitions);
        const double mean = std::accumulate(variable.begin(), variable.end(), 0.0) / static_cast<double>(repetitions);
        double squares = 0;
        for (std::size_t i = 0; i < repetitions; ++i) {
            centred[i] = variable[i] - mean;
            squares += centred[i] * centred[i];
        }
        if (squares == 0) continue;
        ++variables;
        for (std::size_t i = 0; i < repetitions; ++i) {
            const double scaled = centred[i] / squares;
            for (std::size_t j = 0; j < repetitions; ++j) outer[i * repetitions + j] += scaled * centred[j];
        }
    }
    if (variables < 2) return std::nullopt;
    const double squares = std::inner_product(outer.begin(), outer.end(), outer.begin(), 0.0);
    const double of_pairs = (squares - variables) / 2;
    const auto freedom = static_cast<double>(repetitions - 1);
    const double pairs = variables * (variables - 1) / 2;
    const double mean = pairs / freedom;
    const double variance = pairs * 2 * (freedom - 1) / (freedom * freedom * (freedom + 2));
    return chi_squared_tail(2 * mean / variance * of_pairs, 2 * mean * mean / variance);
}

}  // namespace ff::stats
