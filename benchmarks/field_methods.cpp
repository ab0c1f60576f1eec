// Other methods of the field compared with rays, on the same scenes: the cost of a trial, and the error after a second.

#include "core/configurations/built_in_scene.hpp"
#include "core/estimators/estimator.hpp"
#include "core/exact/known_factors.hpp"
#include "core/geometry/scene.hpp"
#include "samplers/sampler.hpp"

#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include <cmath>
#include <cstdint>
#include <memory>
#include <string>

namespace {

using namespace ff;

/// An estimator on a scene, with Sobol' points where it takes some.
class Ready {
  public:
    Ready(const std::string& estimator, const std::string& scene, std::uint64_t samples, TracerChoice tracer,
          std::uint32_t m = 1)
        : scene_(built_in_scene(scene)), samples_(samples), m_(m) {
        const EstimatorEntry& entry = find_estimator(estimator);
        estimator_ = entry.make(scene_, tracer);
        if (entry.info.takes_points())
            points_ = samplers::find("sobol").make({.points = samples, .dimension = entry.info.dimension});
    }

    Eigen::MatrixXd trial(std::uint32_t number) const {
        Outcome outcome;
        PatchTotals totals;
        estimator_->observe({.subdivision = {m_},
                             .points = points_.get(),
                             .samples = samples_,
                             .options = {},
                             .key = {1, 2},
                             .trial = number},
                            outcome, totals);
        return outcome.estimates;
    }
    [[nodiscard]] const Scene& scene() const { return scene_; }

  private:
    Scene scene_;
    std::unique_ptr<const Estimator> estimator_;
    std::unique_ptr<const PointSource> points_;
    std::uint64_t samples_;
    std::uint32_t m_;
};

void time_trials(benchmark::State& state, const Ready& ready, double evaluations) {
    std::uint32_t trial = 0;
    for (auto _ : state) benchmark::DoNotOptimize(ready.trial(trial++));
    state.counters["per_evaluation"] =
        benchmark::Counter(evaluations, benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

void hemicube(benchmark::State& state) {
    const auto r = static_cast<std::uint64_t>(state.range(0));
    time_trials(state, Ready("hemicube", "cube", 3 * r * r, TracerChoice::automatic),
                6.0 * static_cast<double>(3 * r * r));
}
BENCHMARK(hemicube)->Name("hemicube/cube")->Arg(64)->Arg(512)->Unit(benchmark::kMillisecond);

constexpr std::uint64_t many = 1 << 16;

void local_rays(benchmark::State& state, const std::string& scene) {
    const Ready ready("ray_shooting", scene, many, TracerChoice::embree);
    time_trials(state, ready, static_cast<double>(many * ready.scene().faces.size()));
}

/// Every crossing of a face is the end of a ray: in a box each line has two.
void global_lines(benchmark::State& state, const std::string& scene) {
    time_trials(state, Ready("global_lines", scene, many, TracerChoice::automatic), 2.0 * static_cast<double>(many));
}
BENCHMARK_CAPTURE(local_rays, cube, std::string("cube"))->Name("local_rays/cube");
BENCHMARK_CAPTURE(global_lines, cube, std::string("cube"))->Name("global_lines/cube");
BENCHMARK_CAPTURE(local_rays, box, std::string("box:2x1x0.5"))->Name("local_rays/box:2x1x0.5");
BENCHMARK_CAPTURE(global_lines, box, std::string("box:2x1x0.5"))->Name("global_lines/box:2x1x0.5");

/// Mean square error times processor time on F 1-6 of a box 1 x 1 x DISTANCE, as `work`: smaller is better.
void efficiency(benchmark::State& state, const std::string& estimator, std::uint64_t samples) {
    const std::string name = fmt::format("box:1x1x{}", state.range(0));
    const Ready ready(estimator, name, samples, TracerChoice::automatic);
    const double exact = known_factors(ready.scene()).at(0, 5).value();
    double squares = 0;
    std::uint32_t trials = 0;
    for (auto _ : state) squares += std::pow(ready.trial(trials++)(0, 5) - exact, 2);
    state.counters["relative_rmse"] = std::sqrt(squares / trials) / exact;
    // Iterations over seconds, times the error of one: its inverse is what a second buys.
    state.counters["work"] = benchmark::Counter(trials / (squares / trials / (exact * exact)),
                                                benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
}
BENCHMARK_CAPTURE(efficiency, rays, std::string("ray_shooting"), 4096)
    ->Name("small_target/ray_shooting")
    ->RangeMultiplier(4)
    ->Range(1, 64)
    ->Iterations(400);
BENCHMARK_CAPTURE(efficiency, solid_angle, std::string("solid_angle"), 256)
    ->Name("small_target/solid_angle")
    ->RangeMultiplier(4)
    ->Range(1, 64)
    ->Iterations(400);

}  // namespace
