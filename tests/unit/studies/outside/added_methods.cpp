#include "core/estimators/added.hpp"
#include "core/estimators/pairs/patch_pairs.hpp"
#include "core/support/error.hpp"
#include "samplers/outside/added.hpp"
#include "samplers/sampler.hpp"
#include "studies/results/results.hpp"
#include "tests/support/studies.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <numbers>
#include <string>
#include <vector>

namespace ff::studies {
namespace {

/// The example of docs/library.md: the kernel between points on two patches.
class Kernel : public Estimator {
  public:
    explicit Kernel(const Scene& scene) : scene_(scene) {}
    void observe(const EstimatorTask& task, Outcome& outcome, PatchTotals& /*totals*/) const override {
        outcome.estimates = average_over_pairs(scene_, task, 4, [](const PatchPair& pair, const WeightedBlock& points) {
            double sum = 0;
            for (std::size_t i = 0; i < points.size; ++i) {
                const SurfacePoint x = pair.from.at(points.coordinate[0][i], points.coordinate[1][i]);
                const SurfacePoint y = pair.to.at(points.coordinate[2][i], points.coordinate[3][i]);
                const Eigen::Vector3d ray = y.position - x.position;
                const double cosines = x.normal.dot(ray) * -y.normal.dot(ray) / ray.squaredNorm();
                sum += points.weight[i] * cosines * pair.to.area / (std::numbers::pi * ray.squaredNorm());
            }
            return sum;
        });
    }

  private:
    const Scene& scene_;
};

/// Does what a program that links with the libraries does.
void add_methods() {
    EstimatorInfo kernel;
    kernel.dimension = 4;
    kernel.points = PointsServe::pairs;
    add(std::make_unique<AddedEstimator>(AddedEstimator::Texts{"linked_kernel", "points on two patches", ""}, kernel,
                                         nullptr, [](const Scene& scene) { return std::make_unique<Kernel>(scene); }));
    samplers::add(std::make_unique<samplers::AddedSampler>(
        samplers::AddedSampler::Texts{"linked_points", "scrambled Sobol' points", ""}, samplers::SamplerInfo{},
        std::vector<std::uint64_t>(),
        [](const samplers::PointSetSpec& spec) { return samplers::find("sobol").make(spec); }));
}

TEST(AddedMethods, WorkInStudiesLikeBuiltInMethods) {
    add_methods();
    const auto results = evaluate(test::run(test::plan_of(test::study_text("trials = 60", R"([[method]]
name = "mine"
sampler = "linked_points"
estimator = "linked_kernel"
samples_per_patch = 256
patches_per_face = 4
)"))));
    const CellAnalysis& found = results.findings.cells.front();
    const Summary& opposite = found.summary({QuantityKind::form_factor, 1, 6});
    ASSERT_TRUE(opposite.bias && opposite.bias_se);
    // Five standard errors: a sound estimator fails in 1e-5 of seeds. A wrong factor pi or area is off by far more.
    EXPECT_LE(std::abs(*opposite.bias), 5 * *opposite.bias_se);
    EXPECT_LT(*opposite.bias_se, 1e-3);
}

TEST(AddedMethods, AreRefusedWhenTheirNamesAreTaken) {
    const auto add_named = [](const char* name) {
        add(std::make_unique<AddedEstimator>(AddedEstimator::Texts{name, "", ""}, EstimatorInfo{}, nullptr, nullptr));
    };
    EXPECT_NE(test::message_of<UserError>([&] { add_named("ray_shooting"); }).find("already"), std::string::npos);
}

}  // namespace
}  // namespace ff::studies
