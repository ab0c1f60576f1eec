#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace ff::studies::audit {

/// A closed range of real numbers.
struct Range {
    double low = 0;
    double high = 0;

    [[nodiscard]] double middle() const { return 0.5 * (low + high); }
    [[nodiscard]] bool contains(double value) const { return low <= value && value <= high; }
    [[nodiscard]] bool meets(Range other) const { return low <= other.high && high >= other.low; }
};

/// Range of 100 |x - reference| / reference, the relative errors of the values in a range.
Range deviation(Range x, double reference);

/// A decimal number as printed: digits * 10^-decimals.
struct PrintedNumber {
    std::int64_t digits = 0;
    int decimals = 0;

    [[nodiscard]] double value() const;
};

/// Empty unless `text` is digits with at most one decimal point, at most 16 characters.
std::optional<PrintedNumber> parse_printed(std::string_view text);

/// How the digits that are not printed are dropped.
enum class Rounding { rounded, truncated };

/// How the number of printed digits is determined. In both, trailing zeros may be missing or appended.
enum class Layout {
    fixed_decimals,      ///< as C's %.6f
    significant_digits,  ///< as C's %.6g and C++ streams
};

/// A rule by which numbers become printed figures.
struct NumberFormat {
    Rounding rounding = Rounding::rounded;
    Layout layout = Layout::fixed_decimals;
    int digits = 6;
    bool operator==(const NumberFormat&) const = default;
};

/// "rounded to 6 significant digits" and the like.
std::string describe(NumberFormat format);

/// Distance between neighbouring numbers that the format can print around `value` >= 0.
double printed_unit(double value, NumberFormat format);

/// The numbers that are printed as `number`: a closed range for rounding (ties may go either way), without the upper
/// end for truncation. Empty where the format cannot print it because it has too many digits.
std::optional<Range> printed_range(PrintedNumber number, NumberFormat format);
/// The same; empty also for a text that is not a number.
std::optional<Range> printed_range(std::string_view text, NumberFormat format);

/// `value` >= 0 in the format, trailing zeros kept.
std::string print(double value, NumberFormat format);

/// Least number of digits replaced, inserted, dropped or swapped with their neighbour that turns one print into the
/// other.
int misprint_distance(std::string_view printed, std::string_view meant);

}  // namespace ff::studies::audit
