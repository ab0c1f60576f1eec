// Cost of a ray among few and many surfaces: a sphere of triangles seen from a triangle inside of it.

#include "core/geometry/scene.hpp"
#include "core/tracing/tracer.hpp"

#include <Eigen/Geometry>

#include <benchmark/benchmark.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <memory>
#include <numbers>
#include <vector>

namespace {

using Eigen::Vector3d;

/// A sphere of radius 1 in about `triangles` triangles facing inwards, between meridians and parallels.
ff::Scene ball(std::uint32_t triangles) {
    const auto rows = static_cast<std::uint32_t>(std::max(2.0, std::round(std::sqrt(triangles / 4.0))));
    const std::uint32_t columns = 2 * rows;
    const auto place = [&](std::uint32_t row, std::uint32_t column) {
        const double polar = std::numbers::pi * row / rows;
        const double azimuth = 2 * std::numbers::pi * (column % columns) / columns;
        return Vector3d(std::sin(polar) * std::cos(azimuth), std::sin(polar) * std::sin(azimuth), std::cos(polar));
    };
    ff::Scene scene;
    scene.faces = {"ball"};
    const auto add = [&](const Vector3d& a, const Vector3d& b, const Vector3d& c) {
        const Vector3d normal = (b - a).cross(c - a);
        if (normal.norm() > 0) scene.surfaces.push_back({ff::Triangle{a, b, c}, normal.normalized(), 0});
    };
    for (std::uint32_t row = 0; row < rows; ++row) {
        for (std::uint32_t column = 0; column < columns; ++column) {
            if (row > 0) add(place(row, column), place(row, column + 1), place(row + 1, column));
            if (row + 1 < rows) add(place(row, column + 1), place(row + 1, column + 1), place(row + 1, column));
        }
    }
    return scene;
}

void rays_among(benchmark::State& state) {
    const ff::Scene scene = ball(static_cast<std::uint32_t>(state.range(0)));
    const auto tracer = ff::make_embree_tracer(scene);
    auto block = std::make_unique<ff::PointBlock>();
    block->size = ff::block_capacity;
    for (std::uint32_t i = 0; i < block->size; ++i) {
        const ff::Words words = ff::philox({}, i, ff::Purpose::coordinates);
        for (std::size_t d = 0; d < words.size(); ++d) block->coordinate[d][i] = words[d];
    }
    std::vector<std::uint64_t> hits(2);
    std::uint32_t source = 0;
    for (auto _ : state) {
        tracer->shoot(source, ff::undivided, 0, *block, hits);
        source = static_cast<std::uint32_t>((source + 7919) % scene.surfaces.size());
        benchmark::DoNotOptimize(hits.data());
    }
    state.counters["surfaces"] = static_cast<double>(scene.surfaces.size());
    state.counters["rays/s"] = benchmark::Counter(
        static_cast<double>(state.iterations()) * static_cast<double>(ff::block_capacity), benchmark::Counter::kIsRate);
}
BENCHMARK(rays_among)->RangeMultiplier(10)->Range(10, 1'000'000);

void building(benchmark::State& state) {
    const ff::Scene scene = ball(static_cast<std::uint32_t>(state.range(0)));
    for (auto _ : state) benchmark::DoNotOptimize(ff::make_embree_tracer(scene));
}
BENCHMARK(building)->Arg(1'000'000)->Unit(benchmark::kMillisecond)->Iterations(1);

}  // namespace
