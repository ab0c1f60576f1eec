#pragma once

#include "core/points/stream.hpp"
#include "core/tracing/tracer.hpp"
#include "studies/form_factors/sampled_row.hpp"
#include "studies/run/parallel.hpp"

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace ff::studies::form_factors {

/// Thrown to end samples that are no longer wanted.
struct Stopped {};

/// Throws Stopped when the flag is set. Null: never.
inline void expect_more_time(const std::atomic<bool>* stop) {
    if (stop != nullptr && *stop) throw Stopped();
}

/// The intervals that a level refers to.
enum class LevelOf {
    entry,   ///< each entry by itself
    matrix,  ///< all entries and row sums at once
};

/// The progress of a matrix.
struct Progress {
    enum class Stage {
        looking,  ///< finding what geometry tells about pairs of surfaces
        pilots,   ///< rays that choose sizes
        rounds,   ///< samples that intervals are made of
    };
    Stage stage = Stage::looking;
    std::size_t round = 0;      ///< number of the round that counts for some pair, from 1; 0 before
    double share = 0;           ///< completed share of the stage or round
    std::uint64_t samples = 0;  ///< samples in all rounds
    std::size_t within = 0;     ///< pairs of faces that are within the tolerance
    std::size_t pairs = 0;      ///< pairs of faces
};

/// A request to `ffstudy form-factors`.
struct Request {
    double tolerance = 1e-5;  ///< largest length of the longer half of an entry's interval
    double relative = 0;      ///< or this share of the entry, where that is more
    double drop = 0;          ///< pairs whose factors are both known to be below this are not kept one by one
    /// Tolerance between two faces, where it differs from pair to pair; empty: `tolerance` for all. Never returns less
    /// than `tolerance`.
    std::function<double(std::uint32_t from, std::uint32_t to)> tolerance_of{};
    double level = 0.95;
    LevelOf level_of = LevelOf::entry;
    Seed seed;
    std::uint64_t max_samples = 1'000'000'000;  ///< rays and evaluations in cells together
    bool repair = false;
    bool randomisations = false;  ///< whether the matrix keeps the values of randomisations
    std::string surroundings;     ///< name of a face that is given what leaves an open scene; empty: none
    unsigned threads = 1;
    bool cells = true;                        ///< false: pairs that cells would do are sampled by rays, to test that
    const std::atomic<bool>* stop = nullptr;  ///< set by another thread: returns what is known by then
    std::function<std::unique_ptr<Tracer>(const Scene&)> tracer;  ///< makes what traces its rays; empty: make_tracer
    std::function<void(const Progress&)> report;                  ///< called by any thread, one call at a time

    using Receive = std::function<void(SampledRow)>;
    Shard shard;                 ///< rows that are sampled; the others are left out
    std::vector<bool> finished;  ///< for each row, whether it was sampled before and is left out; empty: none was
    std::function<void(const Receive&)> earlier;  ///< passes on rows that were sampled before
    std::function<void(const Receive&)> others;   ///< passes on rows as other processes send them, to the last
    std::function<void(const SampledRow&)> keep;  ///< called for each row when it is done

    /// @param from  at most `to`
    [[nodiscard]] double tolerance_between(std::uint32_t from, std::uint32_t to) const {
        return tolerance_of ? tolerance_of(from, to) : tolerance;
    }
};

}  // namespace ff::studies::form_factors
