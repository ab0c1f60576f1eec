#include "core/configurations/built_in_scene.hpp"
#include "core/configurations/catalogue.hpp"
#include "core/geometry/scene.hpp"
#include "studies/form_factors/form_factors.hpp"
#include "tests/support/repetitions.hpp"
#include "tests/support/statistical_assertions.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <memory>

namespace ff::studies::form_factors {
namespace {

/// A tracer that is broken on purpose: rays that meet the first `hole` of a surface are lost, once this many rays have
/// been shot.
class HoleyTracer final : public Tracer {
  public:
    HoleyTracer(const Scene& scene, float hole, std::uint64_t sound_rays)
        : sound_(make_tracer(scene, TracerChoice::automatic)), hole_(hole), sound_rays_(sound_rays) {}

    [[nodiscard]] std::string_view name() const override { return "holey"; }

    void shoot(std::uint32_t source, Grid grid, std::uint32_t patch, const PointBlock& block,
               std::span<std::uint64_t> hits) const override {
        sound_->shoot(source, grid, patch, block, hits);
    }

    void trace(const RayBatch& rays, std::span<Hit> hits) const override {
        sound_->trace(rays, hits);
        if ((rays_ += rays.size()) <= sound_rays_) return;
        for (Hit& hit : hits.first(rays.size())) {
            if (hit.s < hole_) hit = {};
        }
    }

  private:
    std::unique_ptr<Tracer> sound_;
    float hole_;
    std::uint64_t sound_rays_;
    mutable std::atomic<std::uint64_t> rays_{0};
};

const std::uint64_t contradiction_runs = test::repetitions(40, 200);

/// Outcomes of the estimate for the first two faces, counted over runs with different seeds.
struct Outcome {
    std::uint64_t contradicted = 0;
    std::uint64_t held = 0;  ///< intervals among these that hold the exact value
};

/// The outcome for two discs, which are sampled by rays.
Outcome outcome(float hole, std::uint64_t sound_rays = 0) {
    const Scene scene = built_in_scene("discs_blocked");
    const double exact = *known_form_factor(scene, 0, 1);
    Outcome outcome;
    for (std::uint64_t seed = 1; seed <= contradiction_runs; ++seed) {
        Request request;
        request.tolerance = 2e-3;
        request.seed = Seed{seed};
        request.threads = 2;
        request.tracer = [&](const Scene& joined) { return std::make_unique<HoleyTracer>(joined, hole, sound_rays); };
        const Matrix matrix = find_matrix(scene, request);
        const FaceExchange& pair = matrix.exchange(0, 1);
        if (!pair.contradicted) continue;
        EXPECT_FALSE(pair.within) << "a contradicted entry counts as missed";
        ++outcome.contradicted;
        outcome.held += pair.low <= exact * matrix.areas[0] && exact * matrix.areas[0] <= pair.high;
    }
    return outcome;
}

const test::StatisticalRisk contradiction_risk{
    .alpha = 1e-6, .detects = test::is_nightly() ? 0.16 : 0.5, .power = 0.99};

// Sound estimates are contradicted in 0.001 of runs at most, over all pairs.
TEST(FormFactorContradictions, AreRareWhereNothingIsBroken) {
    EXPECT_TRUE(test::has_probability_at_most(outcome(0).contradicted, contradiction_runs, 1e-3, contradiction_risk));
}

// The first pilots are sound, and the later rounds are not. This is found in at least 0.95 of runs, and the
// interval, which contains that of the pilots, misses no more often than that one may.
TEST(FormFactorContradictions, AreFoundWhereLaterRaysAreLost) {
    const Outcome found = outcome(0.1F, 65536);
    EXPECT_TRUE(test::has_probability_at_least(found.contradicted, contradiction_runs, 0.95, contradiction_risk));
    EXPECT_TRUE(test::has_probability_at_least(found.held, found.contradicted, 0.95, contradiction_risk));
}

// A thousandth of a surface is less than the pilots can detect: nobody should rely on this comparison alone.
TEST(FormFactorContradictions, AreNotFoundWhereLittleIsLost) {
    EXPECT_TRUE(test::has_probability_at_most(outcome(0.001F, 65536).contradicted, contradiction_runs, 0.01,
                                              contradiction_risk));
}

}  // namespace
}  // namespace ff::studies::form_factors
