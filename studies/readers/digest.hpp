#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace ff::studies {

/// A checksum: any single changed word changes it, and other differences go unnoticed with probability 2^-64. It does
/// not protect against intent.
class Digest {
  public:
    Digest& add(std::uint64_t word);
    Digest& add(std::string_view text);
    Digest& add(std::span<const std::uint64_t> words);
    /// Adds a number as SQLite keeps it in a NUMERIC column: whole numbers of different types are equal, and so are
    /// zeros.
    Digest& add_number(double value);
    [[nodiscard]] std::uint64_t value() const { return state_; }

  private:
    std::uint64_t state_ = 0x9e3779b97f4a7c15;
};

/// The checksum as text, for tables of keys and values.
std::string in_hexadecimal(const Digest& digest);

}  // namespace ff::studies
