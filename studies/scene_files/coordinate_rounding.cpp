#include "studies/scene_files/coordinate_rounding.hpp"

#include "core/geometry/placement.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <limits>
#include <utility>
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

/// What the numbers of a scene say of how they were rounded.
class Decimals {
  public:
    explicit Decimals(std::span<const double> values) {
        for (const double value : values) {
            all_.push_back(digits_of(value));
            largest_ = std::max(largest_, std::abs(value));
            if (all_.back().significant > most_digits) continue;
            decimals_ = std::max(decimals_, all_.back().decimals());
            significant_ = std::max(significant_, all_.back().significant);
        }
    }

    [[nodiscard]] std::span<const Digits> all() const { return all_; }
    [[nodiscard]] double largest() const { return largest_; }
    [[nodiscard]] int significant() const { return significant_; }          ///< at most, where a number is not full
    [[nodiscard]] double unit() const { return std::pow(10, -decimals_); }  ///< of the last decimal of any
    /// The unit of the last significant digit of the largest number, where that has as many as any.
    [[nodiscard]] double significant_unit() const {
        return std::pow(10, digits_of(largest_).exponent + 1 - significant_);
    }

    template <typename Holds>
    [[nodiscard]] double share(const Holds& holds) const {
        return static_cast<double>(std::count_if(all_.begin(), all_.end(), holds)) / static_cast<double>(all_.size());
    }
    [[nodiscard]] double share_of_decimals(int decimals) const {
        return share([&](const Digits& digits) { return digits.decimals() == decimals; });
    }
    /// The share of numbers that have the last decimal of any.
    [[nodiscard]] double share_of_unit() const { return share_of_decimals(decimals_); }
    [[nodiscard]] double share_of_significant() const {
        return share([&](const Digits& digits) { return digits.significant == significant_; });
    }

  private:
    std::vector<Digits> all_;
    int decimals_ = 0;
    int significant_ = 0;
    double largest_ = 0;
};

/// A larger share of all numbers is most of them.
constexpr double most = 0.5;

/// The largest unit that all numbers are multiples of, within this distance; 0 where there is none but rounding.
double common_unit(std::span<const double> values, double rounding) {
    double unit = 0;
    for (const double value : values) {
        for (double rest = std::abs(value); rest > rounding;) {
            const double next = std::abs(std::remainder(unit, rest));
            unit = std::exchange(rest, next);
        }
        // Differences of large numbers leave few digits; as a share of one of them the unit has all again.
        if (std::abs(value) > rounding) unit = std::abs(value) / std::round(std::abs(value) / unit);
    }
    return unit > 20 * rounding ? unit : 0;
}

}  // namespace

double coordinate_rounding(std::span<const double> values, double size) {
    const Decimals decimals(values);
    const auto is_single = [](double value) { return are_same(static_cast<double>(static_cast<float>(value)), value); };
    if (decimals.share([](const Digits& digits) { return digits.significant > digits_of_single; }) > most &&
        std::all_of(values.begin(), values.end(), is_single))
        return decimals.largest() * 0x1p-24;
    if (are_written_singles(values, decimals.all())) return decimals.largest() * 0x1p-24;
    const double unseen = decimals.largest() > far_off * size
                              ? 0.5 * std::pow(10, digits_of(decimals.largest()).exponent + 1 - digits_of_double)
                              : 0;
    const double full = decimals.share([](const Digits& digits) { return digits.significant > most_digits; });
    if (full > most) return unseen;
    if (decimals.significant() < fewest_digits) return 0;
    const double as_decimals = decimals.share_of_unit();
    const double as_significant = decimals.share_of_significant();
    if (std::max(as_decimals, as_significant) <= most) return full > 0 ? unseen : 0;
    if (as_decimals < as_significant) return 0.5 * decimals.significant_unit();
    return decimals.unit() > largest_unit * size ? 0 : 0.5 * decimals.unit();
}

double coordinate_step(std::span<const double> values, double size) {
    constexpr double coarsest = 0.01;  // share of the scene's size, as the next two
    constexpr double coarsest_unit = 0.005;
    constexpr double finest = 1e-7;
    constexpr double often = 0.3;  // a larger share of numbers with so many decimals is no chance
    const Decimals decimals(values);
    double step = 0;
    const auto consider = [&](double unit) {
        if (unit <= coarsest * size) step = std::max(step, unit);
    };
    for (int count = 0; count < most_digits; ++count) {
        if (decimals.share_of_decimals(count) > often) consider(std::pow(10, -count));
    }
    if (decimals.share_of_significant() > most) consider(decimals.significant_unit());
    const double unit = common_unit(values, finest * size);
    if (unit <= coarsest_unit * size) consider(unit);
    // What is known to be rounded needs no doubt.
    return step > std::max(finest * size, 3 * coordinate_rounding(values, size)) ? step : 0;
}

}  // namespace ff::studies
