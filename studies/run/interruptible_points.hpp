#pragma once

#include "core/points/points.hpp"

#include <atomic>
#include <memory>

namespace ff::studies {

/// Thrown out of a trial that is no longer wanted; its counts are lost.
struct Interrupted {};

/// The same points, but once `stop` is true every further request throws `Interrupted`: a trial can take hours, and
/// estimators need not know about stopping. @param stop outlives the result
std::unique_ptr<PointSource> interruptible(std::unique_ptr<PointSource> points, const std::atomic<bool>& stop);

}  // namespace ff::studies
