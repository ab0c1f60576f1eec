#pragma once

#include "samplers/point_sets/point_set.hpp"

#include <cstdint>
#include <functional>
#include <memory>
#include <string>

namespace ff::samplers {

/// The point set requested from outside code. It depends on these numbers alone.
struct SetRequest {
    std::uint64_t points = 0;
    std::size_t dimension = 0;
    std::uint64_t seed = 0;   ///< different for every stream, hence for every trial
    std::uint32_t trial = 0;  ///< for code that prefers a trial number
    auto operator<=>(const SetRequest&) const = default;
};

/// The request of a stream.
SetRequest request_of(const Stream& stream, std::uint64_t points, std::size_t dimension);

/// "trial 3, seed 123, 1024 points of 4 coordinates", for messages.
std::string in_words(const SetRequest& request);

/// @throws UserError with `origin` where a set would take an implausible amount of memory
void expect_whole(const std::string& origin, const SetRequest& request);

/// Fills `block.size` points of a set from `first` on. Called from several threads.
using FillPart = std::function<void(const SetRequest&, PointIndex first, PointBlock& block)>;

/// Makes a complete set with at least the requested numbers of points and coordinates. Called from several threads,
/// with a set made before, or an empty one, whose memory can be used again.
using MakeSet = std::function<void(const SetRequest&, PointSet& set)>;

/// Each thread keeps the most recent set.
FillPart parts_of(MakeSet make);

std::unique_ptr<PointSource> outside_points(std::uint64_t points, bool randomised, FillPart fill);

}  // namespace ff::samplers
