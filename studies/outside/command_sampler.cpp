#include "core/support/error.hpp"
#include "samplers/outside/added.hpp"
#include "samplers/outside/outside_points.hpp"
#include "studies/outside/outside_code.hpp"
#include "studies/point_files/point_file.hpp"

#include <fmt/format.h>

#include <memory>
#include <string>
#include <vector>

namespace ff::studies {
namespace {

using samplers::AddedSampler;
using samplers::SetRequest;

/// A very rough guess of the processor time for a point: starting a program takes milliseconds. It makes units of work
/// short.
constexpr double nanoseconds_of_a_point = 2e4;

samplers::PointSet run_for_set(const Program& program, const SetRequest& request) {
    samplers::expect_whole(program.title(), request);
    const std::string place = fmt::format("{} ({})", program.title(), samplers::in_words(request));
    constexpr std::uint64_t bytes_of_a_number = 64;  // in text, with much to spare
    const std::uint64_t most = 65536 + request.points * (request.dimension + 4) * bytes_of_a_number;
    const std::string output =
        program.takes_requests()
            ? program.ask(place,
                          fmt::format("{} {} {} {}\n", request.points, request.dimension, request.seed, request.trial),
                          raw_size, most)
            : program.run(place, {request.seed, request.trial},
                          {{"{n}", std::to_string(request.points)}, {"{d}", std::to_string(request.dimension)}}, most);
    auto set = parse_points(output, place);
    if (set.sets != 1 || set.points != request.points || set.dimension < request.dimension)
        throw UserError(
            fmt::format("{}: printed {} set{} of {} points of {} coordinates. Print one set of {{n}} points with at "
                        "least {{d}} coordinates.",
                        place, set.sets, set.sets == 1 ? "" : "s", set.points, set.dimension));
    return set;
}

}  // namespace

const samplers::CatalogueEntry& load_command_sampler(std::string_view name, const std::filesystem::path& folder,
                                                     double deadline) {
    auto program = std::make_shared<Program>(name, folder, deadline);
    samplers::SamplerInfo traits;
    traits.randomised = program->is_randomised();
    traits.nanoseconds = nanoseconds_of_a_point;
    const auto fill = samplers::parts_of(
        [program](const SetRequest& request, samplers::PointSet& set) { set = run_for_set(*program, request); });
    auto make = [program, fill, randomised = traits.randomised](const samplers::PointSetSpec& spec) {
        const auto points_of = [&](std::uint32_t trial) {
            return run_for_set(*program, samplers::request_of({spec.key, trial, 0, 0}, spec.points, spec.dimension))
                .coordinate;
        };
        program->expect_repeatable("points", points_of, always_telling);
        return samplers::outside_points(spec.points, randomised, fill);
    };
    return samplers::add(std::make_unique<AddedSampler>(
        AddedSampler::Texts{program->full_name(), "points that a program prints",
                            "The program is run for each set of points, and a few times at first to see that it "
                            "prints the same for the same seed. What it promises is its author's affair; ffstudy "
                            "check-sampler asks of it "
                            "what the program's own samplers keep."},
        traits, std::vector<std::uint64_t>{}, std::move(make)));
}

}  // namespace ff::studies
