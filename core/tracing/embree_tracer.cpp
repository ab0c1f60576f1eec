// The only file that knows Embree, by core/tracing/embree_version.hpp.

#include "core/geometry/line_meets.hpp"
#include "core/geometry/surface_map.hpp"
#include "core/support/contract.hpp"
#include "core/support/error.hpp"
#include "core/tracing/embree_version.hpp"
#include "core/tracing/rays.hpp"
#include "core/tracing/tracer.hpp"
#include "core/visibility/mirrors.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <memory>
#include <mutex>
#include <type_traits>

namespace ff {
namespace {

/// Rays in a packet: 8 was as fast as 4, 16 and streams within noise, and later major versions still have it.
constexpr std::size_t packet = 8;

/// With at most this many surfaces each is a geometry with a bit of the ray mask; with more, surfaces of a kind share a
/// geometry, and a filter excludes the source.
constexpr std::size_t mask_bits = 32;

/// Origins, corners and meetings may be off by this share of a scene's largest coordinate because of rounding alone.
constexpr double place_rounding = 0x1p-21;

void require_no_error(const embree::Device& device, const char* what) {
    if (const RTCError error = rtcGetDeviceError(device.get()); error != RTC_ERROR_NONE)
        throw UserError("Embree: {} failed with error {}. Allow more memory.", what, int{error});
}

enum class Kind { quads, triangles, round };

Kind kind_of(const Surface& surface) {
    if (std::holds_alternative<Parallelogram>(surface.shape)) return Kind::quads;
    return std::holds_alternative<Triangle>(surface.shape) ? Kind::triangles : Kind::round;
}

/// Surfaces of one kind that share a geometry; primitive i is surfaces[i].
struct Group {
    const std::vector<Surface>* scene = nullptr;
    Kind kind = Kind::quads;
    std::vector<std::uint32_t> surfaces;

    [[nodiscard]] const Surface& surface(unsigned primitive) const { return (*scene)[surfaces[primitive]]; }
};

/// Embree's context and what the callbacks need of a ray.
struct Context {
    embree::QueryContext query;
    std::uint32_t source;
    double rim;
};
static_assert(std::is_standard_layout_v<Context>, "callbacks get a pointer to the first member");

const Context& context_of(const embree::QueryContext* context) {
    return *reinterpret_cast<const Context*>(context);
}

void reject_source(const RTCFilterFunctionNArguments* arguments) {
    const auto& group = *static_cast<const Group*>(arguments->geometryUserPtr);
    const std::uint32_t source = context_of(arguments->context).source;
    for (unsigned i = 0; i < arguments->N; ++i) {
        const unsigned primitive = RTCHitN_primID(arguments->hit, arguments->N, i);
        if (arguments->valid[i] != 0 && group.surfaces[primitive] == source) arguments->valid[i] = 0;
    }
}

/// Bounds in single precision that contain those in double precision.
void bound(const RTCBoundsFunctionArguments* arguments) {
    const auto& group = *static_cast<const Group*>(arguments->geometryUserPtr);
    float* const low = &arguments->bounds_o->lower_x;
    float* const high = &arguments->bounds_o->upper_x;
    for (Eigen::Index axis = 0; axis < 3; ++axis) {
        const Extent along = extent(group.surface(arguments->primID), Eigen::Vector3d::Unit(axis));
        const double room = 4 * second_attempt * (std::abs(along.low) + std::abs(along.high));
        low[axis] = static_cast<float>(along.low - room);
        high[axis] = static_cast<float>(along.high + room);
    }
}

/// Stands in place of the hit coordinate u, which core/geometry/surface_map finds for round shapes.
constexpr float meets_outward = 1;

void intersect_round(const RTCIntersectFunctionNArguments* arguments) {
    const auto& group = *static_cast<const Group*>(arguments->geometryUserPtr);
    const std::uint32_t index = group.surfaces[arguments->primID];
    const Surface& surface = group.surface(arguments->primID);
    const Context& context = context_of(arguments->context);
    const bool begins = index == context.source && begins_on(surface, context.rim);
    const unsigned n = arguments->N;
    RTCRayN* const rays = RTCRayHitN_RayN(arguments->rayhit, n);
    RTCHitN* const hits = RTCRayHitN_HitN(arguments->rayhit, n);
    for (unsigned i = 0; i < n; ++i) {
        if (arguments->valid[i] == 0) continue;
        const Line line{{RTCRayN_org_x(rays, n, i), RTCRayN_org_y(rays, n, i), RTCRayN_org_z(rays, n, i)},
                        {RTCRayN_dir_x(rays, n, i), RTCRayN_dir_y(rays, n, i), RTCRayN_dir_z(rays, n, i)}};
        const auto meeting = line_meets(line, surface, {.begins = begins}, context.rim);
        if (!meeting || meeting->time > static_cast<double>(RTCRayN_tfar(rays, n, i))) continue;
        RTCRayN_tfar(rays, n, i) = static_cast<float>(meeting->time);
        RTCHitN_u(hits, n, i) = meeting->outward ? meets_outward : 0;
        RTCHitN_geomID(hits, n, i) = arguments->geomID;
        RTCHitN_primID(hits, n, i) = arguments->primID;
    }
}

/// A hit that Embree found.
struct EmbreeHit {
    std::uint32_t surface = no_surface;
    float time = 0;
    float u = 0;
    float v = 0;
    bool from_behind = false;
};

class EmbreeTracer final : public Tracer {
  public:
    explicit EmbreeTracer(const Scene& scene);
    [[nodiscard]] std::string_view name() const override { return "embree"; }
    void shoot(std::uint32_t source, Grid grid, std::uint32_t patch, const PointBlock& block,
               std::span<std::uint64_t> hits) const override;
    void trace(const RayBatch& rays, std::span<Hit> hits) const override;

  private:
    void group_surfaces();
    void attach(Group& group, unsigned index);
    void attach_polygons(const Group& group, RTCGeometry geometry) const;

    /// Calls visit(ray, found) for every ray in order.
    template <class Visit>
    void intersect(const RayPointers& rays, std::size_t count, std::uint32_t source, Visit visit) const;
    /// @param shift  by which share the ray starts nearer to the middle of its source, among rims larger by as much
    [[nodiscard]] EmbreeHit intersect_one(const Line& line, std::uint32_t source, double shift) const;
    [[nodiscard]] EmbreeHit unless_beneath_source(const EmbreeHit& found, const Line& line, std::uint32_t source) const;

    [[nodiscard]] bool is_from_behind(std::uint32_t surface, float u, const Eigen::Vector3d& direction) const {
        return meets_back(surfaces_[surface], u == meets_outward, direction);
    }
    [[nodiscard]] bool is_received(const EmbreeHit& found) const {
        return is_of_face(surfaces_[found.surface]) && !found.from_behind;
    }
    /// A round source is told by core/geometry/line_meets where it is not met again.
    [[nodiscard]] std::uint32_t mask_of(std::uint32_t source) const {
        return by_mask_ && is_flat(surfaces_[source].shape) ? ~(1u << source) : ~0u;
    }

    embree::Device device_;
    std::vector<Surface> surfaces_;
    std::vector<Group> groups_;  ///< one for each geometry
    embree::SceneHandle scene_;
    bool by_mask_ = false;
    bool closed_ = false;
    std::size_t faces_ = 0;
    double gap_ = 0;  ///< distances that may be due to rounding
};

EmbreeTracer::EmbreeTracer(const Scene& scene)
    : device_(rtcNewDevice("threads=1")), surfaces_(scene.surfaces), closed_(scene.closed), faces_(scene.faces.size()) {
    if (!device_) throw UserError("Embree cannot start (too little memory, or too few threads). Allow more.");
    by_mask_ = scene.surfaces.size() <= mask_bits &&
               rtcGetDeviceProperty(device_.get(), RTC_DEVICE_PROPERTY_RAY_MASK_SUPPORTED) != 0;
    if (!by_mask_ && rtcGetDeviceProperty(device_.get(), RTC_DEVICE_PROPERTY_FILTER_FUNCTION_SUPPORTED) == 0) {
        throw UserError("Embree: built without ray masks and filter functions (one is needed). Take another.");
    }
    scene_.reset(rtcNewScene(device_.get()));
    rtcSetSceneFlags(scene_.get(), RTC_SCENE_FLAG_ROBUST);
    rtcSetSceneBuildQuality(scene_.get(), RTC_BUILD_QUALITY_HIGH);
    for (const Surface& surface : surfaces_) gap_ = std::max(gap_, place_rounding * largest_coordinate(surface));
    group_surfaces();
    for (unsigned i = 0; i < groups_.size(); ++i) attach(groups_[i], i);
    rtcCommitScene(scene_.get());
    require_no_error(device_, "building the scene");
}

void EmbreeTracer::group_surfaces() {
    if (!by_mask_)
        groups_ = {{&surfaces_, Kind::quads, {}}, {&surfaces_, Kind::triangles, {}}, {&surfaces_, Kind::round, {}}};
    for (std::uint32_t i = 0; i < surfaces_.size(); ++i) {
        const Kind kind = kind_of(surfaces_[i]);
        if (by_mask_) groups_.push_back({&surfaces_, kind, {}});
        (by_mask_ ? groups_.back() : groups_[static_cast<std::size_t>(kind)]).surfaces.push_back(i);
    }
}

void EmbreeTracer::attach(Group& group, unsigned index) {
    if (group.surfaces.empty()) return;
    constexpr std::array types{RTC_GEOMETRY_TYPE_QUAD, RTC_GEOMETRY_TYPE_TRIANGLE, RTC_GEOMETRY_TYPE_USER};
    const embree::GeometryHandle geometry(
        rtcNewGeometry(device_.get(), types.at(static_cast<std::size_t>(group.kind))));
    rtcSetGeometryUserData(geometry.get(), &group);
    if (group.kind == Kind::round) {
        rtcSetGeometryUserPrimitiveCount(geometry.get(), static_cast<unsigned>(group.surfaces.size()));
        rtcSetGeometryBoundsFunction(geometry.get(), bound, nullptr);
        rtcSetGeometryIntersectFunction(geometry.get(), intersect_round);
    } else {
        attach_polygons(group, geometry.get());
    }
    if (by_mask_) rtcSetGeometryMask(geometry.get(), 1u << index);
    if (!by_mask_ && group.kind != Kind::round) rtcSetGeometryIntersectFilterFunction(geometry.get(), reject_source);
    rtcCommitGeometry(geometry.get());
    rtcAttachGeometryByID(scene_.get(), geometry.get(), index);
}

void EmbreeTracer::attach_polygons(const Group& group, RTCGeometry geometry) const {
    const unsigned n = group.kind == Kind::quads ? 4 : 3;
    const RTCFormat format = group.kind == Kind::quads ? RTC_FORMAT_UINT4 : RTC_FORMAT_UINT3;
    const std::size_t count = group.surfaces.size();
    auto* vertices = static_cast<float*>(
        rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, 3 * sizeof(float), n * count));
    auto* indices = static_cast<unsigned*>(
        rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, format, n * sizeof(unsigned), count));
    require_no_error(device_, "allocating surfaces");
    unsigned next = 0;
    for (const std::uint32_t index : group.surfaces) {
        // In this order Embree's u and v are our s and t on a parallelogram.
        for (const Eigen::Vector3d& corner : corners(surfaces_[index].shape)) {
            for (Eigen::Index axis = 0; axis < 3; ++axis) *vertices++ = static_cast<float>(corner[axis]);
            indices[next] = next;
            ++next;
        }
    }
}

template <class Visit>
void EmbreeTracer::intersect(const RayPointers& rays, std::size_t count, std::uint32_t source, Visit visit) const {
    Context context{};
    embree::init(context.query);
    context.source = source;
    alignas(32) std::array<int, packet> valid{};
    valid.fill(-1);
    RTCRayHit8 p{};  // tnear is 0 and stays so
    std::fill_n(p.ray.mask, packet, mask_of(source));
    const std::array components{p.ray.org_x, p.ray.org_y, p.ray.org_z, p.ray.dir_x, p.ray.dir_y, p.ray.dir_z};
    for (std::size_t first = 0; first < count; first += packet) {
        const std::size_t n = std::min(packet, count - first);
        const auto load = [first, n](const float* from, float* to) {
            // A copy of known length is two instructions, one of unknown length is a call.
            n == packet ? std::copy_n(from + first, packet, to) : std::copy_n(from + first, n, to);
        };
        for (std::size_t c = 0; c < rays.size(); ++c) load(rays[c], components[c]);
        std::fill_n(p.ray.tfar, packet, std::numeric_limits<float>::infinity());
        std::fill_n(p.hit.geomID, packet, RTC_INVALID_GEOMETRY_ID);
        if (n < packet) std::fill(valid.begin() + n, valid.end(), 0);
        embree::intersect8(valid.data(), scene_.get(), context.query, p);
        for (std::size_t i = 0; i < n; ++i) {
            if (p.hit.geomID[i] != RTC_INVALID_GEOMETRY_ID) {
                const std::uint32_t surface = groups_[p.hit.geomID[i]].surfaces[p.hit.primID[i]];
                const bool from_behind = is_from_behind(surface, p.hit.u[i], direction_of(rays, first + i));
                const EmbreeHit found{surface, p.ray.tfar[i], p.hit.u[i], p.hit.v[i], from_behind};
                visit(first + i, from_behind ? unless_beneath_source(found, line_of(rays, first + i), source) : found);
            } else {
                visit(first + i,
                      closed_ ? intersect_one(line_of(rays, first + i), source, second_attempt) : EmbreeHit{});
            }
        }
    }
}

EmbreeHit EmbreeTracer::intersect_one(const Line& line, std::uint32_t source, double shift) const {
    Context context{};
    embree::init(context.query);
    context.source = source;
    context.rim = shift;
    const Eigen::Vector3f o = (line.origin + shift * (middle(surfaces_[source]) - line.origin)).cast<float>();
    const Eigen::Vector3f d = line.direction.cast<float>();
    RTCRayHit ray{};
    ray.ray = {o.x(), o.y(), o.z(), 0, d.x(), d.y(), d.z(), 0, HUGE_VALF, mask_of(source), 0, 0};
    ray.hit.geomID = RTC_INVALID_GEOMETRY_ID;
    embree::intersect1(scene_.get(), context.query, ray);
    if (ray.hit.geomID == RTC_INVALID_GEOMETRY_ID) return {};
    const std::uint32_t surface = groups_[ray.hit.geomID].surfaces[ray.hit.primID];
    return {surface, ray.ray.tfar, ray.hit.u, ray.hit.v, is_from_behind(surface, ray.hit.u, line.direction)};
}

/// A rounded origin may lie on the edge of a neighbour that is level with the source or turned away from it, or a
/// little beneath both: then the ray meets the neighbour's back before it has risen above the source. It starts once
/// more, from as far above.
EmbreeHit EmbreeTracer::unless_beneath_source(const EmbreeHit& found, const Line& line, std::uint32_t source) const {
    const Eigen::Vector3d up = normal_at(surfaces_[source], line.origin);
    const double risen = static_cast<double>(found.time) * up.dot(line.direction);
    return risen <= gap_ ? intersect_one({line.origin + 2 * gap_ * up, line.direction}, source, 0) : found;
}

void EmbreeTracer::shoot(std::uint32_t source, Grid grid, std::uint32_t patch, const PointBlock& block,
                         std::span<std::uint64_t> hits) const {
    FF_EXPECT(hits.size() == faces_ + 1);
    RayBlock rays;
    generate_ray_block(surfaces_.at(source), grid, patch, block, rays);
    const RayPointers pointers = pointers_to(rays);
    intersect(pointers, block.size, source, [&](std::size_t /*i*/, const EmbreeHit& found) {
        if (found.surface == no_surface) {
            ++hits[faces_];
        } else if (is_received(found)) {
            ++hits[static_cast<std::size_t>(surfaces_[found.surface].face)];
        }
    });
}

void EmbreeTracer::trace(const RayBatch& rays, std::span<Hit> hits) const {
    FF_EXPECT(hits.size() >= rays.size());
    const RayPointers pointers = pointers_to(rays);
    intersect(pointers, rays.size(), rays.source, [&](std::size_t i, const EmbreeHit& found) {
        Hit& hit = hits[i] = {.surface = found.surface};
        if (found.surface == no_surface) return;
        hit.received = is_received(found);
        if (std::holds_alternative<Parallelogram>(surfaces_[found.surface].shape)) {
            hit.s = std::clamp(found.u, 0.0f, 1.0f);
            hit.t = std::clamp(found.v, 0.0f, 1.0f);
            return;
        }
        const auto [s, t] =
            SurfaceMap(surfaces_[found.surface]).coordinates(line_of(pointers, i).at(static_cast<double>(found.time)));
        hit.s = static_cast<float>(s);
        hit.t = static_cast<float>(t);
    });
}

}  // namespace

std::unique_ptr<Tracer> make_embree_tracer(const Scene& scene) {
    // ThreadSanitizer sees a race inside of Embree 3.13 where two scenes are built at a time.
    static std::mutex one_at_a_time;
    const std::lock_guard lock(one_at_a_time);
    return std::make_unique<EmbreeTracer>(scene);
}

std::string tracer_version() {
    const embree::Device device(rtcNewDevice("threads=1"));
    const auto version = rtcGetDeviceProperty(device.get(), RTC_DEVICE_PROPERTY_VERSION);
    return fmt::format("Embree {}.{}.{}", version / 10000, version / 100 % 100, version % 100);
}

}  // namespace ff
