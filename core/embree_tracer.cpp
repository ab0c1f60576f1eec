// The only file that knows Embree.

#include "core/contract.hpp"
#include "core/rays.hpp"
#include "core/tracer.hpp"

#include <embree3/rtcore.h>

#include <algorithm>
#include <array>
#include <limits>
#include <memory>
#include <stdexcept>
#include <string>
#include <type_traits>

namespace ff {
namespace {

/// Rays in a packet: 8 was as fast as 4, 16 and streams within noise, and later major versions still have it.
constexpr std::size_t packet = 8;

/// With at most this many surfaces each has its own bit of the ray mask; with more, a filter excludes the source.
constexpr std::size_t mask_bits = 32;

template <auto release>
struct Releaser {
    template <class Handle>
    void operator()(Handle* handle) const {
        release(handle);
    }
};
using Device = std::unique_ptr<std::remove_pointer_t<RTCDevice>, Releaser<rtcReleaseDevice>>;
using SceneHandle = std::unique_ptr<std::remove_pointer_t<RTCScene>, Releaser<rtcReleaseScene>>;
using Geometry = std::unique_ptr<std::remove_pointer_t<RTCGeometry>, Releaser<rtcReleaseGeometry>>;

void require_no_error(const Device& device, const char* what) {
    const RTCError error = rtcGetDeviceError(device.get());
    if (error != RTC_ERROR_NONE) {
        throw std::runtime_error(std::string("Embree: ") + what + " failed with error " +
                                 std::to_string(static_cast<int>(error)));
    }
}

/// Embree's context with the surface that rays start on behind it, where the filter finds it.
struct Context {
    RTCIntersectContext embree;
    std::uint32_t source;
};
static_assert(std::is_standard_layout_v<Context>, "the filter gets a pointer to the first member");

void reject_source(const RTCFilterFunctionNArguments* arguments) {
    const auto* context = reinterpret_cast<const Context*>(arguments->context);
    for (unsigned i = 0; i < arguments->N; ++i) {
        if (RTCHitN_geomID(arguments->hit, arguments->N, i) == context->source) arguments->valid[i] = 0;
    }
}

/// Components of consecutive rays, wherever they are stored.
struct RayPointers {
    const float *origin_x, *origin_y, *origin_z;
    const float *direction_x, *direction_y, *direction_z;
};

class EmbreeTracer final : public Tracer {
  public:
    explicit EmbreeTracer(const Scene& scene);

    [[nodiscard]] std::string_view name() const override { return "embree"; }
    void shoot(std::uint32_t source, Subdivision subdivision, std::uint32_t patch, const PointBlock& block,
               std::span<std::uint64_t> hits) const override;
    void trace(const RayBatch& rays, std::span<Hit> hits) const override;

  private:
    void attach(const Surface& surface, std::uint32_t index);

    /// Calls visit(ray, surface or no_surface, u, v) for every ray in order.
    template <class Visit>
    void intersect(const RayPointers& rays, std::size_t count, std::uint32_t source, Visit visit) const;

    Device device_;
    SceneHandle scene_;
    bool by_mask_ = false;
    std::vector<SurfaceFrame> frames_;
    std::vector<std::size_t> face_of_;
    std::size_t faces_ = 0;
};

EmbreeTracer::EmbreeTracer(const Scene& scene) : device_(rtcNewDevice("threads=1")), faces_(scene.faces.size()) {
    if (!device_) throw std::runtime_error("Embree: no device");
    by_mask_ = scene.surfaces.size() <= mask_bits &&
               rtcGetDeviceProperty(device_.get(), RTC_DEVICE_PROPERTY_RAY_MASK_SUPPORTED) != 0;
    if (!by_mask_ && rtcGetDeviceProperty(device_.get(), RTC_DEVICE_PROPERTY_FILTER_FUNCTION_SUPPORTED) == 0) {
        throw std::runtime_error("Embree: built without ray masks and filter functions; one of them is needed");
    }
    scene_.reset(rtcNewScene(device_.get()));
    rtcSetSceneFlags(scene_.get(), RTC_SCENE_FLAG_ROBUST);
    rtcSetSceneBuildQuality(scene_.get(), RTC_BUILD_QUALITY_HIGH);
    for (const Surface& surface : scene.surfaces) {
        attach(surface, static_cast<std::uint32_t>(frames_.size()));
        frames_.push_back(surface_frame(surface));
        face_of_.push_back(static_cast<std::size_t>(surface.face));
    }
    rtcCommitScene(scene_.get());
    require_no_error(device_, "building the scene");
}

/// One quad is one geometry, so that geometry number and surface index are the same.
void EmbreeTracer::attach(const Surface& surface, std::uint32_t index) {
    const Geometry geometry(rtcNewGeometry(device_.get(), RTC_GEOMETRY_TYPE_QUAD));
    auto* vertices = static_cast<float*>(
        rtcSetNewGeometryBuffer(geometry.get(), RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, 3 * sizeof(float), 4));
    auto* indices = static_cast<unsigned*>(
        rtcSetNewGeometryBuffer(geometry.get(), RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT4, 4 * sizeof(unsigned), 1));
    require_no_error(device_, "allocating a surface");
    const auto& [corner, edge_u, edge_v] = surface.shape;
    // In this order Embree's u and v are our s and t.
    const std::array<Eigen::Vector3d, 4> corners{corner, corner + edge_u, corner + edge_u + edge_v, corner + edge_v};
    for (unsigned i = 0; i < 4; ++i) {
        for (unsigned axis = 0; axis < 3; ++axis) vertices[3 * i + axis] = static_cast<float>(corners[i][axis]);
        indices[i] = i;
    }
    if (by_mask_) {
        rtcSetGeometryMask(geometry.get(), 1u << index);
    } else {
        rtcSetGeometryIntersectFilterFunction(geometry.get(), reject_source);
    }
    rtcCommitGeometry(geometry.get());
    rtcAttachGeometryByID(scene_.get(), geometry.get(), index);
}

template <class Visit>
void EmbreeTracer::intersect(const RayPointers& rays, std::size_t count, std::uint32_t source, Visit visit) const {
    Context context{};
    rtcInitIntersectContext(&context.embree);
    context.source = source;
    alignas(32) std::array<int, packet> valid{};
    valid.fill(-1);
    RTCRayHit8 p{};  // tnear is 0 and stays so
    std::fill_n(p.ray.mask, packet, by_mask_ ? ~(1u << source) : ~0u);
    for (std::size_t first = 0; first < count; first += packet) {
        const std::size_t n = std::min(packet, count - first);
        const auto load = [first, n](const float* from, float* to) {
            // A copy of known length is two instructions, one of unknown length is a call.
            n == packet ? std::copy_n(from + first, packet, to) : std::copy_n(from + first, n, to);
        };
        load(rays.origin_x, p.ray.org_x);
        load(rays.origin_y, p.ray.org_y);
        load(rays.origin_z, p.ray.org_z);
        load(rays.direction_x, p.ray.dir_x);
        load(rays.direction_y, p.ray.dir_y);
        load(rays.direction_z, p.ray.dir_z);
        std::fill_n(p.ray.tfar, packet, std::numeric_limits<float>::infinity());
        std::fill_n(p.hit.geomID, packet, RTC_INVALID_GEOMETRY_ID);
        if (n < packet) std::fill(valid.begin() + n, valid.end(), 0);
        rtcIntersect8(valid.data(), scene_.get(), &context.embree, &p);
        for (std::size_t i = 0; i < n; ++i) visit(first + i, p.hit.geomID[i], p.hit.u[i], p.hit.v[i]);
    }
}

void EmbreeTracer::shoot(std::uint32_t source, Subdivision subdivision, std::uint32_t patch, const PointBlock& block,
                         std::span<std::uint64_t> hits) const {
    FF_EXPECT(hits.size() == faces_ + 1);
    RayBlock rays;
    generate_ray_block(frames_.at(source), patch_map(subdivision, patch), block, rays);
    const RayPointers pointers{rays.origin_x.data(),    rays.origin_y.data(),    rays.origin_z.data(),
                               rays.direction_x.data(), rays.direction_y.data(), rays.direction_z.data()};
    intersect(pointers, block.size, source, [&](std::size_t, std::uint32_t surface, float, float) {
        ++hits[surface == no_surface ? faces_ : face_of_[surface]];
    });
}

void EmbreeTracer::trace(const RayBatch& rays, std::span<Hit> hits) const {
    FF_EXPECT(hits.size() >= rays.size());
    const RayPointers pointers{rays.origin_x.data(),    rays.origin_y.data(),    rays.origin_z.data(),
                               rays.direction_x.data(), rays.direction_y.data(), rays.direction_z.data()};
    static_assert(RTC_INVALID_GEOMETRY_ID == no_surface);
    intersect(pointers, rays.size(), rays.source, [hits](std::size_t i, std::uint32_t surface, float u, float v) {
        hits[i] = surface == no_surface ? Hit{} : Hit{surface, std::clamp(u, 0.0f, 1.0f), std::clamp(v, 0.0f, 1.0f)};
    });
}

}  // namespace

std::unique_ptr<Tracer> make_embree_tracer(const Scene& scene) {
    return std::make_unique<EmbreeTracer>(scene);
}

}  // namespace ff
