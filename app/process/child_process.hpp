#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace ff::app {

/// Where a program lies on PATH; empty where it does not.
std::filesystem::path find_program(std::string_view name);

/// Runs a program and waits for it; what it says goes to stderr.
/// @throws IoError unless it ends with exit code 0
void run_program(const std::filesystem::path& program, const std::vector<std::string>& arguments);

}  // namespace ff::app
