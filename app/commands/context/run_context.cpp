#include "app/commands/context/run_context.hpp"

#include "app/commands/context/program_context.hpp"

#include "core/tracing/tracer_version.hpp"

namespace ff::app {

studies::Context describe_run(const std::string& command, unsigned threads, double seconds) {
    studies::Context context = describe_program(command, threads, seconds);
    context["tracer"] = tracer_version();
    return context;
}

}  // namespace ff::app
