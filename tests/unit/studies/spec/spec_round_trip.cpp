// A spec written as a study file and read again is the same spec, whatever it says.

#include "samplers/sampler.hpp"
#include "studies/spec/spec.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <set>
#include <string>

namespace ff::studies {
namespace {

/// Any text that TOML can hold: quotes, backslashes, control characters and letters beyond ASCII.
rc::Gen<std::string> any_text() {
    const auto piece = rc::gen::oneOf(
        rc::gen::map(rc::gen::inRange(1, 128), [](int c) { return std::string(1, static_cast<char>(c)); }),
        rc::gen::element<std::string>("\"", "\\", "Σ", "é", "]", "#", "\n", "\x7f", "€", "𝛴"));
    const auto join = [](const std::vector<std::string>& pieces) {
        std::string text;
        for (const std::string& p : pieces) text += p;
        return text;
    };
    return rc::gen::nonEmpty(rc::gen::map(rc::gen::container<std::vector<std::string>>(piece), join));
}

/// A text that may name or entitle a study or a method: printable, and no path.
rc::Gen<std::string> any_name() {
    return rc::gen::map(any_text(), [](const std::string& text) {
        std::string name = "n";
        for (const char c : text) {
            if (static_cast<unsigned char>(c) >= 0x20 && c != 0x7f && c != '|' && c != '/') name += c;
        }
        return name;
    });
}

/// 2 .. max, small numbers more often.
rc::Gen<std::uint64_t> at_least_two(std::uint64_t max) {
    return rc::gen::oneOf(rc::gen::inRange<std::uint64_t>(2, 100), rc::gen::inRange<std::uint64_t>(2, max + 1));
}

/// A number in (0, 1), with all bits of a double.
double any_fraction() {
    return static_cast<double>(*rc::gen::inRange<std::uint64_t>(1, 1ULL << 53)) * 0x1p-53;
}

std::vector<Size> any_sizes(bool sampled) {
    std::vector<Size> sizes;
    for (std::uint32_t m = 1; m <= *rc::gen::inRange<std::uint32_t>(1, 4); ++m) {
        Size size{m * m, std::nullopt, std::nullopt};
        if (sampled) size.samples_per_patch = *at_least_two(1ULL << 20);
        if (*rc::gen::arbitrary<bool>()) size.trials = *at_least_two(1ULL << 32);
        sizes.push_back(size);
    }
    return sizes;
}

/// The least size that an estimator with points of its own takes, from `least` on.
std::uint64_t fitting_size(const EstimatorEntry& estimator, std::uint64_t least) {
    while (!estimator.size_problem(least).empty()) ++least;
    return least;
}

Method any_method(std::string name) {
    Method method;
    method.name = std::move(name);
    method.estimator = estimators()[*rc::gen::inRange<std::size_t>(0, estimators().size())].info.name;
    const EstimatorInfo& estimator = estimator_info(method);
    method.completion = *rc::gen::element(Completion::direct, Completion::reciprocal);
    if (*rc::gen::arbitrary<bool>()) method.claimed_error = any_fraction();
    if (*rc::gen::arbitrary<bool>()) method.claimed_level = any_fraction();
    if (!estimator.takes_points()) {
        method.sizes = any_sizes(false);
        for (Size& size : method.sizes) {
            if (estimator.own_points) size.samples_per_patch = fitting_size(find_estimator(method.estimator), 100);
        }
        method.tracer = estimator.has_tracer ? TracerChoice::embree : TracerChoice::automatic;
        return method;
    }
    const bool quadrature = estimator.observes != Observes::hits && *rc::gen::arbitrary<bool>();
    for (const auto& entry : samplers::catalogue()) {
        const bool fits =
            quadrature ? entry.info.sizes == samplers::Sizes::nodes : entry.info.sizes == samplers::Sizes::any;
        if (fits) method.sampler = entry.info.name;
    }
    if (quadrature) {
        const bool pairs = estimator.dimension == 4;
        method.nodes = Nodes{*rc::gen::inRange(1u, 65u), pairs ? *rc::gen::inRange(1u, 65u) : 0};
    }
    if (estimator.has_allocation() && !quadrature)
        method.allocation = *rc::gen::element(Allocation::patch, Allocation::face);
    if (estimator.has_tracer) {
        method.tracer =
            *rc::gen::element(TracerChoice::automatic, TracerChoice::box, TracerChoice::embree, TracerChoice::leaky);
    }
    if (estimator.has_map) method.map = *rc::gen::element(PointMap::uniform, PointMap::graded);
    method.sizes = any_sizes(!quadrature);
    if (estimator.whole_faces) method.sizes.resize(1);
    return method;
}

StudySpec any_spec() {
    StudySpec spec;
    spec.name = *any_name();
    spec.title = *any_name();
    const SceneSource cube = scene_source("cube");
    spec.scenes = *rc::gen::elementOf(std::vector<std::vector<SceneSource>>{
        {cube}, {scene_source("box:2x1x0.5")}, {scene_source("box:1e-3x7x2 mirrors:6"), cube}});
    spec.trials = *at_least_two(1ULL << 32);
    spec.seed = Seed{*rc::gen::inRange<std::uint64_t>(0, 1ULL << 63)};
    spec.level = 0.501 + 0.498 * any_fraction();
    spec.power = 0.5 + 0.499 * any_fraction();
    if (*rc::gen::arbitrary<bool>()) spec.equivalence_margin = any_fraction();
    const auto names = *rc::gen::nonEmpty(rc::gen::container<std::set<std::string>>(any_name()));
    for (const std::string& name : names) spec.methods.push_back(any_method(name));
    if (*rc::gen::arbitrary<bool>()) {
        spec.radiosity =
            RadiosityRequest{{{any_fraction()}, {any_fraction(), 0.25}}, {}, 1e-13 + any_fraction() / 2, 3, 0};
        if (*rc::gen::arbitrary<bool>()) spec.radiosity->emission = {any_fraction(), 1.5};
        spec.radiosity->patch_trials = *rc::gen::inRange<std::uint64_t>(0, 9);
    }
    if (*rc::gen::arbitrary<bool>()) spec.published = Published{*any_text(), {}};
    return spec;
}

RC_GTEST_PROP(SpecAsToml, ReadsBackAsTheSameSpec, ()) {
    const StudySpec spec = any_spec();
    const std::string text = to_toml(spec);
    const StudySpec again = parse_study(text, "study.toml");
    RC_ASSERT(again == spec);
    RC_ASSERT(to_toml(again) == text);
}

}  // namespace
}  // namespace ff::studies
