#include "studies/theory/sr_distribution.hpp"

#include "core/exact/exact.hpp"
#include "core/geometry/scene.hpp"
#include "core/patches/patch_order.hpp"
#include "core/support/contract.hpp"

#include <algorithm>
#include <cmath>

namespace ff::studies {
namespace {

using Index = Eigen::Index;

/// Sum over the patches of a face of the multinomial covariance of one ray.
Eigen::MatrixXd ray_covariance(const Eigen::MatrixXd& factors) {
    const Eigen::VectorXd totals = factors.colwise().sum();
    return Eigen::MatrixXd(totals.asDiagonal()) - factors.transpose() * factors;
}

}  // namespace

double SrDistribution::pair_sigma(int from, int to) const {
    const Index k = from * mean.cols() + to;
    return std::sqrt(std::max(0.0, pair_covariance(k, k)));
}

double SrDistribution::sum_sigma(int face) const {
    return std::sqrt(std::max(0.0, sum_covariance(face, face)));
}

SrDistribution sr_distribution(const Scene& scene, Subdivision subdivision, const Eigen::MatrixXd& patch_to_face,
                               double rays_per_patch, Completion completion) {
    const Index faces = static_cast<Index>(scene.faces.size());
    FF_EXPECT(rays_per_patch > 0);
    FF_EXPECT(patch_to_face.cols() == faces);
    const PatchOrder order(scene, subdivision);
    FF_EXPECT(patch_to_face.rows() == order.size());

    Eigen::MatrixXd direct = Eigen::MatrixXd::Zero(faces * faces, faces * faces);
    Eigen::MatrixXd mean = Eigen::MatrixXd::Zero(faces, faces);
    for (Index face = 0; face < faces; ++face) {
        const double whole = face_area(scene, static_cast<int>(face));
        for (std::size_t s = 0; s < scene.surfaces.size(); ++s) {
            if (scene.surfaces[s].face != face) continue;
            const Eigen::MatrixXd factors = patch_to_face.middleRows(order.first(s), order.count(s));
            const double patches = order.count(s);
            const double share = area(scene.surfaces[s].shape) / whole;
            mean.row(face) += share * (factors.colwise().sum() / patches);
            direct.block(face * faces, face * faces, faces, faces) +=
                share * share * (ray_covariance(factors) / (rays_per_patch * patches * patches));
        }
    }

    // The linear map from direct estimates to completed ones.
    Eigen::MatrixXd completed = Eigen::MatrixXd::Zero(faces * faces, faces * faces);
    Eigen::MatrixXd sums = Eigen::MatrixXd::Zero(faces, faces * faces);
    for (Index i = 0; i < faces; ++i) {
        for (Index j = 0; j < faces; ++j) {
            if (completion == Completion::direct || i <= j)
                completed(i * faces + j, i * faces + j) = 1;
            else
                completed(i * faces + j, j * faces + i) =
                    face_area(scene, static_cast<int>(j)) / face_area(scene, static_cast<int>(i));
            sums(i, i * faces + j) = 1;
        }
    }
    SrDistribution result;
    result.mean = mean;
    result.pair_covariance = completed * direct * completed.transpose();
    result.sum_covariance = sums * result.pair_covariance * sums.transpose();
    // Closure makes variances of sums vanish; what rounding leaves of them would look like a spread.
    const double noise = 1e-12 * direct.diagonal().maxCoeff();
    for (Index i = 0; i < faces; ++i) {
        if (result.sum_covariance(i, i) > noise) continue;
        result.sum_covariance.row(i).setZero();
        result.sum_covariance.col(i).setZero();
    }
    return result;
}

std::optional<SrDistribution> sr_distribution(const Scene& scene, Subdivision subdivision, double rays_per_patch,
                                              Completion completion) {
    const auto factors = exact_patch_to_face(scene, subdivision);
    if (!factors) return std::nullopt;
    return sr_distribution(scene, subdivision, *factors, rays_per_patch, completion);
}

}  // namespace ff::studies
