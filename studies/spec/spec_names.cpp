#include "studies/spec/spec_names.hpp"

#include "samplers/sampler.hpp"
#include "studies/spec/spec.hpp"

namespace ff::studies {

std::string_view name(Completion completion) {
    return completion_names.at(static_cast<std::size_t>(completion));
}
std::string_view name(Allocation allocation) {
    return allocation_names.at(static_cast<std::size_t>(allocation));
}
std::string_view name(TracerChoice tracer) {
    return tracer_names.at(static_cast<std::size_t>(tracer));
}

std::string_view name(PointMap map) {
    return map_names.at(static_cast<std::size_t>(map));
}

const EstimatorInfo& estimator_info(const Method& method) {
    return find_estimator(method.estimator).info;
}

bool is_randomised(const Method& method) {
    return method.sampler.empty() ? estimator_info(method).randomised : samplers::find(method.sampler).info.randomised;
}

EstimatorOptions estimator_options(const Method& method) {
    return {.allocation = method.allocation, .tracer = method.tracer, .map = method.map};
}

}  // namespace ff::studies
