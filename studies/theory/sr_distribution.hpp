#pragma once

#include "core/geometry/subdivision.hpp"
#include "studies/spec/spec.hpp"

#include <Eigen/Core>

#include <optional>

namespace ff::studies {

/// Mean and covariance of one trial of ray shooting with independent rays, exactly: not from a simulation, and not the
/// binomial F(1-F)/N either, because a fixed number of rays per patch makes the tallies stratified.
struct SrDistribution {
    Eigen::MatrixXd mean;             ///< exact factors, [from, to]
    Eigen::MatrixXd pair_covariance;  ///< between F(i,j) and F(k,l): [i * faces + j, k * faces + l]
    Eigen::MatrixXd sum_covariance;   ///< between the sums of rows i and k

    /// Standard deviation of the estimate of F(from, to).
    [[nodiscard]] double pair_sigma(int from, int to) const;
    /// Standard deviation of the sum of row `face`; exactly 0 where closure fixes it.
    [[nodiscard]] double sum_sigma(int face) const;
};

/// Direct estimates with n rays from each patch have Cov(F_ij, F_ik) = sum over the patches p of face i of
/// a_p^2 (delta_jk F_pj - F_pj F_pk) / n, a_p the patch's share of the area of its face, and rows are independent. With
/// `Completion::reciprocal` row entries below the diagonal follow from those above it.
/// @param patch_to_face  exact factors from every patch (rows, in the order of PatchOrder) to every face
/// @param rays_per_patch  may be fractional where only the total is known
SrDistribution sr_distribution(const Scene& scene, Subdivision subdivision, const Eigen::MatrixXd& patch_to_face,
                               double rays_per_patch, Completion completion);

/// The same from the scene's exact factors; empty where these have no elementary formula (core/exact/exact.hpp).
/// @pre nothing stands between the faces
std::optional<SrDistribution> sr_distribution(const Scene& scene, Subdivision subdivision, double rays_per_patch,
                                              Completion completion);

}  // namespace ff::studies
