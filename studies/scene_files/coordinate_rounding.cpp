#include "studies/scene_files/coordinate_rounding.hpp"

#include "core/geometry/placement.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <limits>
#include <vector>

namespace ff::studies {
namespace {

/// Whether two numbers are the same to readers that do not round to the nearest double.
bool are_same(double a, double b) {
    constexpr double off = 4 * std::numeric_limits<double>::epsilon();
    return std::abs(a - b) <= off * std::abs(b);
}

/// The shortest decimal number that is the same as a value: this many significant digits, the first at 10^exponent.
struct Digits {
    int significant = 0;
    int exponent = 0;

    [[nodiscard]] int decimals() const { return significant - 1 - exponent; }
};

/// More digits mean a double that was not rounded to decimals.
constexpr int most_digits = 14;
/// This many digits distinguish all single-precision numbers.
constexpr int digits_of_single = 9;
/// As many decimal digits as every double keeps: whether far coordinates were written with so many cannot be seen.
constexpr int digits_of_double = 15;
/// Coordinates with fewer digits are taken to be exact.
constexpr int fewest_digits = 6;
/// So many digits are those of coordinates that are just not far.
constexpr double largest_unit = 8e-5;

Digits digits_of(double value) {
    std::array<char, 32> text{};
    for (int digits = 1;; ++digits) {
        const auto [end, ignored] =
            std::to_chars(text.begin(), text.end(), value, std::chars_format::scientific, digits - 1);
        double rounded = 0;
        std::from_chars(text.begin(), end, rounded);
        if (digits <= most_digits && !are_same(rounded, value)) continue;
        const char* const exponent = std::find(text.begin(), end, 'e') + 1;
        Digits found{digits, 0};
        std::from_chars(*exponent == '+' ? exponent + 1 : exponent, end, found.exponent);
        return found;
    }
}

/// Whether decimal numbers were written of single-precision ones: each lies as near to one as its last digit tells,
/// which numbers of so many digits would by chance with a probability of 1e-6. Multiples of large binary fractions are
/// single-precision numbers that nothing was rounded for.
bool are_written_singles(std::span<const double> values, std::span<const Digits> digits) {
    double bits = 0;
    std::size_t telling = 0;
    std::size_t odd = 0;
    for (std::size_t i = 0; i < values.size(); ++i) {
        const double value = std::abs(values[i]);
        if (value == 0) continue;
        const double unit = std::pow(10, -digits[i].decimals());
        const auto single = static_cast<double>(static_cast<float>(value));
        if (std::abs(single - value) > 0.5001 * unit) return false;
        const double spacing = std::ldexp(1, std::ilogb(value) - 23);
        if (spacing <= unit) continue;
        bits += std::log2(spacing / unit);
        ++telling;
        if (std::fmod(single / spacing, 2) == 1) ++odd;
    }
    return bits > 20 && 4 * odd >= telling;
}

}  // namespace

double coordinate_rounding(std::span<const double> values, double size) {
    std::vector<Digits> all;
    int decimals = 0;
    int significant = 0;
    double largest = 0;
    for (const double value : values) {
        all.push_back(digits_of(value));
        largest = std::max(largest, std::abs(value));
        if (all.back().significant > most_digits) continue;
        decimals = std::max(decimals, all.back().decimals());
        significant = std::max(significant, all.back().significant);
    }
    const auto share = [&](const auto& holds) {
        return static_cast<double>(std::count_if(all.begin(), all.end(), holds)) / static_cast<double>(all.size());
    };
    const auto is_single = [](double value) { return are_same(static_cast<double>(static_cast<float>(value)), value); };
    constexpr double most = 0.5;
    if (share([](const Digits& digits) { return digits.significant > digits_of_single; }) > most &&
        std::all_of(values.begin(), values.end(), is_single))
        return largest * 0x1p-24;
    if (are_written_singles(values, all)) return largest * 0x1p-24;
    const double unseen =
        largest > far_off * size ? 0.5 * std::pow(10, digits_of(largest).exponent + 1 - digits_of_double) : 0;
    const double full = share([](const Digits& digits) { return digits.significant > most_digits; });
    if (full > most) return unseen;
    if (significant < fewest_digits) return 0;
    const double as_decimals = share([&](const Digits& digits) { return digits.decimals() == decimals; });
    const double as_significant = share([&](const Digits& digits) { return digits.significant == significant; });
    if (std::max(as_decimals, as_significant) <= most) return full > 0 ? unseen : 0;
    if (as_decimals < as_significant) return 0.5 * std::pow(10, digits_of(largest).exponent + 1 - significant);
    const double unit = std::pow(10, -decimals);
    return unit > largest_unit * size ? 0 : 0.5 * unit;
}

}  // namespace ff::studies
