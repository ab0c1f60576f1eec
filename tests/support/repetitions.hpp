#pragma once

#include <cstdint>
#include <cstdlib>

namespace ff::test {

/// How often a test repeats what it does: `usual` times on every push, `nightly` times where FFSTUDY_LONG is set, as
/// `scripts/test --nightly statistics` sets it. The test states both risks for both.
inline std::uint64_t repetitions(std::uint64_t usual, std::uint64_t nightly) {
    // Nothing sets variables while tests run. NOLINTNEXTLINE(concurrency-mt-unsafe)
    return std::getenv("FFSTUDY_LONG") != nullptr ? nightly : usual;
}

}  // namespace ff::test
