#include "reports/text/numbers.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace ff::reports {

std::string exact(std::optional<double> value) {
    return value && std::isfinite(*value) ? fmt::format("{}", *value) : std::string();
}

std::string to_error(double value, double error) {
    if (!(error > 0 && std::isfinite(error))) return fmt::format("{:.8g}", value);
    const auto magnitude = [](double x) { return static_cast<int>(std::floor(std::log10(x))); };
    const double size = std::abs(value);
    if (size < 1e-4 && size >= error) return fmt::format("{:.{}e}", value, magnitude(size) - magnitude(error) + 1);
    const int decimals = std::clamp(1 - magnitude(error), 0, 15);
    const bool is_zero = size < 0.5 * std::pow(10.0, -decimals);  // zero has no sign
    return fmt::format("{:.{}f}", is_zero ? 0.0 : value, decimals);
}

std::string with_half_width(double value, double half) {
    if (half == 0) return to_error(value, half);
    if (!std::isfinite(half)) return fmt::format("{} ± {}", to_error(value, half), brief(half));
    const std::string shown = to_error(value, std::strtod(fmt::format("{:.1e}", half).c_str(), nullptr));  // 0.996: 1.0
    if (shown.find('e') != std::string::npos) return fmt::format("{} ± {:.1e}", shown, half);
    const std::size_t decimals = shown.size() - std::min(shown.find('.'), shown.size() - 1) - 1;
    return fmt::format("{} ± {:.{}f}", shown, half, decimals);
}

std::string brief(double value, int digits) {
    if (std::isinf(value)) return value > 0 ? "∞" : "-∞";
    const std::string text = fmt::format("{:.{}g}", value, digits);
    constexpr double large = 1e6;
    const double shown = std::strtod(text.c_str(), nullptr);
    return std::abs(shown) >= 1 && std::abs(shown) < large ? fmt::format("{}", shown) : text;
}

std::string with_ends(double value, double low, double high, int digits) {
    return fmt::format("{} [{}, {}]", brief(value, digits), brief(low, digits), brief(high, digits));
}

std::string ends_in_words(double low, double high) {
    if (!std::isfinite(high)) return "at least " + brief(low);
    return brief(low) == brief(high) ? brief(low) : fmt::format("{} to {}", brief(low), brief(high));
}

std::string to_error_with_ends(double value, double low, double high, double error) {
    return fmt::format("{} [{}, {}]", to_error(value, error), to_error(low, error), to_error(high, error));
}

std::string p_value(double p) {
    return p < 1e-10 ? "< 1e-10" : fmt::format("{:.2g}", p);
}

std::string p_text(double p) {
    return p < 1e-10 ? "p < 1e-10" : fmt::format("p = {:.2g}", p);
}

std::string seconds_in_words(double seconds) {
    return seconds < 100 ? fmt::format("{:.1f} s", seconds) : fmt::format("{:.1f} min", seconds / 60);
}

std::string thousands_apart(std::uint64_t number) {
    std::string digits = std::to_string(number);
    for (auto at = static_cast<std::ptrdiff_t>(digits.size()) - 3; at > 0; at -= 3)
        digits.insert(static_cast<std::size_t>(at), " ");
    return digits;
}

std::string counted(std::size_t number, std::string_view thing) {
    return fmt::format("{} {}{}", number, thing, number == 1 ? "" : "s");
}

}  // namespace ff::reports
