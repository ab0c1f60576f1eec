#pragma once

#include "studies/store/store.hpp"

#include <string>

namespace ff::app {

/// Circumstances of a run: program, compiler, host, processor, command, date. None of them affects a result.
studies::Context describe_run(const std::string& command, unsigned threads, double seconds);

}  // namespace ff::app
