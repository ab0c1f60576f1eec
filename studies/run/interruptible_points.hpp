#pragma once

#include "core/points/points.hpp"

#include <atomic>
#include <memory>

namespace ff::studies {

/// Thrown out of a trial that is not wanted any more; what it had counted is lost.
struct Interrupted {};

/// The same points, but once `stop` is true every request for more of them throws `Interrupted`: one trial can take
/// hours, and no estimator has to know. @param stop  outlives the result
std::unique_ptr<PointSource> interruptible(std::unique_ptr<PointSource> points, const std::atomic<bool>& stop);

}  // namespace ff::studies
