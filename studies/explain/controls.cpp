#include "studies/explain/controls.hpp"

#include "samplers/sampler.hpp"

namespace ff::studies {
namespace {

constexpr Description leaky{
    "leaky", "loses the rays that end within 1e-4 of an edge of the surface they hit",
    "tracer = \"leaky\" with estimator = \"ray_shooting\". Rays are traced as usual, but those that end closer to an "
    "edge "
    "than\n1e-4 of the surface's extent are lost, as with meshes that are not watertight or hits that are tested with "
    "an\nepsilon. In a cube one ray in 2000 is lost: less than the noise of most runs.\n"
    "Caught by: a gate on lost rays, and one on closure.",
    ""};

constexpr Description adjacent_kernel{
    "adjacent_kernel", "the area kernel with random points between faces that touch: infinite variance",
    "sampler = \"random\", estimator = \"area_kernel\", on adjacent pairs. The kernel grows without bound where faces "
    "touch:\nthe mean is right, the variance infinite (tail index 3/2), and sample variances and t intervals mean "
    "nothing.\nCaught by: theory, for the program's own runs (the gate is refused), and by the tail index, for "
    "estimates "
    "that\nothers bring.",
    "pederson1997"};

}  // namespace

std::vector<Control> controls() {
    std::vector<Control> all;
    for (const auto& sampler : samplers::controls()) {
        const auto& info = sampler.info;
        all.push_back({"sampler", {info.name, info.summary, info.details, info.reference}});
    }
    all.push_back({"tracer", leaky});
    all.push_back({"combination", adjacent_kernel});
    return all;
}

}  // namespace ff::studies
