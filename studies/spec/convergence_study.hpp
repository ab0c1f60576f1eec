#pragma once

#include "studies/spec/spec.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace ff::studies {

/// A request to `ffstudy convergence`: every sampler with one estimator, on the same ladder of sizes; 64 trials and
/// seed 1 unless the command line says otherwise.
struct ConvergenceRequest {
    std::vector<std::string> scenes{"cube"};
    std::vector<std::string> samplers;
    std::string estimator = "ray_shooting";
    std::string samples_per_patch = "2^6..2^16";  ///< written as in a study file
    std::uint32_t patches_per_face = 1;
    std::optional<std::string> allocation;  ///< empty: a study file's default
    std::optional<std::string> completion;
    std::optional<std::string> map;
};

/// @throws UserError that names the key, which is the option's name, but no place
StudySpec make_convergence_study(const ConvergenceRequest& request);

/// The command that requests this study; options that every run has can be appended.
std::string convergence_command(const ConvergenceRequest& request);

}  // namespace ff::studies
