#pragma once

#include <cstddef>
#include <cstdint>

/// What a fuzzer does with one input; libFuzzer and replay.cpp call it.
// NOLINTNEXTLINE(readability-identifier-naming): libFuzzer's name
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);
