#pragma once

#include <Eigen/Core>

namespace ff {

/// Form factors that are known up to intervals. Column n is what lies around an open scene, or a surface that belongs
/// to no face; each row of the true factors adds up to 1.
struct FactorBounds {
    Eigen::MatrixXd low;   ///< n x (n + 1), >= 0
    Eigen::MatrixXd high;  ///< the same, >= low
};

/// How the radiosity of each face follows from its irradiation H: emitted + reflected * H (power per area, any unit).
struct FaceLaws {
    Eigen::VectorXd emitted;
    Eigen::VectorXd reflected;  ///< in [0, 1]
    double surroundings = 0;    ///< radiosity of what lies around
};

/// Where the irradiation of each face lies, whatever factors within their intervals are the true ones.
struct IrradiationBounds {
    Eigen::VectorXd low;
    Eigen::VectorXd high;
};

/// A face that no power can leave for good: it reflects everything, and reaches no face that absorbs.
enum class Absorption {
    reached,      ///< by every face, whatever the factors
    unresolved,   ///< not for certain: some intervals begin at 0
    not_reached,  ///< by some face: its radiosity is not determined
};

struct AbsorptionFound {
    Absorption absorption = Absorption::reached;
    Eigen::Index face = 0;  ///< the first for which it is so
};

AbsorptionFound find_absorption(const FactorBounds& factors, const FaceLaws& laws);

/// Whether a row of these intervals can add up to 1.
bool can_add_up(const FactorBounds& factors, Eigen::Index row);

/// The extremes are attained by factors within their intervals whose rows add up to 1, so nothing narrower holds for
/// all of these. (Reciprocity is not used.) The largest irradiations are found row by row as in a Markov decision
/// process: each row sends as much as its intervals allow to the faces of the largest radiosity; the radiosities of
/// this choice are solved for, and the choice is made again until they no longer grow. @see [howard1960]
/// @pre find_absorption is `reached`, and every row can add up
IrradiationBounds bound_irradiation(const FactorBounds& factors, const FaceLaws& laws);

}  // namespace ff
