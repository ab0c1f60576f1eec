#pragma once

#include "studies/heat/flow_sampling.hpp"

namespace ff::reports {

/// The results of `ffstudy heat`, with the request.
struct HeatReport {
    const Scene& scene;
    const studies::FormFactorRequest& request;
    const studies::Materials& materials;
    const studies::HeatFlows& flows;
    const studies::SampledFlows* sampled = nullptr;  ///< how they were, if samples went where flows depend on them
};

}  // namespace ff::reports
