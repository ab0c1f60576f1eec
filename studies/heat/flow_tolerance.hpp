#pragma once

#include <string>
#include <string_view>

namespace ff::studies::heat {

/// How well every power is to be known.
struct FlowTolerance {
    double amount = 1e-3;
    bool is_power = false;  ///< in W; otherwise a share of what the sources give off

    /// W. @param throughput  what the sources give off
    [[nodiscard]] double power(double throughput) const { return is_power ? amount : amount * throughput; }
};

/// Reads "0.001", "0.1%" or "40W". @param place  for messages, such as "--tolerance" @throws UserError
FlowTolerance read_flow_tolerance(std::string_view place, std::string_view text);

/// As the reader takes it: "0.1%", "40W".
std::string in_words(const FlowTolerance& tolerance);

}  // namespace ff::studies::heat
