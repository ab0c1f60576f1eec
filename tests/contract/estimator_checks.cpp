#include "tests/contract/estimator_checks.hpp"

#include "core/geometry/scene.hpp"
#include "samplers/sampler.hpp"
#include "stats/basics/moments.hpp"
#include "tests/support/statistical_assertions.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <stdexcept>
#include <utility>
#include <vector>

namespace ff::test {
namespace {

using testing::AssertionFailure;
using testing::AssertionResult;
using testing::AssertionSuccess;

constexpr std::uint32_t fewest_trials = 32;
constexpr std::uint32_t most_trials = 2048;

std::uint64_t samples(const EstimatorInfo& info) {
    switch (info.points) {
        case PointsServe::pairs:
            return 64;
        case PointsServe::patches:
            return 1024;
        case PointsServe::scene:
            return 8192;
        case PointsServe::nothing:
            break;
    }
    return 0;
}

/// The size of an estimator that makes its own points.
struct Fineness {
    std::uint64_t points;  ///< at least, where they do not serve a pair of patches
    std::uint32_t grid;    ///< patches along an edge of a face, there
};
constexpr Fineness fine{10'000, 8};
constexpr Fineness coarse{1000, 2};

/// Number of points for an estimator that makes its own points: the least that it takes, from `least` on, or from 200
/// on where the points serve a pair of patches. 0 for other estimators.
std::uint64_t own_points(const EstimatorEntry& estimator, std::uint64_t least) {
    if (!estimator.info.own_points) return 0;
    std::uint64_t size = estimator.info.points == PointsServe::pairs ? 200 : least;
    while (!estimator.size_problem(size).empty()) ++size;
    return size;
}

/// An estimator on a scene, with points of its own.
class Ready {
  public:
    Ready(const EstimatorEntry& entry, Scene scene, Fineness own = fine)
        : scene_(std::move(scene)),
          estimator_(entry.make(scene_, TracerChoice::automatic)),
          samples_(own_points(entry, own.points)),
          grid_{entry.info.own_points && entry.info.points != PointsServe::pairs ? own.grid : 2u} {
        if (entry.info.takes_points())
            points_ =
                samplers::find(samplers::yardstick().name).make({samples(entry.info), entry.info.dimension, 0, 0});
        if (points_) samples_ = points_->points();
    }

    Eigen::MatrixXd trial(std::uint32_t number) const {
        Outcome outcome;
        PatchTotals totals;
        estimator_->observe({.subdivision = grid_,
                             .points = points_.get(),
                             .samples = samples_,
                             .options = {},
                             .key = {0x12345678, 0x9abcdef0},
                             .trial = number},
                            outcome, totals);
        return outcome.estimates;
    }

  private:
    Scene scene_;
    std::unique_ptr<const PointSource> points_;
    std::unique_ptr<const Estimator> estimator_;
    std::uint64_t samples_ = 0;
    Subdivision grid_;
};

double standard_error(const std::vector<double>& values) {
    const auto moments = stats::moments_of(values, values.front());
    return std::sqrt(*moments.variance() / static_cast<double>(values.size()));
}

/// A scene of the catalogue that an estimator can handle.
Scene scene_for(const EstimatorEntry& estimator) {
    for (const std::string_view name : configuration_scene_names()) {
        Scene scene = *configuration_scene(name);
        if (estimator.refusal({}, scene).empty()) return scene;
    }
    throw std::logic_error("an estimator that can do no scene of the catalogue");
}

}  // namespace

double noticed_bias(double factor) {
    return 0.03 * std::sqrt(factor);
}

AssertionResult declares_itself(const EstimatorEntry& estimator) {
    const EstimatorInfo& info = estimator.info;
    for (const std::string_view text : {info.name, info.summary, info.details, info.reference, info.evaluations}) {
        if (text.empty()) return AssertionFailure() << info.name << " leaves a text empty";
    }
    if (info.dimension > max_dimension) return AssertionFailure() << "points of " << info.dimension << " coordinates";
    if (!info.own_points && info.takes_points() != (info.points != PointsServe::nothing))
        return AssertionFailure() << info.dimension << " coordinates, but `points` says otherwise";
    if (info.own_points && (info.takes_points() || estimator.size_problem(0).empty()))
        return AssertionFailure() << "points of its own beside those of a sampler, or none at all";
    if (info.observes == Observes::hits && info.points != PointsServe::patches)
        return AssertionFailure() << "hits are of rays from patches";
    if (!(estimator.nanoseconds({}, scene_for(estimator)) > 0)) return AssertionFailure() << "costs nothing";
    return AssertionSuccess();
}

AssertionResult says_why_not(const EstimatorEntry& estimator) {
    for (const std::string_view name : configuration_scene_names()) {
        const std::string refusal = estimator.refusal({}, *configuration_scene(name));
        if (refusal.empty()) continue;
        for (const std::string_view part : {name, std::string_view("("), std::string_view("). Use ")}) {
            if (refusal.find(part) == std::string::npos)
                return AssertionFailure() << "\"" << refusal << "\" lacks \"" << part << "\"";
        }
    }
    return AssertionSuccess();
}

AssertionResult depends_on_its_task(const EstimatorEntry& estimator) {
    bool trials_differ = false;
    for (const std::string_view name : configuration_scene_names()) {
        const Scene scene = *configuration_scene(name);
        if (!estimator.refusal({}, scene).empty()) continue;
        const Ready ready(estimator, scene, coarse);
        const Eigen::MatrixXd estimates = ready.trial(3);
        if (ready.trial(3) != estimates) return AssertionFailure() << "the same trial differs in scene " << name;
        trials_differ = trials_differ || ready.trial(4) != estimates;
    }
    if (trials_differ != estimator.info.takes_points())
        return AssertionFailure() << "trials differ if and only if they have points";
    return AssertionSuccess();
}

AssertionResult is_unbiased(const EstimatorEntry& estimator, const Configuration& configuration) {
    const Scene scene =
        configuration.scene != nullptr ? configuration.scene() : configuration_scene(configuration.scene_name).value();
    const auto [from, to] = std::pair(configuration.from, configuration.to);
    if (!estimator.refusal({}, scene).empty() || !estimator.finite_variance({}, scene, from, to))
        return AssertionSuccess();
    const auto exact = static_cast<double>(configuration.exact());
    const Ready ready(estimator, scene);
    if (!estimator.info.takes_points()) {
        const double error = std::abs(ready.trial(0)(from, to) - exact);
        if (error <= (estimator.info.own_points ? noticed_bias(exact) : 1e-12)) return AssertionSuccess();
        return AssertionFailure() << "off by " << error;
    }
    // As many trials as their spread requires: of 32, eleven standard errors are noticed at 1e-8 with power 0.99.
    std::vector<double> estimates;
    const double noticed = noticed_bias(exact);
    for (std::size_t wanted = fewest_trials; wanted <= most_trials; wanted *= 2) {
        while (estimates.size() < wanted)
            estimates.push_back(ready.trial(static_cast<std::uint32_t>(estimates.size()))(from, to));
        if (11 * standard_error(estimates) < noticed) break;
    }
    // Values that differ by rounding alone have no spread to judge by.
    const auto [least, most] = std::minmax_element(estimates.begin(), estimates.end());
    if (*most - *least < 1e-13) {
        const double error = std::abs(*least - exact);
        if (error <= 1e-12) return AssertionSuccess();
        return AssertionFailure() << "off by " << error << " in every trial";
    }
    return unbiased(estimates, exact, {.alpha = 1e-8, .detects = noticed});
}

}  // namespace ff::test
