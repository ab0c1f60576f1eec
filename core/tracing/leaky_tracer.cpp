#include "core/tracing/tracer.hpp"

namespace ff {
namespace {

bool is_in_crack(float place) {
    return place < crack_width || place > 1 - crack_width;
}

class LeakyTracer final : public Tracer {
  public:
    explicit LeakyTracer(const Scene& scene) : scene_(scene), sound_(make_tracer(scene, TracerChoice::automatic)) {}

    [[nodiscard]] std::string_view name() const override { return "leaky"; }

    void shoot(std::uint32_t source, Grid grid, std::uint32_t patch, const PointBlock& block,
               std::span<std::uint64_t> hits) const override {
        shoot_by_tracing(*this, scene_, source, grid, patch, block, hits);
    }

    void trace(const RayBatch& rays, std::span<Hit> hits) const override {
        sound_->trace(rays, hits);
        for (Hit& hit : hits.first(rays.size())) {
            if (is_in_crack(hit.s) || is_in_crack(hit.t)) hit = {};
        }
    }

  private:
    Scene scene_;
    std::unique_ptr<Tracer> sound_;
};

}  // namespace

std::unique_ptr<Tracer> make_leaky_tracer(const Scene& scene) {
    return std::make_unique<LeakyTracer>(scene);
}

}  // namespace ff
