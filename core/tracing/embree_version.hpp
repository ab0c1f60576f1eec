#pragma once

/// Embree with handles that release themselves, and under one name what Embree 3 and Embree 4 call differently. CMake
/// says which of them was found. This header is not installed: users of the library do not need Embree's headers.

#if FF_EMBREE_MAJOR >= 4
#include <embree4/rtcore.h>
#else
#include <embree3/rtcore.h>
#endif

#include <memory>
#include <type_traits>

namespace ff::embree {

template <auto release>
struct Releaser {
    void operator()(auto* handle) const { release(handle); }
};
using Device = std::unique_ptr<std::remove_pointer_t<RTCDevice>, Releaser<rtcReleaseDevice>>;
using SceneHandle = std::unique_ptr<std::remove_pointer_t<RTCScene>, Releaser<rtcReleaseScene>>;
using GeometryHandle = std::unique_ptr<std::remove_pointer_t<RTCGeometry>, Releaser<rtcReleaseGeometry>>;

#if FF_EMBREE_MAJOR >= 4

using QueryContext = RTCRayQueryContext;

inline void init(QueryContext& context) {
    rtcInitRayQueryContext(&context);
}

inline RTCIntersectArguments arguments(QueryContext& context) {
    RTCIntersectArguments arguments{};
    rtcInitIntersectArguments(&arguments);
    arguments.context = &context;
    return arguments;
}

inline void intersect1(RTCScene scene, QueryContext& context, RTCRayHit& ray) {
    RTCIntersectArguments with = arguments(context);
    rtcIntersect1(scene, &ray, &with);
}

/// @param valid  -1 for each ray of the packet that is traced, 0 for the others; aligned to 32 bytes
inline void intersect8(const int* valid, RTCScene scene, QueryContext& context, RTCRayHit8& rays) {
    RTCIntersectArguments with = arguments(context);
    rtcIntersect8(valid, scene, &rays, &with);
}

#else

using QueryContext = RTCIntersectContext;

inline void init(QueryContext& context) {
    rtcInitIntersectContext(&context);
}

inline void intersect1(RTCScene scene, QueryContext& context, RTCRayHit& ray) {
    rtcIntersect1(scene, &context, &ray);
}

/// @param valid  -1 for each ray of the packet that is traced, 0 for the others; aligned to 32 bytes
inline void intersect8(const int* valid, RTCScene scene, QueryContext& context, RTCRayHit8& rays) {
    rtcIntersect8(valid, scene, &context, &rays);
}

#endif

}  // namespace ff::embree
