#include "core/geometry/surface_map.hpp"
#include "core/tracing/rays.hpp"
#include "core/tracing/tracer.hpp"
#include "core/visibility/mirrors.hpp"

#include <numeric>
#include <utility>
#include <vector>

namespace ff {
namespace {

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

class MirrorTracer final : public Tracer {
  public:
    MirrorTracer(const Scene& scene, std::unique_ptr<Tracer> tracer) : scene_(scene), tracer_(std::move(tracer)) {
        const std::vector<std::uint32_t> found = ff::mirrors(scene);
        mirror_of_.assign(scene.surfaces.size(), found.size());
        for (const std::uint32_t surface : found) {
            mirror_of_[surface] = mirrors_.size();
            const Surface& glass = scene.surfaces[surface];
            mirrors_.push_back({surface, SurfaceMap(glass), glass.normal.cast<float>()});
        }
    }

    [[nodiscard]] std::string_view name() const override { return tracer_->name(); }

    void shoot(std::uint32_t source, Grid grid, std::uint32_t patch, const PointBlock& block,
               std::span<std::uint64_t> hits) const override {
        shoot_by_tracing(*this, scene_, source, grid, patch, block, hits);
    }

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

    Scene scene_;
    std::unique_ptr<Tracer> tracer_;
    std::vector<Mirror> mirrors_;
    std::vector<std::size_t> mirror_of_;  ///< index into mirrors_ for each surface; mirrors_.size() for all others
};

}  // namespace

std::unique_ptr<Tracer> make_mirror_tracer(const Scene& scene, std::unique_ptr<Tracer> tracer) {
    return std::make_unique<MirrorTracer>(scene, std::move(tracer));
}

}  // namespace ff
