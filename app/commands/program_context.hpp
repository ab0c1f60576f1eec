#pragma once

#include <map>
#include <string>

namespace ff::app {

/// Who computes, where and when; for context.json.
std::map<std::string, std::string> describe_program(const std::string& command, unsigned threads, double seconds);

}  // namespace ff::app
