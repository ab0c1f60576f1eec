#pragma once

#include "studies/audit/hit_counts.hpp"
#include "studies/audit/printed_number.hpp"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>

namespace ff::studies::audit {

/// What a misprinted figure should have been.
struct Correction {
    std::size_t figure = 0;
    std::string printed;
    std::string meant;             ///< among the prints that remain possible, the nearest to the printed one
    bool certain = false;          ///< no other print remains possible
    Range values;                  ///< values of the quantity that everything else allows
    std::optional<HitRange> hits;  ///< the same in hits
    int edits = 0;                 ///< digits to change: misprint_distance(printed, meant)
    double units = 0;  ///< distance from the printed to the nearest possible value, in units of the last digit
};

/// Finds the possible print that is typographically nearest to the printed one; among equally near ones, the nearest to
/// the middle of the range.
/// @param rays  of a figure that is hits over rays
/// @param is_consistent  whether some number in a range agrees with everything else; `values` may be wider
Correction correct(std::string_view printed, Range values, NumberFormat format, std::optional<std::uint64_t> rays,
                   const std::function<bool(Range)>& is_consistent);

}  // namespace ff::studies::audit
