#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace ff::studies {

/// Names of observables in the store. More can be added without a new schema.
namespace observable {
inline constexpr std::string_view hits = "hits";  ///< rays from a face that hit a face, an integer
inline constexpr std::string_view rays = "rays";  ///< rays shot from a face; to_face is 0
inline constexpr std::string_view lost = "lost";  ///< rays from a face that hit nothing; to_face is 0; absent where 0
inline constexpr std::string_view estimate = "estimate";  ///< a form factor estimated directly, a real number
inline constexpr std::string_view claim = "claim";        ///< the estimator's claimed bound of that estimate's error
inline constexpr std::array all{hits, rays, lost, estimate, claim};
}  // namespace observable

/// One observed value of one trial. Faces count from 1, in the order of the scene; 0 means none.
struct Observation {
    std::string_view observable;
    int from_face = 0;
    int to_face = 0;
    std::uint64_t trial = 0;
    std::variant<std::int64_t, double> value;
};

/// The result of a work unit.
struct UnitRecord {
    std::size_t unit = 0;
    std::vector<Observation> observations;
    std::vector<std::uint64_t> patch_hits;  ///< sum over the unit's trials, [patch * faces + face]; may be empty
    std::vector<std::uint64_t> patch_hits_squared;  ///< sum of squares
    double processor_seconds = 0;                   ///< measured by the process that ran it; not stored
    double processor_seconds_squared = 0;           ///< sum over trials of squared seconds
};

/// The circumstances of a run: host, compiler, dates. Not covered by the promise of repeatability.
using Context = std::map<std::string, std::string>;

/// A record as 64-bit words, for sending to another process of the same program.
std::vector<std::uint64_t> to_words(const UnitRecord& record);

/// The record from which `to_words` made these. @pre they are unchanged (contract)
UnitRecord from_words(std::span<const std::uint64_t> words);

}  // namespace ff::studies
