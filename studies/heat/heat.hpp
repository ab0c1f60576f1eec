#pragma once

#include "core/geometry/fwd.hpp"
#include "core/radiosity/flow_bounds.hpp"
#include "core/support/error.hpp"
#include "studies/form_factors/form_factors.hpp"
#include "studies/heat/materials.hpp"

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace ff::studies::heat {

/// W/(m² K⁴), exact in the SI. @see [codata2018]
inline constexpr double stefan_boltzmann = 5.670374419e-8;

/// How well every power is to be known.
struct FlowTolerance {
    double amount = 1e-3;
    bool is_power = false;  ///< `amount` is in W; otherwise it is a share of what the sources give off

    /// The tolerance in W. @param throughput  what the sources give off
    [[nodiscard]] double power(double throughput) const { return is_power ? amount : amount * throughput; }
};

/// Reads "0.001", "0.1%" or "40W". @param place  for messages, such as "--tolerance" @throws UserError
FlowTolerance read_flow_tolerance(std::string_view place, std::string_view text);

/// The tolerance as text that the reader accepts: "0.1%", "40W".
std::string in_words(const FlowTolerance& tolerance);

/// An interval at the level of the form factors, for all quantities of a scene at once.
struct Bounds {
    double low = 0;
    double high = 0;

    [[nodiscard]] double middle() const { return low + (high - low) / 2; }
    [[nodiscard]] double half_width() const { return (high - low) / 2; }
};

/// How intervals of flows are made.
struct FlowIntervals {
    /// From the spread of the factors' randomisations; otherwise they bound the flows of all factors within their
    /// intervals.
    bool statistical = false;
    double level = 0.95;       ///< of statistical ones
    bool all_at_once = false;  ///< whether the level is that of all statistical intervals of a case
};

/// The radiation of one face. For light: exitance, illuminance and their difference, in the units of the emission.
struct FaceFlow {
    double area = 0;     ///< m²
    Bounds radiosity;    ///< W/m², emitted and reflected
    Bounds irradiation;  ///< W/m²
    Bounds net;          ///< W/m², out of the face: radiosity minus irradiation
    Bounds power;        ///< W, net times area
    Bounds temperature;  ///< K; 0 for light
};

/// The radiation of several faces together. Their extremes are met at once, so that sums of their limits are as narrow
/// as any that hold for all form factors within their intervals.
struct GroupFlow {
    std::string name;
    std::size_t faces = 0;
    double area = 0;              ///< m²
    Bounds power;                 ///< W
    std::optional<Bounds> share;  ///< of all that the sources give off; empty where that may be 0

    /// W/m², the mean over the area.
    [[nodiscard]] Bounds net() const { return {power.low / area, power.high / area}; }
};

struct Flows {
    std::vector<FaceFlow> faces;
    std::vector<GroupFlow> groups;     ///< as in the materials
    Bounds balance;                    ///< W: all powers together
    bool reaches_outside = false;      ///< what the balance leaves is for the surroundings; otherwise it is 0
    double throughput = 0;             ///< W: all that the faces give off, at the middles
    double emitted = 0;                ///< W: what they emit, before any of it is reflected or comes back
    double exchanged = 0;              ///< W: what leaves them at most, emitted and reflected
    double worst = 0;                  ///< W: largest half width of a power
    bool statistical = false;          ///< the kind of their intervals
    std::vector<std::size_t> widened;  ///< faces whose factors could add up to 1 in wider intervals only

    /// Nothing is exchanged, up to rounding, as between faces of one temperature: no power is shown to differ from 0,
    /// and none can do so by more than a billionth of what leaves the faces.
    [[nodiscard]] bool are_at_rest() const;
    [[nodiscard]] bool within(const FlowTolerance& tolerance) const {
        return worst <= tolerance.power(throughput) || are_at_rest();
    }
};

/// The form factors do not tell the flows, which is no fault of the input.
class InconclusiveFlows : public UserError {
    using UserError::UserError;
};

/// The factors of a face of a closed scene cannot add up to 1, by more than chance explains.
class ImpossibleRow : public InconclusiveFlows {
    using InconclusiveFlows::InconclusiveFlows;
};

/// It depends on factors whose intervals begin at 0 whether a face reaches one with a temperature.
class UnresolvedFlows : public InconclusiveFlows {
    using InconclusiveFlows::InconclusiveFlows;
};

/// One case of a materials file.
struct SolvedCase {
    Materials materials;
    Flows flows;
};

/// How radiosities follow from irradiations, in W/m².
FaceLaws laws_of(const Materials& materials);

/// Solves the radiosity system of grey diffuse faces for all form factors within their intervals
/// (core/radiosity/flow_bounds.hpp). Where the sampled factors of a face cannot add up to 1, as may happen in a share
/// 1 - level of all runs, their intervals are widened to what has a probability of 1e-6.
/// @param matrix with intervals that hold all at once (LevelOf::matrix)
/// @param scale metres per unit of length of the scene
/// @throws ImpossibleRow
/// @throws UserError where a face's radiosity is not determined, the surroundings are needed and not given, or a flux
///   leaves a face without a temperature
Flows find_flows(const Scene& scene, const form_factors::Matrix& matrix, const Materials& materials, double scale,
                 const FlowIntervals& intervals = {});

/// Looks for missing surroundings before factors are computed, for which large scenes take minutes.
/// @throws UserError where more than half of the rays from a surface leave the scene, and a case does not say to what
void expect_surroundings(const Scene& scene, const std::vector<Materials>& cases);

/// The flows of all cases, from the same form factors. @throws UserError as find_flows, which names the case
std::vector<SolvedCase> solve_cases(const Scene& scene, const form_factors::Matrix& matrix,
                                    std::vector<Materials> cases, double scale, const FlowIntervals& intervals = {});

/// Where the emission of a face is finally absorbed.
struct GebhartFactor {
    std::size_t from = 0;
    std::size_t to = 0;  ///< the number of faces stands for the surroundings
    Bounds gebhart;      ///< share of the emission of `from` that `to` absorbs, on any path
    Bounds script_f;     ///< the Gebhart factor times the emissivity of `from`
};

/// All Gebhart factors, row by row, with limits that hold for all form factors within their intervals. A face's
/// absorptance is its emissivity, whether a temperature or a flux is given; for light it is 1 - reflectance. One pair
/// of solutions for each face. @throws UserError as find_flows @see [howell]
std::vector<GebhartFactor> find_gebhart_factors(const Scene& scene, const form_factors::Matrix& matrix,
                                                const Materials& materials);

}  // namespace ff::studies::heat
