#include "benchmarks/fill_sets.hpp"

#include <string>

// Time per 4-D point of every sampler, in the sizes that matter: one short stream a patch, or one long stream a face.

namespace {

using namespace ff;

void register_sampler(const samplers::CatalogueEntry& sampler, std::uint64_t points) {
    [[maybe_unused]] const samplers::PointSetSpec spec{.points = points, .source_nodes = 5, .target_nodes = 5};
    const std::string name = "samplers/" + std::string(sampler.info.name) + "/" + std::to_string(points);
#ifndef __clang_analyzer__  // it does not see that the library keeps what is registered
    benchmark::RegisterBenchmark(name.c_str(), [&sampler, spec](benchmark::State& state) {
        const auto source = sampler.make(spec);
        if (sampler.info.equal_weights) {
            fill_sets<PointBlock>(state, *source);
        } else {
            fill_sets<WeightedBlock>(state, *source);
        }
    });
#endif
}

const bool registered = [] {
    for (const samplers::CatalogueEntry& sampler : samplers::catalogue()) {
        register_sampler(sampler, 625);
        if (sampler.info.sizes != samplers::Sizes::nodes) register_sampler(sampler, 65536);
    }
    return true;
}();

}  // namespace
