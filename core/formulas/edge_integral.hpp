#pragma once

#include <Eigen/Core>

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

}  // namespace ff
