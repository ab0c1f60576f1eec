#pragma once

#include "core/geometry/fwd.hpp"

#include <Eigen/Core>

#include <vector>

namespace ff {

template <class Real>
using Vector3 = Eigen::Matrix<Real, 3, 1>;

/// A number and its error: a bound of the quadrature's truncation, plus an estimate of the rounding from the size of
/// the terms that were added.
template <class Real>
struct BoundedValue {
    Real value = 0;
    Real error = 0;
};

/// A directed straight edge.
template <class Real>
struct DirectedEdge {
    Vector3<Real> begin;
    Vector3<Real> end;
};

/// The integral of ln r over the points of two edges, times the cosine of the angle between them, where r is their
/// distance. Edges may touch, cross or overlap. Defined up to a constant times the scalar product of the edges, which
/// drops out of the sum over two closed contours.
///
/// Parallel edges have a closed form. For others the inner integral is elementary, and the outer one, over an analytic
/// function whose singularities are known (off the edge, at most at its distance from the other edge's ends and line),
/// is computed by Gauss's rule on panels that are halved until an ellipse around each is free of singularities; this
/// gives an a priori error bound. @see [sparrow1963], [trefethen2008]
///
/// @pre coordinates are at most 2 in size, in a unit near the pair's extent: errors are absolute
template <class Real>
BoundedValue<Real> log_distance_integral(const DirectedEdge<Real>& a, const DirectedEdge<Real>& b);

/// The integral of ln r + 1 over the points of an edge, where r is their distance from a place: elementary.
double log_distance_integral(const Vector3<double>& place, const DirectedEdge<double>& edge);

/// The corners of a plane polygon, counter-clockwise as seen from the side that it radiates to.
template <class Real>
using Corners = std::vector<Vector3<Real>>;

/// The corners of a surface. @pre a parallelogram or a triangle
template <class Real>
Corners<Real> corners_of(const Surface& surface);

/// Exchange area A_1 F_12 of two plane polygons in any relative position, in squared units of length, by the contour
/// integral: 1 / (2 pi) times the integral of ln r over both rims. Only the parts in front of each other count. Callers
/// have to know that nothing stands in between. They may touch, share edges, and have holes or bays (a rim that runs
/// along a bridge there and back).
///
/// `error` bounds the truncation and estimates the rounding; it is relative to the squared extent of the pair, not to
/// the result: about 1e-15 of it in double, 1e-18 in long double, more where edges are nearly parallel.
/// Neither value nor error is negative.
/// @see [sparrow1963], [schroeder1993]   @pre each polygon is plane, with at least three corners that span an area
template <class Real>
BoundedValue<Real> polygon_exchange_area(Corners<Real> from, Corners<Real> to);

}  // namespace ff
