#include "benchmarks/fill_sets.hpp"

#include "studies/outside/outside_code.hpp"

#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

// Time per 4-D point of samplers from outside, beside the same sequence built in.

namespace {

using namespace ff;

/// Points for a file, and for a program to print, in the raw form.
std::filesystem::path raw_file(std::uint64_t points) {
    const auto file = std::filesystem::temp_directory_path() / ("ffstudy_benchmark_" + std::to_string(points) + ".bin");
    std::vector<double> numbers(points * 4);
    for (std::size_t i = 0; i < numbers.size(); ++i) numbers[i] = static_cast<double>(i % 1000) / 1000;
    std::ofstream out(file, std::ios::binary);
    const std::uint64_t sizes[2] = {points, 4};
    out.write("FFPOINTS", 8);
    out.write(reinterpret_cast<const char*>(sizes), sizeof sizes);
    out.write(reinterpret_cast<const char*>(numbers.data()),
              static_cast<std::streamsize>(numbers.size() * sizeof(double)));
    return file;
}

void outside(benchmark::State& state, const std::string& name) {
    const auto points = static_cast<std::uint64_t>(state.range(0));
    studies::load_plugin(FF_BENCHMARK_PLUGIN);
    std::string sampler = name;
    if (name == "file") sampler = "file:" + raw_file(points).string();
    if (name == "command") sampler = "command:cat " + raw_file(points).string();
    const auto source = studies::sampler_of_user(sampler).make({.points = points});
    fill_sets<PointBlock>(state, *source);
}

BENCHMARK_CAPTURE(outside, built_in, std::string("r_sequence"))->Arg(4096)->Arg(1 << 16)->Arg(1 << 20)->UseRealTime();
BENCHMARK_CAPTURE(outside, plugin_parts, std::string("r_parts"))->Arg(4096)->Arg(1 << 16)->Arg(1 << 20)->UseRealTime();
BENCHMARK_CAPTURE(outside, plugin_whole, std::string("r_whole"))->Arg(4096)->Arg(1 << 16)->Arg(1 << 20)->UseRealTime();
BENCHMARK_CAPTURE(outside, file, std::string("file"))->Arg(4096)->Arg(1 << 16)->Arg(1 << 20)->UseRealTime();
BENCHMARK_CAPTURE(outside, command, std::string("command"))->Arg(4096)->Arg(1 << 16)->Arg(1 << 20)->UseRealTime();

}  // namespace
