#pragma once

#include "core/points/stream.hpp"
#include "core/tracing/tracer.hpp"

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>

namespace ff::studies {

/// What the level of intervals is said of.
enum class LevelOf {
    entry,   ///< each entry's by itself
    matrix,  ///< all entries and row sums at once
};

/// How far a matrix is.
struct FormFactorProgress {
    enum class Stage {
        looking,  ///< at pairs of surfaces: what is known of them by geometry
        pilots,   ///< samples that decide on methods and sizes
        rounds,   ///< samples that intervals are made of
    };
    Stage stage = Stage::looking;
    std::size_t round = 0;      ///< of those that count for some pair, from 1; 0 before
    double share = 0;           ///< of the stage or round that is done
    std::uint64_t samples = 0;  ///< in all rounds
    std::size_t within = 0;     ///< pairs of faces that are within the tolerance
    std::size_t pairs = 0;      ///< pairs of faces
};

/// What `ffstudy form_factors` is asked for.
struct FormFactorRequest {
    double tolerance = 1e-5;  ///< of every entry: the larger half of its interval
    double level = 0.95;
    LevelOf level_of = LevelOf::entry;
    Seed seed;
    std::uint64_t max_samples = 1'000'000'000;  ///< rays and points together
    bool repair = false;
    unsigned threads = 1;
    const std::atomic<bool>* stop = nullptr;  ///< set by another thread: what is known then is the result
    std::function<std::unique_ptr<Tracer>(const Scene&)> tracer;  ///< of its rays; empty: make_tracer
    std::function<void(const FormFactorProgress&)> report;        ///< called by any thread, one call at a time
};

}  // namespace ff::studies
