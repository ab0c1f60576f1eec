#pragma once

#include "studies/audit/scene_facts.hpp"
#include "studies/published/published.hpp"

#include <cstdint>
#include <random>
#include <string>
#include <vector>

namespace ff::test {

/// Tables of shot rays as a careful author would print them, in any of the usual ways.
struct SoundHits {
    std::string scene;  ///< its name, or text of a scene file as JSON holds it
    bool reciprocal = false;
    bool truncated = false;
    bool stated = true;  ///< whether the file says which
    int decimals = 4;
    std::int64_t rays = 1000;
    bool sums = true;
};

/// Draws one of these at random. @param scenes  to choose from
SoundHits any_hits(const std::vector<std::string>& scenes, std::mt19937_64& random);

/// Hits of every face multinomial with its true factors, and all prints from exact fractions.
/// @param facts  of the scene; its areas in whole ten-thousandths
studies::PublishedTables shoot_tables(const SoundHits& hits, const studies::audit::SceneFacts& facts,
                                      std::mt19937_64& random);

}  // namespace ff::test
