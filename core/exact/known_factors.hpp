#pragma once

#include "core/geometry/fwd.hpp"

#include <Eigen/Core>

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace ff {

/// Form factors from every face (rows) to every face (columns), where they are known: those of `exact_form_factors`,
/// and those of closed rooms that are
/// - convex, with flat walls of three or four corners, of up to 64 surfaces: by contour integrals
///   (core/formulas/polygon_exchange.hpp);
/// - convex and of revolution;
/// - a sphere from inside with another in it: all that leaves the inner one reaches the outer, the rest follows by
///   reciprocity and closure.
/// They include factors of faces with themselves, whether concave or opposite a mirror.
std::optional<Eigen::MatrixXd> exact_room_factors(const Scene& scene);

/// Why there are no exact factors, for the middle of a message.
std::string why_no_exact_factors(const Scene& scene);

/// The known exact form factors between the faces of a scene: for all pairs, some, or none. Dimensionless.
class KnownFactors {
  public:
    KnownFactors() = default;
    /// All of them, faces from 0.
    explicit KnownFactors(const Eigen::MatrixXd& factors);
    /// None, of so many faces.
    explicit KnownFactors(std::size_t faces) : faces_(faces), factors_(faces * faces) {}

    void set(int from, int to, double factor) { factors_[index(from, to)] = factor; }

    /// Empty where there is none. @pre faces of the scene, from 0
    [[nodiscard]] std::optional<double> at(int from, int to) const { return factors_[index(from, to)]; }
    /// The sum of the factors from a face to all faces; empty unless all of them are known.
    [[nodiscard]] std::optional<double> row_sum(int from) const;

  private:
    [[nodiscard]] std::size_t index(int from, int to) const;

    std::size_t faces_ = 0;
    std::vector<std::optional<double>> factors_;  ///< [from * faces + to]
};

/// Finds factors by formulas of the catalogue (core/configurations/catalogue.hpp) or of the scene
/// (`exact_room_factors`); else, where there are no mirrors, by closed forms (core/exact/exact.hpp) where the surfaces
/// of both faces are rectangles along the axes and nothing may stand between any two of them; of more than 128 surfaces
/// only where that holds for all faces.
KnownFactors known_factors(const Scene& scene);

/// The occluded fraction of a pair: 1 - F / (F without obstacles), 0 to 1. Empty where either factor is unknown, or the
/// unoccluded one is 0.
std::optional<double> hidden_share(const Scene& scene, const KnownFactors& known, int from, int to);

}  // namespace ff
