#pragma once

#include "app/command_line/outside_options.hpp"
#include "app/process/exit_code.hpp"

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace ff::app {

/// Options of `ffstudy points`.
struct PointsCommand {
    std::string sampler;
    std::uint64_t points = 1024;
    std::size_t dimension = 4;
    std::uint64_t seed = 1;
    std::uint32_t trial = 0;
    OutsideOptions outside;
    std::filesystem::path out;  ///< empty: print properties of the set
};

/// Options of `ffstudy check-sampler`.
struct CheckSamplerCommand {
    std::string sampler;
    std::optional<std::uint64_t> points;
    std::optional<std::size_t> dimension;
    std::optional<std::uint64_t> trials;
    std::uint64_t seed = 1;
    std::vector<std::string> promises;  ///< structure that every set has, each as "net:2"
    OutsideOptions outside;
};

/// Writes a point set as .npy, .csv, .dat or .svg, or prints its evenness.
ExitCode points(const PointsCommand& command);

/// Checks a sampler against the contract: failed where it breaks it or a promise, inconclusive where trials are too
/// few, or where its points are nearly a structure.
ExitCode check_sampler(const CheckSamplerCommand& command);

}  // namespace ff::app
