#pragma once

#include <cstddef>
#include <optional>
#include <span>

namespace ff::stats {

/// Values of a series that occurred earlier, bit for bit.
struct Repeats {
    std::size_t in_all = 0;   ///< values that are equal to an earlier one
    std::size_t repeats = 0;  ///< those of them that count as repeats
    double expected = 0;      ///< how many are expected by chance among independent values on the same lattice
    double p = 0;             ///< P(at least as many by chance), where every site of the lattice may be taken
    bool certain = false;     ///< several of the repeated values are real numbers with most of their digits
    std::size_t earlier = 0;  ///< index of the first value that occurs again ...
    std::size_t later = 0;    ///< ... and of where it does
};

/// Counts repeated values and judges whether chance explains them. The least value, the largest and 0 do not count:
/// estimates are clipped there, or hit nothing. Counts, and values printed with few digits, lie on a lattice and
/// coincide now and then; of two models of chance, the better explanation decides: a normal distribution on the
/// lattice, whose spacing is the greatest common divisor of the gaps, and the neighbours, since where values crowd, the
/// sites beside them fill too. Where the sites are few enough to be filled, repeats tell nothing. Values without a
/// lattice never coincide by chance. Empty without a repeat, and where repeats tell nothing. If there are only two to
/// four different real values, all repeats count.
///
/// Printed shares of few trials, and sums of several, take few values, which need not be neighbours; and an estimator
/// may give one value often, where nothing happens. So p can be small among honest ones: only where `certain` can one
/// conclude that trials were repeated.
std::optional<Repeats> find_repeats(std::span<const double> values);

/// How many trials repeat an earlier one, bit for bit and in every series, where chance does not explain it; otherwise
/// 0. Chance never does where some series has real numbers with all of their digits. Values on a lattice, ratios of
/// whole numbers and sums of several counts coincide now and then and tell nothing, nor do the least value, the
/// largest, 0, and the commonest trial, which may be what an estimator gives where nothing happens. But where there are
/// no more than four different trials, and every value of every series is such a number, all of them count.
/// @param series  of equal length
std::size_t repeated_trials(std::span<const std::span<const double>> series);

/// The period after which the whole series repeats itself: the least lag <= n/2 at which every value equals the one a
/// lag earlier. Empty where there is none, and where chance produces one with a probability above `alpha`.
std::optional<std::size_t> find_period(std::span<const double> values, double alpha);

}  // namespace ff::stats
