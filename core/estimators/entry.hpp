#pragma once

#include "core/estimators/estimator.hpp"

namespace ff {

/// The one way to make an estimator: a class with
///
///     static constexpr EstimatorInfo info{...};
///     T(const Scene&, TracerChoice);                                  // refusal() has been asked
///     void observe(const EstimatorTask&, Outcome&, PatchTotals&) const;
///
/// and optionally
///
///     static std::string refusal(const EstimatorOptions&, const Scene&);   // beyond what follows from `info`
///     static std::string size_problem(std::uint64_t samples); // required if own_points
///     static double nanoseconds(const EstimatorOptions&, const Scene&);    // in place of what `info` says
///     static std::optional<Integrand> integrand(const EstimatorOptions&, PairClass, Hiding);    // likewise
///     static bool finite_variance(const EstimatorOptions&, const Scene&, int from, int to);
///     static double largest_unmet(const Scene&, int from, int to, double evaluations);
///
/// `estimator_entry<T>()` turns it into a line of the catalogue.
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

/// What follows from `info`: an estimator that sees no occluders, or no mirrors, is refused where there may be some.
std::string refusal_of(const EstimatorInfo& info, const Scene& scene);

/// The catalogue's line for estimator T.
template <class T>
EstimatorEntry estimator_entry() {
    return {.info = T::info,
            .refusal = [](const EstimatorOptions& options, const Scene& scene) -> std::string {
                std::string general = refusal_of(T::info, scene);
                if constexpr (requires { T::refusal(options, scene); }) {
                    return general.empty() ? T::refusal(options, scene) : general;
                } else {
                    return general;
                }
            },
            .size_problem = [](std::uint64_t samples) -> std::string {
                if constexpr (T::info.own_points) {
                    return T::size_problem(samples);
                } else {
                    return {};
                }
            },
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
            .finite_variance =
                [](const EstimatorOptions& options, const Scene& scene, int from, int to) {
                    if constexpr (requires { T::finite_variance(options, scene, from, to); }) {
                        return T::finite_variance(options, scene, from, to);
                    } else {
                        return true;
                    }
                },
            .largest_unmet =
                [](const Scene& scene, int from, int to, double evaluations) {
                    if constexpr (requires { T::largest_unmet(scene, from, to, evaluations); }) {
                        return T::largest_unmet(scene, from, to, evaluations);
                    } else {
                        return 0.0;
                    }
                },
            .make = [](const Scene& scene, TracerChoice tracer) -> std::unique_ptr<Estimator> {
                return std::make_unique<ErasedEstimator<T>>(scene, tracer);
            }};
}

}  // namespace ff
