#include "studies/spec/convergence_study.hpp"

#include "core/support/error.hpp"
#include "samplers/sampler.hpp"
#include "studies/outside/outside_code.hpp"
#include "studies/readers/printable.hpp"

#include <fmt/format.h>

#include <string_view>

namespace ff::studies {
namespace {

constexpr std::string_view convergence_origin = "convergence";

std::string quoted_list(const std::vector<std::string>& texts) {
    std::vector<std::string> quoted;
    for (const std::string& text : texts) quoted.push_back(toml_text(text));
    return fmt::format("[{}]", fmt::join(quoted, ", "));
}

/// "convergence:7:1: problem" without its place: nobody has seen that file.
std::string without_place(std::string_view message) {
    const std::size_t colon = message.find(": ");
    return std::string(message.starts_with(convergence_origin) && colon != std::string_view::npos
                           ? message.substr(colon + 2)
                           : message);
}

std::string study_text(const ConvergenceRequest& request) {
    std::string out = fmt::format(
        "[study]\nname = \"convergence\"\ntitle = {}\nscene = {}\ntrials = 64\nseed = 1\n",
        toml_text(fmt::format("Convergence of {} on {}", request.estimator, fmt::join(request.scenes, ", "))),
        quoted_list(request.scenes));
    for (const std::string& sampler : request.samplers) {
        out += fmt::format("\n[[method]]\nname = {}\nsampler = {}\nestimator = {}\n", toml_text(sampler),
                           toml_text(sampler), toml_text(request.estimator));
        if (request.allocation) out += fmt::format("allocation = {}\n", toml_text(*request.allocation));
        if (request.completion) out += fmt::format("completion = {}\n", toml_text(*request.completion));
        if (request.map) out += fmt::format("map = {}\n", toml_text(*request.map));
        out += fmt::format("patches_per_face = {}\nsamples_per_patch = {}\n", request.patches_per_face,
                           toml_text(request.samples_per_patch));
    }
    return out;
}

}  // namespace

StudySpec make_convergence_study(const ConvergenceRequest& request) {
    for (const std::string& sampler : request.samplers) {
        if (sampler_of_user(sampler).info.sizes != samplers::Sizes::nodes) continue;
        throw UserError(
            "sampler {} (it has nodes instead of sizes, and runs once). "
            "Write a study file with patches_per_face = [4, 16, 64].",
            sampler);
    }
    try {
        return parse_study(study_text(request), convergence_origin);
    } catch (const UserError& error) {
        throw UserError(without_place(error.what()));
    }
}

std::string convergence_command(const ConvergenceRequest& request) {
    std::string out =
        fmt::format("ffstudy convergence --scene {} --sampler {} --estimator {} --samples {} --patches {}",
                    fmt::join(request.scenes, ","), fmt::join(request.samplers, ","), request.estimator,
                    request.samples_per_patch, request.patches_per_face);
    if (request.allocation) out += fmt::format(" --allocation {}", *request.allocation);
    if (request.completion) out += fmt::format(" --completion {}", *request.completion);
    if (request.map) out += fmt::format(" --map {}", *request.map);
    return out;
}

}  // namespace ff::studies
