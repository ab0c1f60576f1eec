#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

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
    fixed_decimals,      ///< a number of decimals, as in C's %.6f
    significant_digits,  ///< a number of significant digits, as in C's %.6g and C++ streams
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

/// Share of the published figures that are taken to be misprinted.
inline constexpr double misprint_share = 0.02;

/// Odds from which the audit contradicts what a publication says.
inline constexpr double refuting_odds = 1e4;

/// Whole numbers from `low` to `high`.
struct HitRange {
    std::int64_t low = 0;
    std::int64_t high = 0;

    [[nodiscard]] std::int64_t count() const { return high - low + 1; }
};

/// The whole numbers h with h / rays in `values`; empty where there is none. @pre rays >= 1
std::optional<HitRange> possible_hits(Range values, std::uint64_t rays);

/// A printed figure that is a number of hits divided by a known number of rays.
struct SampledFigure {
    PrintedNumber number;
    std::uint64_t rays = 1;
};

/// How well a number format explains figures that are hits over rays.
struct FormatEvidence {
    NumberFormat format;
    std::size_t figures = 0;    ///< informative figures: there are fewer numbers of hits than prints
    std::size_t whole = 0;      ///< those among them that are a whole number of hits in this format
    double expected = 0;        ///< expected number of whole ones if the figures were not fractions of the rays
    double chance = 1;          ///< probability of `whole` or more by chance
    double log_likelihood = 0;  ///< natural; of all figures, one in fifty being misprinted
};

/// Evidence for one format. @pre rays >= 1 in all figures
FormatEvidence weigh_format(std::span<const SampledFigure> figures, NumberFormat format);

/// Rounded and truncated, each to `digits` decimals and to `digits` significant digits; the likeliest first, decimals
/// where nothing tells.
std::vector<FormatEvidence> weigh_formats(std::span<const SampledFigure> figures, int digits);

}  // namespace ff::studies::audit
