#include "studies/spec/spec.hpp"

#include "studies/readers/printable.hpp"

#include <fmt/format.h>

namespace ff::studies {

std::string to_toml(const StudySpec& spec) {
    std::vector<std::string> scenes;
    for (const SceneSource& scene : spec.scenes) scenes.push_back(toml_text(scene.written()));
    std::string out =
        fmt::format("[study]\nname = {}\ntitle = {}\nscene = [{}]\ntrials = {}\nseed = {}\nlevel = {}\npower = {}\n",
                    toml_text(spec.name), toml_text(spec.title), fmt::join(scenes, ", "), spec.trials, spec.seed.value,
                    spec.level, spec.power);
    if (spec.equivalence_margin) out += fmt::format("equivalence_margin = {}\n", *spec.equivalence_margin);
    if (spec.inapplicable == Inapplicable::skip) out += "inapplicable = \"skip\"\n";
    for (const Method& method : spec.methods) {
        const EstimatorInfo& estimator = estimator_info(method);
        out += fmt::format("\n[[method]]\nname = {}\n", toml_text(method.name));
        if (!method.sampler.empty()) out += fmt::format("sampler = {}\n", toml_text(method.sampler));
        out += fmt::format("estimator = \"{}\"\ncompletion = \"{}\"\n", method.estimator, name(method.completion));
        if (estimator.has_allocation()) out += fmt::format("allocation = \"{}\"\n", name(method.allocation));
        if (estimator.has_tracer) out += fmt::format("tracer = \"{}\"\n", name(method.tracer));
        if (method.claimed_error) out += fmt::format("claimed_error = {}\n", *method.claimed_error);
        if (method.claimed_level) out += fmt::format("claimed_level = {}\n", *method.claimed_level);
        if (method.map != PointMap::uniform) out += fmt::format("map = \"{}\"\n", name(method.map));
        if (method.nodes) {
            const auto [source, target] = *method.nodes;
            out +=
                target == 0 ? fmt::format("nodes = {}\n", source) : fmt::format("nodes = [{}, {}]\n", source, target);
        }
        out += "sizes = [\n";
        for (const Size& size : method.sizes) {
            out += fmt::format("    {{ patches_per_face = {}", size.patches_per_face);
            if (size.samples_per_patch) out += fmt::format(", samples_per_patch = {}", *size.samples_per_patch);
            if (size.trials) out += fmt::format(", trials = {}", *size.trials);
            out += " },\n";
        }
        out += "]\n";
    }
    if (spec.until) out += to_toml(*spec.until);
    if (!spec.coverage.empty()) out += fmt::format("\n[coverage]\nreplicates = [{}]\n", fmt::join(spec.coverage, ", "));
    if (spec.radiosity) out += to_toml(*spec.radiosity);
    if (spec.published) out += fmt::format("\n[published]\ntables = {}\n", toml_text(spec.published->file));
    return out;
}

}  // namespace ff::studies
