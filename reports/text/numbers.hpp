#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace ff::reports {

/// The shortest decimal that reads back as the same double; empty text for no value or one that is not finite.
std::string exact(std::optional<double> value);

/// A value with as many decimals as its error warrants: the error's second significant digit is the last one shown, or
/// the eighth where the error is 0 or not a number. Has an exponent below 1e-4, unless the error is larger.
std::string to_error(double value, double error);

/// A value and half the width of its interval, both to the second significant digit of the half width:
/// "0.00055 ± 0.00030", "4.07e-05 ± 3.0e-06". The value alone where that is 0.
std::string with_half_width(double value, double half);

/// A few significant digits; values below 1e-4, and from a million on, have an exponent: "0.0123", "7.7e-05", "1930".
std::string brief(double value, int digits = 3);

/// A value and the ends of its interval or range, each brief: "0.11 [0.02, 0.31]".
std::string with_ends(double value, double low, double high, int digits = 3);

/// The ends of an interval, each brief: "2.1 to 2.4", or "at least 2.1" where it has no upper end.
std::string ends_in_words(double low, double high);

/// The same, with as many decimals as the error warrants: "0.502 [0.498, 0.506]".
std::string to_error_with_ends(double value, double low, double high, double error);

/// A p-value: two significant digits, "< 1e-10" below that.
std::string p_value(double p);

/// The same in a sentence: "p = 0.03", "p < 1e-10".
std::string p_text(double p);

/// A time: "12.3 s", "2.5 min" from 100 seconds on.
std::string seconds_in_words(double seconds);

/// A number with spaces between thousands, so that counts of samples can be read: "1 234 567".
std::string thousands_apart(std::uint64_t number);

/// "1 face", "2 faces"
std::string counted(std::size_t number, std::string_view thing);

}  // namespace ff::reports
