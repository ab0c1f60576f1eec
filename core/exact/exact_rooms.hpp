#pragma once

#include "core/geometry/scene.hpp"

#include <Eigen/Core>

#include <optional>
#include <string>

namespace ff {

/// Form factors from every face (rows) to every face (columns), where they are known: those of `exact_form_factors`,
/// and those of closed rooms that are
/// - convex, with flat walls of three or four corners: by contour integrals (core/formulas/polygon_exchange.hpp), of up
/// to 64
///   surfaces;
/// - convex and of revolution;
/// - a sphere from inside with another in it: all that leaves the inner one reaches the outer, the rest follows
///   by reciprocity and closure. They include factors of faces with themselves, whether concave or opposite a
///   mirror.
std::optional<Eigen::MatrixXd> exact_room_factors(const Scene& scene);

/// Why there are no exact factors, for the middle of a message.
std::string why_no_exact_factors(const Scene& scene);

}  // namespace ff
