#include "studies/spec/spec_names.hpp"

#include "studies/spec/spec.hpp"

namespace ff::studies {

std::string_view name(Estimator estimator) {
    return estimator_names.at(static_cast<std::size_t>(estimator));
}
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

std::size_t dimension(Estimator estimator) {
    switch (estimator) {
        case Estimator::ray_shooting:
        case Estimator::area_kernel:
            return 4;
        case Estimator::point_to_polygon:
            return 2;
        case Estimator::closed_form:
            break;
    }
    return 0;
}

bool has_allocation(Estimator estimator) {
    return estimator == Estimator::ray_shooting || estimator == Estimator::point_to_polygon;
}

}  // namespace ff::studies
