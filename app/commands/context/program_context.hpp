#pragma once

#include <map>
#include <string>

namespace ff::app {

/// Program, machine and time; for context.json.
std::map<std::string, std::string> describe_program(const std::string& command, unsigned threads, double seconds);

}  // namespace ff::app
