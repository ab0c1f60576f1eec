#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace ff::app {

/// The path of a program on PATH; empty where there is none.
std::filesystem::path find_program(std::string_view name);

/// Runs a program and waits for it; its output goes to stderr.
/// @param meanwhile  called about ten times a second; may be empty
/// @throws IoError unless it ends with exit code 0
void run_program(const std::filesystem::path& program, const std::vector<std::string>& arguments,
                 const std::function<void()>& meanwhile = {});

}  // namespace ff::app
