#pragma once

#include "samplers/sampler.hpp"

#include <cstdint>
#include <string_view>
#include <vector>

namespace ff::studies {

/// Numbers of points as a user writes them: "1000", "5^4", several separated by commas, and ranges "2^6..2^16", which
/// stand for the sizes within them that the sampler is made for, about one per octave
/// (samplers/support/sizes.hpp).
/// @throws UserError "(why). Suggestion.", to append to the text and its place
std::vector<std::uint64_t> read_sample_sizes(std::string_view text, const samplers::SamplerInfo& sampler,
                                             std::size_t dimension);

}  // namespace ff::studies
