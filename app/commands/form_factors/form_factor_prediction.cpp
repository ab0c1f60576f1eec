#include "app/commands/form_factors/form_factor_run.hpp"

#include "app/process/limits.hpp"
#include "app/process/signals.hpp"
#include "app/terminal/output.hpp"

#include "reports/text/numbers.hpp"
#include "reports/words/scene_reports.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <ctime>

namespace ff::app {
namespace {

constexpr std::size_t rows_tried = 24;

/// Processor time of all threads, in seconds.
double processor_time() {
    return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

/// Rough size of the files, in bytes, from what each pair and each entry takes.
std::uint64_t expected_size(const studies::form_factors::Matrix& matrix) {
    constexpr std::uint64_t store = 100;  // bytes for a pair
    constexpr std::uint64_t sparse = 2;   // bytes for an entry in two packed files with indices and values
    constexpr std::uint64_t text = 170;   // bytes for an entry in matrix.csv and two .mtx
    constexpr std::uint64_t dense = 16;   // bytes for an entry in two files, zeros too
    const std::uint64_t pairs = matrix.exchanges.size();
    const std::uint64_t faces = matrix.faces();
    std::uint64_t size = pairs * (store + 32 * sparse);
    if (faces <= studies::form_factors::most_dense_faces) size += 2 * pairs * text + faces * faces * dense;
    return size;
}

}  // namespace

ExitCode predict_form_factors(const studies::form_factors::KeptMatrix& kept) {
    studies::form_factors::Request request = kept.request;
    const std::size_t faces = kept.scene.faces.size();
    const std::size_t step = std::max<std::size_t>(1, faces / rows_tried);
    request.shard = {1, step};
    double looking = processor_time();
    double begin = 0;  // when sampling begins and ends, in processor time
    double end = 0;
    request.report = [&](const studies::form_factors::Progress& progress) {
        const double now = processor_time();
        if (progress.stage == studies::form_factors::Progress::Stage::looking)
            looking = now;
        else if (begin == 0)
            begin = now;
        else
            end = now;
    };
    stop_gracefully_on_signals();
    const auto matrix = studies::form_factors::find_matrix(kept.scene, request);
    if (matrix.interrupted) return ExitCode::interrupted;
    std::size_t to_sample = 0;
    std::size_t sampled = 0;
    for (const studies::form_factors::FaceExchange& pair : matrix.exchanges) {
        if (pair.is_sampled()) ++to_sample;
        if (pair.samples > 0) ++sampled;
    }
    const double sampling = std::max(0.0, end - begin);
    const double rest = processor_time() - sampling;
    // Rough number of bytes for a sampled pair, until its interval and those of its rows are made.
    constexpr std::uint64_t memory_of_pair = 600;
    const double more = sampled == 0 ? 0 : static_cast<double>(to_sample) / static_cast<double>(sampled);
    print_folded("{} of {}; {} of faces see each other, {} of them are to be sampled\n",
                 reports::counted(faces, "face"), reports::counted(matrix.surfaces, "surface"),
                 reports::counted(matrix.exchanges.size(), "pair"), to_sample);
    print_folded("Tried: {} of {}, {:.1f} s of processor time, after {:.1f} s for looking at all pairs.\n", sampled,
                 reports::counted(to_sample, "pair"), sampling, looking);
    if (to_sample > 0 && sampled == 0) {
        print_folded("No row that was tried has pairs to sample: what all take is not known.\n");
        return ExitCode::passed;
    }
    const double all = rest + sampling * more;
    print_folded("Expected for all: {:.{}f} s of processor time ({:.{}f} s on {}), {:.2g} samples, {} of memory{}\n",
                 all, all < 10 ? 1 : 0, all / request.threads, all / request.threads < 10 ? 1 : 0,
                 reports::counted(request.threads, "thread"), static_cast<double>(matrix.samples) * more,
                 size_in_words(resident_memory().value_or(0) + (to_sample - sampled) * memory_of_pair),
                 fmt::format(", {} on the disk with --out", size_in_words(expected_size(matrix))));
    return ExitCode::passed;
}

}  // namespace ff::app
