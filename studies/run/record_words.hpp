#pragma once

#include "studies/store/records.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace ff::studies {

/// A record as 64-bit words, for sending to another process of the same program.
std::vector<std::uint64_t> to_words(const UnitRecord& record);

/// The record from which `to_words` made these. @pre they are unchanged (contract)
UnitRecord from_words(std::span<const std::uint64_t> words);

}  // namespace ff::studies
