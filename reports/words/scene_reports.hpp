#pragma once

#include "core/geometry/scene.hpp"
#include "studies/form_factors/form_factors.hpp"
#include "studies/heat/flow_sampling.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace ff::reports {

/// The results of `ffstudy heat`, with the request.
struct HeatReport {
    const Scene& scene;
    const studies::form_factors::Request& request;
    const studies::heat::Materials& materials;
    const studies::heat::Flows& flows;
    const studies::heat::SampledFlows* sampled =
        nullptr;  ///< how they were sampled, if samples were taken where flows depend on them
};

/// A matrix of form factors with its scene. docs/form-factors.md describes what is written of it.
struct FormFactorReport {
    const Scene& scene;
    const studies::form_factors::Request& request;
    const studies::form_factors::Matrix& matrix;
};

/// Sentences about suspicious findings: row sums of closed scenes that exclude 1, lost rays, contradictions.
std::vector<std::string> form_factor_warnings(const FormFactorReport& report);

/// A sentence about faces whose intervals had to be widened; empty where there are none.
std::optional<std::string> widened_rows(const HeatReport& report);

}  // namespace ff::reports
