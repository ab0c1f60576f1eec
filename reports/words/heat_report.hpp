#pragma once

#include "studies/heat/heat.hpp"

namespace ff::reports {

/// What `ffstudy heat` has found, with what it was asked.
struct HeatReport {
    const Scene& scene;
    const studies::FormFactorRequest& request;
    const studies::Materials& materials;
    const studies::HeatFlows& flows;
};

}  // namespace ff::reports
