#pragma once

#include "studies/plan/plan.hpp"
#include "studies/store/store.hpp"

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace ff::test {

/// An empty folder, removed with everything in it.
class TemporaryFolder {
  public:
    TemporaryFolder();
    ~TemporaryFolder();
    TemporaryFolder(const TemporaryFolder&) = delete;
    TemporaryFolder& operator=(const TemporaryFolder&) = delete;

    [[nodiscard]] const std::filesystem::path& path() const { return path_; }

  private:
    std::filesystem::path path_;
};

/// A store without a file.
inline constexpr const char* in_memory = ":memory:";

/// "[study]" with the cube, a seed and these lines, then `methods`.
std::string study_text(std::string_view lines, std::string_view methods);

/// A method of independent rays, the simplest there is, as a study file has it.
inline constexpr std::string_view random_rays = R"([[method]]
name = "SR"
sampler = "random"
estimator = "ray_shooting"
samples_per_patch = 10
)";

/// The message of the exception of type Error that `action` throws.
template <typename Error, typename Action>
std::string message_of(Action action) {
    try {
        action();
    } catch (const Error& error) {
        return error.what();
    }
    return "nothing thrown";
}

/// The plan of a study file.
studies::StudyPlan plan_of(std::string_view text);

/// The plan of a study file, in a scene of this text (TOML).
studies::StudyPlan plan_in(std::string_view scene, std::string_view text);

/// Runs a plan from its beginning, or from where the file stopped.
studies::Store run(const studies::StudyPlan& plan, const std::filesystem::path& file = in_memory, unsigned threads = 1);

/// A made-up direct estimate of a trial; faces count from 1. Hits are rounded to whole numbers.
using Estimate = std::function<double(std::size_t cell, std::uint64_t trial, int from, int to)>;

/// A complete store with made-up observations.
studies::Store fill(const studies::StudyPlan& plan, const Estimate& estimate);

/// Every row of the tables that results are made from, as text, in the order of their keys.
std::vector<std::string> rows_of(const std::filesystem::path& file);

}  // namespace ff::test
