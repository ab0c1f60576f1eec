#pragma once

#include <chrono>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <thread>

namespace ff::app {

/// Reads "90", "90s", "15m", "2.5h" or "1d"; empty where no text is given. @param option  option, for messages
/// @throws UserError
std::optional<std::chrono::duration<double>> parse_duration(const std::optional<std::string>& text,
                                                            std::string_view option = "--max-time");

/// Reads "500M" or "2G" (powers of 1024; also k and T; without a letter, bytes) as bytes; empty where no text is given.
/// @throws UserError
std::optional<std::uint64_t> parse_size(const std::optional<std::string>& text);

/// "1.5 GiB"
std::string size_in_words(std::uint64_t bytes);

/// Memory currently used by this process, in bytes; empty where the system does not tell.
std::optional<std::uint64_t> resident_memory();

/// During its lifetime, asks for an orderly end when a time is over, and, with a message, when this process exceeds a
/// limit of bytes. Without that limit, it does so when the process has taken most of the machine's memory and hardly
/// any is left, before the system kills it.
class Limits {
  public:
    Limits(std::optional<std::chrono::duration<double>> time, std::optional<std::uint64_t> memory);

  private:
    std::jthread clock_;
    std::jthread watch_;
};

}  // namespace ff::app
