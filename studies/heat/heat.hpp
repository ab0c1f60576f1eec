#pragma once

#include "core/geometry/scene.hpp"
#include "studies/form_factors/form_factors.hpp"
#include "studies/heat/materials.hpp"

#include <cstddef>
#include <optional>
#include <vector>

namespace ff::studies {

/// W/(m² K⁴), exact in the SI. @see [codata2018]
inline constexpr double stefan_boltzmann = 5.670374419e-8;

/// From `low` to `high` at the level of the form factors, all quantities of a scene at once.
struct Bounds {
    double low = 0;
    double high = 0;

    [[nodiscard]] double middle() const { return low + (high - low) / 2; }
    [[nodiscard]] double half_width() const { return (high - low) / 2; }
};

/// The radiation of one face. Of light: exitance, illuminance and their difference, in the units of the emission.
struct FaceFlow {
    double area = 0;     ///< m²
    Bounds radiosity;    ///< W/m², emitted and reflected
    Bounds irradiation;  ///< W/m²
    Bounds net;          ///< W/m², out of the face: radiosity less irradiation
    Bounds power;        ///< W, net times area
    Bounds temperature;  ///< K; of light 0
    bool given = false;  ///< the temperature was given, and the flux follows; otherwise the reverse
};

struct HeatFlows {
    std::vector<FaceFlow> faces;
    std::optional<Bounds> to_surroundings;  ///< W that leave the scene for good; empty where nothing does
    double throughput = 0;                  ///< W: all that the faces give off, at the middles
    double worst = 0;                       ///< largest half width of a power, as a share of the throughput

    [[nodiscard]] bool within(double tolerance) const { return worst <= tolerance; }
};

/// Solves the radiosity system of grey diffuse faces for all form factors within their intervals
/// (core/radiosity/flow_bounds.hpp). @param matrix with intervals that hold all at once (LevelOf::matrix)
/// @param scale metres of a unit of length of the scene
/// @throws UserError where a face's radiosity is not determined, the surroundings are needed and not given, the rows of
///   a closed scene cannot add up to 1, or a flux leaves a face without a temperature
HeatFlows find_heat_flows(const Scene& scene, const FormFactorMatrix& matrix, const Materials& materials, double scale);

}  // namespace ff::studies
