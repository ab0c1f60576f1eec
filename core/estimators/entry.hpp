#pragma once

#include "core/estimators/estimator.hpp"

namespace ff {

/// The one way to make an estimator: a class that derives from this one, with
///
///     static constexpr EstimatorInfo info{...};
///     T(const Scene&, TracerChoice);                                  // refusal() has been asked
///     void observe(const EstimatorTask&, Outcome&, PatchTotals&) const;
///
/// and, where `info.own_points`, what is wrong with a size,
///
///     static std::string size_problem(std::uint64_t samples);
///     static std::uint64_t samples_of_resolution(std::uint64_t resolution);  // where sizes are called that
///
/// and optionally
///
///     static double nanoseconds(const EstimatorOptions&, const Scene&);    // in place of what `info` says
///     static std::optional<Integrand> integrand(const EstimatorOptions&, PairClass, Hiding);    // likewise
///
/// and what it says otherwise than the functions below. `estimator_entry<T>()` turns it into a line of the catalogue.
class SceneEstimator {
  public:
    SceneEstimator(const Scene& scene, TracerChoice /*tracer*/) : scene_(&scene) {}

    /// Why the estimator cannot be used, beyond what follows from `info`; empty: it can.
    static std::string refusal(const EstimatorOptions& /*options*/, const Scene& /*scene*/) { return {}; }
    static bool finite_variance(const EstimatorOptions& /*options*/, const Scene& /*scene*/, int /*from*/, int /*to*/) {
        return true;
    }
    static double largest_unmet(const Scene& /*scene*/, int /*from*/, int /*to*/, double /*evaluations*/) { return 0; }

  protected:
    [[nodiscard]] const Scene& scene() const { return *scene_; }

  private:
    const Scene* scene_;
};

template <class T>
class ErasedEstimator final : public Estimator {
  public:
    ErasedEstimator(const Scene& scene, TracerChoice tracer) : estimator_(scene, tracer) {}

    void observe(const EstimatorTask& task, Outcome& outcome, PatchTotals& totals) const override {
        estimator_.observe(task, outcome, totals);
    }

  private:
    T estimator_;
};

/// The refusal by `info`: an estimator that sees no occluders, or no mirrors, is refused where there may be some.
std::string refusal_of(const EstimatorInfo& info, const Scene& scene);

/// The same for what an estimator finds out by itself: "NAME cannot be used in scene 'SCENE' (WHY). Use estimator =
/// ..."
std::string refused(const EstimatorInfo& info, const Scene& scene, std::string_view why,
                    std::string_view instead = R"("ray_shooting" or "area_kernel")");

/// The catalogue's line for estimator T.
template <class T>
EstimatorEntry estimator_entry() {
    return {.info = T::info,
            .refusal =
                [](const EstimatorOptions& options, const Scene& scene) {
                    std::string general = refusal_of(T::info, scene);
                    return general.empty() ? T::refusal(options, scene) : general;
                },
            .size_problem = [](std::uint64_t samples) -> std::string {
                if constexpr (T::info.own_points) {
                    return T::size_problem(samples);
                } else {
                    return {};
                }
            },
            .samples_of_resolution =
                [] {
                    std::uint64_t (*function)(std::uint64_t) = nullptr;
                    if constexpr (requires { T::samples_of_resolution(1); }) function = &T::samples_of_resolution;
                    return function;
                }(),
            .nanoseconds =
                [](const EstimatorOptions& options, const Scene& scene) {
                    if constexpr (requires { T::nanoseconds(options, scene); }) {
                        return T::nanoseconds(options, scene);
                    } else {
                        static_assert(T::info.nanoseconds > 0);
                        return T::info.nanoseconds;
                    }
                },
            .integrand = [](const EstimatorOptions& options, PairClass pair_class,
                            Hiding hiding) -> std::optional<Integrand> {
                if constexpr (requires { T::integrand(options, pair_class, hiding); }) {
                    return T::integrand(options, pair_class, hiding);
                } else {
                    return pair_class == PairClass::adjacent ? T::info.integrands.adjacent : T::info.integrands.apart;
                }
            },
            .finite_variance = T::finite_variance,
            .largest_unmet = T::largest_unmet,
            .make = [](const Scene& scene, TracerChoice tracer) -> std::unique_ptr<Estimator> {
                return std::make_unique<ErasedEstimator<T>>(scene, tracer);
            }};
}

}  // namespace ff
