#pragma once

#include "core/scene.hpp"

#include <Eigen/Core>

#include <optional>

namespace ff {

/// A_1 F_12 of two unoccluded axis-aligned rectangles in parallel or perpendicular planes, anywhere to each other, with
/// or without a common edge or corner; only the parts in front of each other's `normal` side count.
/// Error about 1e-15 of the squared extent of the pair. Empty where no elementary formula applies (not axis-aligned).
/// @see [howell] C-11 to C-15, [ehlert1993]
std::optional<double> exact_exchange_area(const Surface& from, const Surface& to);

/// Exact form factor between two faces of a scene in which nothing stands in between (the caller knows that);
/// empty where a pair of surfaces has no elementary formula.
std::optional<double> exact_form_factor(const Scene& scene, int from_face, int to_face);

/// Exact factors from every patch (rows) to every face (columns) of an unoccluded scene. Empty as above.
std::optional<Eigen::MatrixXd> exact_patch_to_face(const Scene& scene, Subdivision subdivision);

/// Exact face-to-face matrix.
std::optional<Eigen::MatrixXd> exact_form_factors(const Scene& scene);

}  // namespace ff
