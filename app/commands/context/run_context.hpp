#pragma once

#include "app/commands/context/program_context.hpp"

#include "core/tracing/tracer.hpp"

namespace ff::app {

/// Circumstances of a run: program, compiler, host, processor, command, date. None of them affects a result.
inline std::map<std::string, std::string> describe_run(const std::string& command, unsigned threads, double seconds) {
    auto context = describe_program(command, threads, seconds);
    context["tracer"] = tracer_version();
    return context;
}

}  // namespace ff::app
