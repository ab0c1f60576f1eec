#include "core/tracer.hpp"

#include "core/error.hpp"
#include "core/leaky_tracer.hpp"

namespace ff {

std::unique_ptr<Tracer> make_tracer(const Scene& scene, TracerChoice choice) {
    switch (choice) {
        case TracerChoice::box:
            if (!scene.empty_box) {
                throw UserError("tracer: the box tracer cannot do scene '" + scene.name +
                                "' (it knows only the inside of an empty box). Choose embree or automatic.");
            }
            return make_box_tracer(scene);
        case TracerChoice::embree:
            return make_embree_tracer(scene);
        case TracerChoice::leaky:
            return make_leaky_tracer(scene);
        case TracerChoice::automatic:
            break;
    }
    return scene.empty_box ? make_box_tracer(scene) : make_embree_tracer(scene);
}

}  // namespace ff
