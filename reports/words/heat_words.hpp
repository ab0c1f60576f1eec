#pragma once

#include "core/geometry/fwd.hpp"
#include "studies/heat/flow_sampling.hpp"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace ff::reports {

/// The results of `ffstudy heat`, with the request.
struct HeatReport {
    const Scene& scene;
    const studies::form_factors::Request& request;
    const std::vector<studies::heat::SolvedCase>& cases;  ///< at least one
    studies::heat::FlowTolerance tolerance{};
    bool trusted = true;  ///< nothing speaks against the scene and its form factors
    const studies::heat::SampledFlows* sampled =
        nullptr;               ///< how they were sampled, if samples were taken where flows depend on them
    bool all_at_once = false;  ///< whether statistical intervals hold at once

    [[nodiscard]] bool is_light() const { return cases.front().materials.are_light(); }
    [[nodiscard]] bool has_cases() const { return cases.size() > 1 || !cases.front().materials.name.empty(); }
};

/// The middle with half the width of the interval. @param is_rounding  the value is 0 up to rounding
std::string with_error(const studies::heat::Bounds& bounds, bool is_rounding = false);

/// The groups that exchange most: "heater gives off 3500 ± 5 W; steel takes up 3500 ± 1 W". Empty where there are
/// several cases, where no group is known to exchange power, and where nothing is to be trusted.
std::string heat_answer(const HeatReport& report);

/// Where the powers of a case go: to the surroundings, or nowhere in a closed scene, whose powers add up to 0.
std::string heat_balance(const HeatReport& report, const studies::heat::SolvedCase& solved);

/// The certainty: "Every power is within ...", or that the tolerance is missed, or that nothing is to be trusted.
std::string heat_verdict(const HeatReport& report);

/// How many samples were taken where flows depend on them; empty where sampling did not depend on flows.
std::string heat_effort(const HeatReport& report);

/// A sentence about faces whose intervals had to be widened; empty where there are none.
std::optional<std::string> widened_rows(const HeatReport& report);

}  // namespace ff::reports
