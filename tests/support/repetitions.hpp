#pragma once

#include <cstdint>
#include <cstdlib>

namespace ff::test {

/// Whether FFSTUDY_LONG is set, as `scripts/test --nightly statistics` sets it.
inline bool is_nightly() {
    // Nothing sets variables while tests run. NOLINTNEXTLINE(concurrency-mt-unsafe)
    return std::getenv("FFSTUDY_LONG") != nullptr;
}

/// How often a test repeats what it does: on every push and nightly. The test states both risks for both.
inline std::uint64_t repetitions(std::uint64_t usual, std::uint64_t nightly) {
    return is_nightly() ? nightly : usual;
}

}  // namespace ff::test
