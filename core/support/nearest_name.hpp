#pragma once

#include <span>
#include <string>
#include <string_view>

namespace ff {

/// The known name that the user most likely meant, for "did you mean" in error messages. Closeness is the least number
/// of letters inserted, deleted, replaced or swapped with their neighbour, ignoring case; among equally close names the
/// first wins.
/// @return empty where no name is near: more than a third of the letters (and more than one) would have to change
/// @see [damerau1964]
std::string nearest_name(std::string_view wanted, std::span<const std::string_view> known);

/// "Did you mean 'cube'? " with the nearest name, for the middle of a message; empty where no name is near.
std::string did_you_mean(std::string_view wanted, std::span<const std::string_view> known, char quote = '\'');

}  // namespace ff
