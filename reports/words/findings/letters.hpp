#pragma once

#include "studies/comparison/ranking.hpp"

#include <cstddef>
#include <span>
#include <string>

namespace ff::reports {

/// Letter of a group: a for the best; empty where all are in one.
std::string letter(std::span<const studies::Ranked> ranked, const studies::Ranked& one);

/// The meaning of the letters, which hold together in all blocks of a picture.
std::string letters_in_words(double level, std::size_t blocks);

}  // namespace ff::reports
