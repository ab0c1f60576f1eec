#include "core/estimators/added.hpp"

#include "core/estimators/entry.hpp"
#include "core/support/error.hpp"

#include <map>
#include <utility>

namespace ff {
namespace {

/// Only ever grows, so references into it stay valid.
struct Registry {
    std::mutex mutex;
    std::map<std::string, std::unique_ptr<AddedEstimator>, std::less<>> estimators;
    std::map<std::string, const AddedEstimator*, std::less<>> short_names;
};

Registry& registry() {
    static Registry all;
    return all;
}

}  // namespace

AddedEstimator::AddedEstimator(Texts texts, EstimatorInfo traits, Refusal refusal, Make make)
    : texts_(std::move(texts)), refusal_(std::move(refusal)), make_(std::move(make)), entry_{} {
    entry_.info = traits;
    entry_.info.name = texts_.name;
    entry_.info.summary = texts_.summary;
    entry_.info.details = texts_.details;
    entry_.refusal = [this](const EstimatorOptions& /*options*/, const Scene& scene) {
        std::string general = refusal_of(entry_.info, scene);
        const std::lock_guard lock(mutex_);
        return general.empty() && refusal_ ? refusal_(scene) : general;
    };
    entry_.size_problem = [](std::uint64_t samples) { return std::string(samples == 0 ? "(none). Try 1024." : ""); };
    // Earlier stores have no price of a trial: their units of work were cut by this one of an evaluation.
    entry_.nanoseconds = [](const EstimatorOptions&, const Scene&) { return 1e3; };
    entry_.integrand = [](const EstimatorOptions&, PairClass, Hiding) { return std::optional<Integrand>(); };
    entry_.finite_variance = [](const EstimatorOptions&, const Scene&, int, int) { return true; };
    entry_.largest_unmet = [](const Scene&, int, int, double) { return 0.0; };
    entry_.make = [this](const Scene& scene, TracerChoice /*tracer*/) {
        Make known;
        {
            const std::lock_guard lock(mutex_);
            known = make_;
        }
        if (!known)
            throw UserError(
                "estimator \"{}\" (only its results are here, not the program). Name the program, as when "
                "the study was run.",
                texts_.name);
        return known(scene);
    };
}

void AddedEstimator::learn_from(AddedEstimator& other) {
    const std::lock_guard lock(mutex_);
    if (make_) return;
    make_ = std::move(other.make_);
    refusal_ = std::move(other.refusal_);
}

EstimatorInfo program_traits(bool has_sizes, bool randomised, double nanoseconds) {
    return {.name = {},
            .summary = {},
            .details = {},
            .reference = {},
            .own_points = has_sizes,
            .randomised = randomised,
            .whole_faces = true,
            .sees_occluders = true,
            .evaluations = "samples",
            .nanoseconds = nanoseconds};
}

const EstimatorEntry& add(std::unique_ptr<AddedEstimator> estimator, const std::string& short_name) {
    const std::string name(estimator->entry().info.name);
    for (const EstimatorEntry& known : estimators()) {
        if (known.info.name == name || known.info.name == short_name)
            throw UserError("estimator \"{}\" (there is one of this name already). Rename it.", known.info.name);
    }
    Registry& all = registry();
    const std::lock_guard lock(all.mutex);
    const auto [at, is_new] = all.estimators.try_emplace(name);
    if (is_new)
        at->second = std::move(estimator);
    else
        at->second->learn_from(*estimator);
    if (!short_name.empty()) all.short_names[short_name] = at->second.get();
    return at->second->entry();
}

const AddedEstimator* find_added_estimator(std::string_view name) {
    Registry& all = registry();
    const std::lock_guard lock(all.mutex);
    if (const auto found = all.estimators.find(name); found != all.estimators.end()) return found->second.get();
    const auto found = all.short_names.find(name);
    return found == all.short_names.end() ? nullptr : found->second;
}

}  // namespace ff
