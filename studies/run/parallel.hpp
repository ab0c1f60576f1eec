#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string_view>

namespace ff::studies {

/// Calls `task(i)` for i = 0 .. times - 1 on several threads. @throws what a task threw first; UserError where the
/// system starts fewer threads
void for_each_index(std::uint64_t times, unsigned threads, const std::function<void(std::uint64_t)>& task);

/// A share of a study's work units, number `index` (from 1) of `count`. Units are dealt out in turn, so that every
/// shard gets its share of long and short ones.
struct Shard {
    std::uint64_t index = 1;
    std::uint64_t count = 1;

    [[nodiscard]] bool holds(std::size_t unit) const { return unit % count == index - 1; }
    [[nodiscard]] bool is_whole() const { return count == 1; }
};

/// Reads "i/n", 1 <= i <= n. @throws UserError
Shard parse_shard(std::string_view text);

}  // namespace ff::studies
