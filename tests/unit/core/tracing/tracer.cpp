#include "core/tracing/tracer.hpp"

#include "core/geometry/box.hpp"
#include "core/geometry/scene.hpp"
#include "core/support/error.hpp"

#include <gtest/gtest.h>

namespace ff {
namespace {

TEST(MakeTracer, PrefersTheBoxTracerWhereItApplies) {
    Scene scene = make_box(1, 2, 3);
    EXPECT_EQ(make_tracer(scene, TracerChoice::automatic)->name(), "box");
    EXPECT_EQ(make_tracer(scene, TracerChoice::embree)->name(), "embree");
    scene.empty_box.reset();
    EXPECT_EQ(make_tracer(scene, TracerChoice::automatic)->name(), "embree");
}

TEST(MakeTracer, RefusesTheBoxTracerUnlessTheSceneIsAnEmptyBox) {
    Scene scene = make_box(1, 2, 3);
    scene.empty_box.reset();
    EXPECT_THROW(make_tracer(scene, TracerChoice::box), UserError);
}

}  // namespace
}  // namespace ff
