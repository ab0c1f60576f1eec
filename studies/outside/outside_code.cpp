#include "studies/outside/outside_code.hpp"

#include "core/support/error.hpp"
#include "samplers/outside/added.hpp"
#include "samplers/outside/outside_points.hpp"
#include "studies/point_files/file_sampler.hpp"
#include "studies/point_files/point_file.hpp"
#include "studies/readers/toml_reader.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <memory>
#include <string>
#include <utility>
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
    constexpr std::uint64_t bytes_of_a_number = 64;  // length as text, with much to spare
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
            "{}: printed {} set{} of {} points of {} coordinates. Print one set of {{n}} points with at "
            "least {{d}} coordinates.",
            place, set.sets, set.sets == 1 ? "" : "s", set.points, set.dimension);
    return set;
}

}  // namespace

std::vector<OutsideCode> outside_code(std::string_view text, std::string_view origin) {
    const toml::table root = parse_toml(text, origin);
    const TomlReader file(root, origin);
    std::vector<OutsideCode> all;
    const auto add = [&](OutsideCode code) {
        const bool known = std::any_of(all.begin(), all.end(), [&](const OutsideCode& other) {
            return other.kind == code.kind && other.text == code.text;
        });
        if (!known) all.push_back(std::move(code));
    };
    constexpr std::array<std::pair<std::string_view, std::string_view>, 2> files{{{"study", "method"},  //
                                                                                  {"gates", "gate"}}};
    for (const auto& [options, methods] : files) {
        const auto table = file.optional_table(options);
        if (table && table->has("plugins")) {
            for (std::string& path : table->texts("plugins"))
                add({OutsideCode::Kind::plugin, std::move(path), table->place("plugins")});
        }
        for (const TomlReader& method : file.tables(methods)) {
            for (const auto& [key, kind] :
                 {std::pair<std::string_view, OutsideCode::Kind>{"sampler", OutsideCode::Kind::sampler},
                  {"estimator", OutsideCode::Kind::estimator}}) {
                const auto name = method.optional_text(key);
                if (name && names_command(*name)) add({kind, *name, method.place(key)});
            }
        }
    }
    return all;
}

void admit(const OutsideCode& code, const std::filesystem::path& folder, double deadline) {
    switch (code.kind) {
        case OutsideCode::Kind::plugin:
            load_plugin(code.text, folder);
            break;
        case OutsideCode::Kind::sampler:
            load_command_sampler(code.text, folder, deadline);
            break;
        case OutsideCode::Kind::estimator:
            load_command_estimator(code.text, folder, deadline);
            break;
    }
}

const samplers::CatalogueEntry& sampler_of_user(std::string_view name, double deadline) {
    if (names_point_file(name)) return load_point_file(name, "", {});
    if (names_command(name)) return load_command_sampler(name, {}, deadline);
    return samplers::find(name);
}

const samplers::CatalogueEntry& load_command_sampler(std::string_view name, const std::filesystem::path& folder,
                                                     double deadline) {
    auto program = std::make_shared<Program>(name, folder, deadline);
    program->expect_placeholders_among({"{n}", "{d}", "{requests}"});
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
