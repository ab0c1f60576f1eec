#pragma once

#include "studies/published/published.hpp"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <random>
#include <string>

namespace ff::test {

/// The tables of the paper, as installed with the program.
std::filesystem::path paper_tables_file();

/// Tables of the cube as a careful author would print them: "MC", 36 patches x 700 rays with reciprocal completion,
/// from a true simulation of the hits (rays of each patch multinomial with its exact factors), and "DET", a
/// deterministic method with an error of its own; row sums, sums of relative errors, all pairs, relative errors.
/// Everything rounded to six significant digits (DET: six decimals), errors relative to the exact values.
studies::PublishedTables simulate_tables(std::uint64_t seed);

/// The same with other digits: figure `index` prints `printed`.
studies::PublishedTables with_print(studies::PublishedTables tables, std::size_t index, std::string printed);

/// Replaces the digit at `position` of a print by another one, drawn from `random`.
std::string with_other_digit(std::string printed, std::size_t position, std::mt19937_64& random);

}  // namespace ff::test
