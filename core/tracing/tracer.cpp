#include "core/tracing/tracer.hpp"

#include "core/geometry/placement.hpp"
#include "core/geometry/surface_map.hpp"
#include "core/support/contract.hpp"
#include "core/support/error.hpp"
#include "core/tracing/rays.hpp"
#include "core/visibility/mirrors.hpp"

#include <numeric>
#include <utility>
#include <vector>

namespace ff {
namespace {

/// Traces rays one by one, and counts where they end.
class OneByOneTracer : public Tracer {
  public:
    explicit OneByOneTracer(Scene scene) : scene_(std::move(scene)) {}

    void shoot(std::uint32_t source, Grid grid, std::uint32_t patch, const PointBlock& block,
               std::span<std::uint64_t> hits) const final {
        FF_EXPECT(hits.size() == scene_.faces.size() + 1);
        std::vector<Hit> found(block.size);
        find_ends(scene_.surfaces[source], source, grid, patch, block, found);
        for (const Hit& hit : found) {
            if (hit.surface == no_surface) {
                ++hits[scene_.faces.size()];
            } else if (hit.received) {
                ++hits[static_cast<std::size_t>(scene_.surfaces[hit.surface].face)];
            }
        }
    }

  private:
    Scene scene_;
};

bool is_in_crack(float place) {
    return place < crack_width || place > 1 - crack_width;
}

class LeakyTracer final : public OneByOneTracer {
  public:
    explicit LeakyTracer(const Scene& scene)
        : OneByOneTracer(scene), sound_(make_tracer(scene, TracerChoice::automatic)) {}

    [[nodiscard]] std::string_view name() const override { return "leaky"; }

    void trace(const RayBatch& rays, std::span<Hit> hits) const override {
        sound_->trace(rays, hits);
        for (Hit& hit : hits.first(rays.size())) {
            if (is_in_crack(hit.s) || is_in_crack(hit.t)) hit = {};
        }
    }

  private:
    std::unique_ptr<Tracer> sound_;
};

/// A ray that meets a mirror after this many reflections is lost. In a box without opposite mirrors no ray is reflected
/// more than three times.
constexpr int most_reflections = 64;

/// Rays on their way, and the index of the requested ray that each belongs to.
struct Paths {
    RayBatch rays;
    std::vector<std::size_t> number;

    void add(const Eigen::Vector3f& origin, const Eigen::Vector3f& direction, std::size_t ray) {
        const auto components = components_of(rays);
        for (Eigen::Index axis = 0; axis < 3; ++axis) {
            components[static_cast<std::size_t>(axis)]->push_back(origin[axis]);
            components[static_cast<std::size_t>(axis) + 3]->push_back(direction[axis]);
        }
        number.push_back(ray);
    }
};

/// One mirror, in the precision of rays.
struct Mirror {
    std::uint32_t surface = 0;
    SurfaceMap map;
    Eigen::Vector3f normal;
};

/// Reflects rays that meet the front of a mirror; `tracer`, of the same scene, finds what they meet. Only final hits
/// are reported, none of them on a mirror.
class MirrorTracer final : public OneByOneTracer {
  public:
    MirrorTracer(const Scene& scene, std::unique_ptr<Tracer> tracer)
        : OneByOneTracer(scene), tracer_(std::move(tracer)) {
        const std::vector<std::uint32_t> found = ff::mirrors(scene);
        mirror_of_.assign(scene.surfaces.size(), found.size());
        for (const std::uint32_t surface : found) {
            mirror_of_[surface] = mirrors_.size();
            const Surface& glass = scene.surfaces[surface];
            mirrors_.push_back({surface, SurfaceMap(glass), glass.normal.cast<float>()});
        }
    }

    [[nodiscard]] std::string_view name() const override { return tracer_->name(); }

    void trace(const RayBatch& rays, std::span<Hit> hits) const override {
        std::vector<std::size_t> all(rays.size());
        std::iota(all.begin(), all.end(), std::size_t{0});
        follow(rays, all, hits, 0);
    }

  private:
    void follow(const RayBatch& rays, std::span<const std::size_t> number, std::span<Hit> hits, int reflections) const {
        std::vector<Hit> found(rays.size());
        tracer_->trace(rays, found);
        std::vector<Paths> onward(mirrors_.size());
        for (std::size_t i = 0; i < found.size(); ++i) {
            const Hit& hit = found[i];
            const std::size_t which = hit.surface == no_surface ? mirrors_.size() : mirror_of_[hit.surface];
            const Eigen::Vector3f direction(rays.direction_x[i], rays.direction_y[i], rays.direction_z[i]);
            if (which == mirrors_.size() || mirrors_[which].normal.dot(direction) >= 0) {
                hits[number[i]] = hit;
                continue;
            }
            hits[number[i]] = {};  // lost, unless the ray continues
            const Mirror& mirror = mirrors_[which];
            const Eigen::Vector3f place = mirror.map.at(hit.s, hit.t).position.cast<float>();
            onward[which].add(place, direction - 2 * mirror.normal.dot(direction) * mirror.normal, number[i]);
        }
        if (reflections == most_reflections) return;
        for (std::size_t m = 0; m < onward.size(); ++m) {
            if (onward[m].number.empty()) continue;
            onward[m].rays.source = mirrors_[m].surface;
            follow(onward[m].rays, onward[m].number, hits, reflections + 1);
        }
    }

    std::unique_ptr<Tracer> tracer_;
    std::vector<Mirror> mirrors_;
    std::vector<std::size_t> mirror_of_;  ///< index into mirrors_ for each surface; mirrors_.size() for all others
};

std::unique_ptr<Tracer> make_straight_tracer(const Scene& scene, TracerChoice choice) {
    if (choice == TracerChoice::box && !scene.empty_box) {
        throw UserError("tracer: the box tracer cannot do scene '" + scene.name +
                        "' (it knows only the inside of an empty box). Choose embree or automatic.");
    }
    if (choice != TracerChoice::embree && scene.empty_box) return make_box_tracer(scene);
    return has_fine_detail(scene) ? make_double_tracer(scene) : make_embree_tracer(scene);
}

}  // namespace

void Tracer::find_ends(const Surface& surface, std::uint32_t source, Grid grid, std::uint32_t patch,
                       const PointBlock& block, std::span<Hit> hits) const {
    RayBatch rays;
    generate_rays(surface, source, grid, patch, block, rays);
    trace(rays, hits);
}

std::unique_ptr<Tracer> make_tracer(const Scene& given, TracerChoice choice) {
    const Scene scene = placed(given);
    if (choice == TracerChoice::leaky) return std::make_unique<LeakyTracer>(scene);
    auto tracer = make_straight_tracer(scene, choice);
    return mirrors(scene).empty() ? std::move(tracer) : std::make_unique<MirrorTracer>(scene, std::move(tracer));
}

}  // namespace ff
