#pragma once

#include "core/geometry/fwd.hpp"

namespace ff {

/// What all evaluations of an estimator may have missed: how large its values between two faces (numbered from 0) may
/// be at places that few evaluations meet. These are places where a blocker begins or one face rises above the plane of
/// the other, and peaks: a small surface close to a large one owes all its light to the few points beneath it.

/// A bound of the kernel of points on two faces: area / (pi distance^2) of those of their surfaces that are nearest to
/// each other; infinite where a distance is not shown. That of a part of a sphere to itself is constant: its share of
/// the whole sphere.
double largest_kernel(const Scene& scene, int from, int to);

/// Largest unmet kernel at random pairs of points. 0 where all pairs of surfaces are seen whole and are peaked so
/// little that enough evaluations meet the peak; what touching surfaces hide is a matter of their variance.
double largest_unmet_kernel(const Scene& scene, int from, int to, double evaluations);

/// The same for factors from random points to a whole face, which are at most 1.
double largest_unmet_factor(const Scene& scene, int from, int to, double evaluations);

/// The same for rays and lines, whose values are at most `largest`, and 0 unless they meet both faces.
double largest_unmet_hit(const Scene& scene, int from, int to, double evaluations, double largest);

}  // namespace ff
