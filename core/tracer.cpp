#include "core/tracer.hpp"

#include "core/error.hpp"
#include "core/leaky_tracer.hpp"
#include "core/mirror_tracer.hpp"
#include "core/mirrors.hpp"

#include <utility>

namespace ff {

namespace {

std::unique_ptr<Tracer> make_straight_tracer(const Scene& scene, TracerChoice choice) {
    if (choice == TracerChoice::box && !scene.empty_box) {
        throw UserError("tracer: the box tracer cannot do scene '" + scene.name +
                        "' (it knows only the inside of an empty box). Choose embree or automatic.");
    }
    return scene.empty_box && choice != TracerChoice::embree ? make_box_tracer(scene) : make_embree_tracer(scene);
}

}  // namespace

std::unique_ptr<Tracer> make_tracer(const Scene& scene, TracerChoice choice) {
    if (choice == TracerChoice::leaky) return make_leaky_tracer(scene);
    auto tracer = make_straight_tracer(scene, choice);
    return mirrors(scene).empty() ? std::move(tracer) : make_mirror_tracer(scene, std::move(tracer));
}

}  // namespace ff
