#pragma once

#include "studies/heat/flow_sampling.hpp"

namespace ff::reports {

/// The results of `ffstudy heat`, with the request.
struct HeatReport {
    const Scene& scene;
    const studies::form_factors::Request& request;
    const studies::heat::Materials& materials;
    const studies::heat::Flows& flows;
    const studies::heat::SampledFlows* sampled =
        nullptr;  ///< how they were, if samples went where flows depend on them
};

}  // namespace ff::reports
