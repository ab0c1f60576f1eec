#pragma once

#include <Eigen/Core>
#include <Eigen/SparseCore>

namespace ff {

/// Form factors that are known up to intervals. Column n is what lies around an open scene, or a surface that belongs
/// to no face; each row of the true factors adds up to 1. Entries that are not listed are exactly 0.
struct FactorBounds {
    using Sparse = Eigen::SparseMatrix<double, Eigen::RowMajor>;
    Sparse low;   ///< n x (n + 1), >= 0, compressed
    Sparse high;  ///< the same entries, >= low
};

/// How the radiosity of each face follows from its irradiation H: emitted + reflected * H (power per area, any unit).
struct FaceLaws {
    Eigen::VectorXd emitted;
    Eigen::VectorXd reflected;  ///< reflectance, in [0, 1]
    double surroundings = 0;    ///< radiosity of what lies around
};

/// Limits of the irradiation of each face for all form factors within their intervals.
struct IrradiationBounds {
    Eigen::VectorXd low;
    Eigen::VectorXd high;
};

/// Whether power can be trapped: by a face that reflects everything and reaches no face that absorbs.
enum class Absorption {
    reached,      ///< every face reaches one that absorbs, whatever the factors
    unresolved,   ///< not certain: some intervals begin at 0
    not_reached,  ///< some face reaches none: its radiosity is not determined
};

struct AbsorptionFound {
    Absorption absorption = Absorption::reached;
    Eigen::Index face = 0;  ///< the first face with that status
};

AbsorptionFound find_absorption(const FactorBounds& factors, const FaceLaws& laws);

/// Whether a row of these intervals can add up to 1.
bool can_add_up(const FactorBounds& factors, Eigen::Index row);

/// Limits for many laws with the same reflectances.
class FlowBounds {
  public:
    /// @param factors kept by reference @pre find_absorption is `reached`, and every row can add up
    FlowBounds(const FactorBounds& factors, Eigen::VectorXd reflected);

    /// The extremes are attained, up to rounding, by factors within their intervals whose rows add up to 1, so nothing
    /// narrower holds for all of these. (Reciprocity is not used.) The largest irradiations are found row by row as in
    /// a Markov decision process: each row sends as much as its intervals allow to the faces of the largest radiosity;
    /// the radiosities of this choice are solved for, and the choice is made again until they no longer grow. The
    /// solver's remaining error is bounded and added: the limits hold whether or not it converged. @see [howard1960]
    [[nodiscard]] IrradiationBounds irradiation(const Eigen::VectorXd& emitted, double surroundings) const;

  private:
    const FactorBounds& factors_;
    Eigen::VectorXd reflected_;
    Eigen::VectorXd spread_;  ///< upper bound of each irradiation's error for a residual of 1 in every row
};

IrradiationBounds bound_irradiation(const FactorBounds& factors, const FaceLaws& laws);

}  // namespace ff
