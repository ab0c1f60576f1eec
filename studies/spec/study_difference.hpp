#pragma once

#include <string>
#include <string_view>

namespace ff::studies {

/// The first section and key in which two studies, both written by `to_toml`, differ, and the number of other differing
/// keys: "[study]: 'seed = 1' there, 'seed = 2' here". Methods are matched by name. Empty where the texts are equal.
std::string first_difference(std::string_view stored, std::string_view wanted);

}  // namespace ff::studies
