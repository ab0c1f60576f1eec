#pragma once

#include <cstdint>
#include <functional>

namespace ff::studies {

/// Calls `task(i)` for i = 0 .. times - 1 on several threads. @throws what a task threw first; UserError where the
/// system starts fewer threads
void for_each_index(std::uint64_t times, unsigned threads, const std::function<void(std::uint64_t)>& task);

}  // namespace ff::studies
