#include "app/commands/context/program_context.hpp"

#include "app/build_info.hpp"

#include <fmt/chrono.h>
#include <fmt/format.h>
#include <sys/utsname.h>

#include <chrono>
#include <fstream>

namespace ff::app {
namespace {

std::string processor() {
    std::ifstream info("/proc/cpuinfo");
    for (std::string line; std::getline(info, line);) {
        if (line.rfind("model name", 0) != 0) continue;
        const auto colon = line.find(": ");
        if (colon != std::string::npos) return line.substr(colon + 2);
    }
    return "unknown";
}

}  // namespace

std::map<std::string, std::string> describe_program(const std::string& command, unsigned threads, double seconds) {
    utsname host{};
    const bool known = ::uname(&host) == 0;
    return {
        {"command", command},
        {"compiler", std::string(build_info::compiler)},
        {"build_type", std::string(build_info::build_type)},
        {"flags", std::string(build_info::flags)},
        {"date_utc", fmt::format("{:%Y-%m-%dT%H:%M:%SZ}",
                                 fmt::gmtime(std::chrono::system_clock::to_time_t(std::chrono::system_clock::now())))},
        {"host", known ? host.nodename : "unknown"},
        {"operating_system", known ? fmt::format("{} {} {}", host.sysname, host.release, host.machine) : "unknown"},
        {"processor", processor()},
        {"revision", std::string(build_info::revision)},
        {"seconds", fmt::format("{:.2f}", seconds)},
        {"threads", std::to_string(threads)},
        {"version", std::string(build_info::version)}};
}

}  // namespace ff::app
