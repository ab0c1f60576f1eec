#pragma once

#include "studies/audit/hit_counts.hpp"
#include "studies/audit/printed_number.hpp"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>

namespace ff::studies {

/// What a misprinted figure should have been.
struct Correction {
    std::size_t figure = 0;
    std::string printed;
    std::string meant;             ///< the print nearest to what is printed among those that remain possible
    bool certain = false;          ///< no other print remains possible
    Range values;                  ///< that everything else leaves to the quantity
    std::optional<HitRange> hits;  ///< the same in hits
    int edits = 0;                 ///< digits to change: misprint_distance(printed, meant)
    double units = 0;              ///< from what is printed to the nearest possible value, in units of its last digit
};

/// Looks for the print that remains possible and is typographically nearest to what is printed; between equally near
/// ones, nearest to the middle of the range.
/// @param rays  of a figure that is hits over rays
/// @param is_consistent  whether numbers in a range agree with everything else; `values` may be wider than that
Correction correct(std::string_view printed, Range values, NumberFormat format, std::optional<std::uint64_t> rays,
                   const std::function<bool(Range)>& is_consistent);

}  // namespace ff::studies
