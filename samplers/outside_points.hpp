#pragma once

#include "samplers/point_set.hpp"

#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <string>

namespace ff::samplers {

/// The set that code from outside is asked for. It follows from these numbers alone.
struct SetRequest {
    std::uint64_t points = 0;
    std::size_t dimension = 0;
    std::uint64_t seed = 0;   ///< differs with everything that a stream differs by, the trial included
    std::uint32_t trial = 0;  ///< beside it, for those who want it
    auto operator<=>(const SetRequest&) const = default;
};

/// What a stream asks for.
SetRequest request_of(const Stream& stream, std::uint64_t points, std::size_t dimension);

/// "trial 3, seed 123, 1024 points of 4 coordinates", for messages.
std::string in_words(const SetRequest& request);

/// @throws UserError with `origin` where a set would take more memory than can be meant
void expect_whole(const std::string& origin, const SetRequest& request);

/// Fills `block.size` points of a set from `first` on. Called from several threads.
using FillPart = std::function<void(const SetRequest&, PointIndex first, PointBlock& block)>;

/// Makes a set whole: of `request.points` points or more, of as many coordinates or more. Called from several threads.
using MakeSet = std::function<PointSet(const SetRequest&)>;

/// Each thread keeps the set that it was asked for last.
FillPart parts_of(MakeSet make);

std::unique_ptr<PointSource> outside_points(std::uint64_t points, bool randomised, FillPart fill);

/// Numbers in [0, 1), coordinate by coordinate of each point, as a set. @pre rows.size() == points * dimension
/// @throws UserError with `origin`, point and coordinate
PointSet set_of_rows(std::span<const double> rows, std::uint64_t points, std::size_t dimension,
                     const std::string& origin);

}  // namespace ff::samplers
