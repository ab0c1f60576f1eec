#pragma once

#include <chrono>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <thread>

namespace ff::app {

/// Reads "90", "90s", "15m", "2.5h" or "1d". @throws UserError
std::chrono::duration<double> parse_duration(std::string_view text);

/// Reads "500M" or "2G" (powers of 1024; also k and T; without a letter, bytes) as bytes. @throws UserError
std::uint64_t parse_size(std::string_view text);

/// "1.5 GiB"
std::string size_in_words(std::uint64_t bytes);

/// Memory of this process that is in use at the moment, in bytes; empty where the system does not tell.
std::optional<std::uint64_t> resident_memory();

/// Asks for an orderly end (app/process/signals.hpp) when a time is over, unless it ends before.
class TimeLimit {
  public:
    explicit TimeLimit(std::optional<std::chrono::duration<double>> limit);

  private:
    std::jthread clock_;
};

}  // namespace ff::app
