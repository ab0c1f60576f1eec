// A plug-in in C++ that throws, as it must not.
#include <ffstudy/plugin.h>

#include <cstdint>
#include <stdexcept>
#include <string>

namespace {

int fill(double* /*points*/, std::uint64_t /*n*/, std::uint32_t /*d*/, std::uint64_t /*seed*/, std::uint32_t trial) {
    throw std::runtime_error("thrown in trial " + std::to_string(trial));
}

const ffstudy_sampler sampler{"thrower", nullptr, nullptr, 4, 0, 0, fill, nullptr, nullptr};
const ffstudy_plugin plugin{FFSTUDY_PLUGIN_VERSION, 1, &sampler};

}  // namespace

const ffstudy_plugin* ffstudy_samplers() {
    return &plugin;
}
