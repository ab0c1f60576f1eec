#pragma once

#include "core/geometry/fwd.hpp"
#include "core/radiosity/flow_bounds.hpp"
#include "studies/form_factors/form_factors.hpp"
#include "studies/heat/materials.hpp"

#include <Eigen/Core>

#include <cstddef>
#include <utility>
#include <vector>

namespace ff::studies::heat {

/// The irradiation of each face for given factors. @param factors  between faces @param out  what each row leaves for
/// the surroundings @param guess  the irradiation by factors nearly like these, or 0
/// @return not finite where the laws do not determine it
Eigen::VectorXd irradiation_of(const form_factors::Matrix::Sparse& factors, const Eigen::VectorXd& out,
                               const FaceLaws& laws, const Eigen::VectorXd& guess);

/// How flows change with exchange areas, to first order, near the mean factors of a matrix. Rows add up to 1, so that
/// errors only move radiation between faces.
class Sensitivity {
  public:
    /// @param matrix  kept by reference
    Sensitivity(const Scene& scene, const form_factors::Matrix& matrix, const Materials& materials, double scale);

    [[nodiscard]] bool is_known() const { return radiosity_.allFinite(); }
    [[nodiscard]] const Eigen::VectorXd& radiosity() const { return radiosity_; }  ///< W/m²
    [[nodiscard]] const Eigen::VectorXd& absorbing() const { return absorbing_; }  ///< m²
    [[nodiscard]] double throughput() const;
    /// W/m²: largest difference of what faces receive radiation from, the surroundings among them; it drives the flows.
    [[nodiscard]] double largest_difference() const;

    /// W: half widths of all powers. @param half_widths  of exchange areas
    [[nodiscard]] Eigen::VectorXd widths(const std::vector<double>& half_widths) const;

    /// W/m²: half widths of all irradiations. @param bounds  half widths of exchange areas, whose effects add up
    /// @param missed  what points may have missed of others: in each row the largest effect counts, since a share of
    /// points is missed in one place or in another
    [[nodiscard]] Eigen::VectorXd irradiation_widths(const std::vector<double>& bounds,
                                                     const std::vector<double>& missed) const;

    /// How many watts a unit of each pair's half width adds to the sum of the half widths of all powers with these
    /// weights.
    [[nodiscard]] std::vector<double> importance(const Eigen::VectorXd& weights) const;

  private:
    const form_factors::Matrix& matrix_;
    FaceLaws laws_;
    bool sees_out_;
    form_factors::Matrix::Sparse factors_;  ///< rows add up to 1 where nothing leaves the scene
    Eigen::VectorXd radiosity_;
    Eigen::VectorXd areas_;
    Eigen::VectorXd power_;
    Eigen::VectorXd absorbing_;
    /// [pair]: irradiation of `from`, and of `to`, for each unit of error in the exchange area, in W/m² per m².
    std::vector<std::pair<double, double>> contrasts_;

    /// Irradiations whose first incidence is given, before anything is reflected.
    [[nodiscard]] Eigen::VectorXd responses_to(const Eigen::VectorXd& known) const;
    [[nodiscard]] std::pair<Eigen::Index, Eigen::Index> ends(std::size_t p) const;
    [[nodiscard]] Eigen::Index other_end(std::size_t p, std::size_t face) const;
    [[nodiscard]] double median(const std::vector<std::uint32_t>& row, std::size_t face) const;
    void find_contrasts();
};

}  // namespace ff::studies::heat
