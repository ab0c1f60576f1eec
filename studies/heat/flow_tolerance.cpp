#include "studies/heat/flow_tolerance.hpp"

#include "core/support/error.hpp"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <system_error>

namespace ff::studies::heat {

FlowTolerance read_flow_tolerance(std::string_view place, std::string_view text) {
    FlowTolerance tolerance;
    const char* const end = text.data() + text.size();
    const auto [rest, error] = std::from_chars(text.data(), end, tolerance.amount);
    std::string_view unit(rest, static_cast<std::size_t>(end - rest));
    if (unit.starts_with(' ')) unit.remove_prefix(1);
    if (unit == "%") tolerance.amount /= 100;
    tolerance.is_power = unit == "W";
    const bool is_known = error == std::errc{} && (unit.empty() || unit == "%" || unit == "W");
    if (is_known && tolerance.amount > 0 && std::isfinite(tolerance.amount) &&
        (tolerance.is_power || tolerance.amount < 1))
        return tolerance;
    throw UserError(
        fmt::format("{} {} (a share above 0 and below 1, or watts). Write 0.001, 0.1% or 40W.", place, text));
}

std::string in_words(const FlowTolerance& tolerance) {
    return tolerance.is_power ? fmt::format("{:g}W", tolerance.amount) : fmt::format("{:g}%", 100 * tolerance.amount);
}

}  // namespace ff::studies::heat
