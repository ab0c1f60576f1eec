#include "reports/text/numbers.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

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
    return fmt::format("{:.{}f}", value, decimals);
}

std::string brief(double value, int digits) {
    if (std::isinf(value)) return value > 0 ? "∞" : "-∞";
    return fmt::format("{:.{}g}", value, digits);
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

}  // namespace ff::reports
