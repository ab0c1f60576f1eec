#include "app/commands/commands.hpp"

#include "app/command_line/common_options.hpp"
#include "app/command_line/program.hpp"
#include "app/terminal/output.hpp"

#include "reports/files/array_files.hpp"
#include "reports/files/output_file.hpp"
#include "reports/text/numbers.hpp"
#include "samplers/point_sets/draw_set.hpp"
#include "studies/sampler_checks/sampler_checks.hpp"
#include "studies/sampler_checks/structure.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>

namespace ff::app {
namespace {

struct PointsCommand {
    std::string sampler;
    samplers::DrawnSet set;
    OutsideOptions outside;
    std::filesystem::path out;  ///< empty: print properties of the set
};

struct CheckSamplerCommand {
    std::string sampler;
    std::optional<std::uint64_t> points;
    std::optional<std::size_t> dimension;
    std::optional<std::uint64_t> trials;
    std::uint64_t seed = 1;
    std::vector<std::string> promises;  ///< structure that every set has, each as "net:2"
    OutsideOptions outside;
};

const samplers::CatalogueEntry& sampler_of(const std::string& name, const OutsideOptions& outside) {
    load_plugins(outside);
    return studies::sampler_of_user(name, deadline_of(outside));
}

void describe(const samplers::PointSet& set, std::uint32_t base) {
    const auto found = studies::evenness_of(set, base);
    const bool too_many = set.points > studies::most_for_t_value;
    print_folded("{} points of {} coordinates\n", set.points, set.dimension);
    print_folded("t-value in base {}: {}\n", base,
                 found.t_value ? fmt::format("{}", *found.t_value)
                 : too_many    ? fmt::format("not computed for more than {} points", studies::most_for_t_value)
                               : "none, the number of points is no power of it");
    if (found.l2_star_discrepancy) {
        print_folded("L2-star discrepancy: {:.4g}\ncentred L2 discrepancy: {:.4g}\n", *found.l2_star_discrepancy,
                     *found.centred_discrepancy);
    } else {
        print_folded("discrepancies: not computed for more than {} points\n", studies::most_quadratic);
    }
    print_folded("largest gap of an axis: {:.4g} (1/n is {:.4g})\n", found.largest_gap,
                 1 / static_cast<double>(set.points));
}

std::string_view word(studies::SamplerVerdict verdict) {
    using studies::SamplerVerdict;
    return verdict == SamplerVerdict::pass   ? "pass"
           : verdict == SamplerVerdict::fail ? "FAIL"
           : verdict == SamplerVerdict::note ? "note"
                                             : "inconclusive";
}

/// Writes a point set, or prints its evenness.
ExitCode points(const PointsCommand& command) {
    const auto& sampler = sampler_of(command.sampler, command.outside);
    if (command.out.empty()) {
        describe(samplers::draw_set(sampler, command.set),
                 sampler.info.sizes == samplers::Sizes::powers ? sampler.info.base : 2);
        return ExitCode::passed;
    }
    const auto format = reports::point_set_format(command.out);
    const auto set = samplers::draw_set(sampler, command.set);
    reports::write_file(command.out, [&](std::ostream& out) { format(out, set); });
    return ExitCode::passed;
}

/// Failed where a sampler breaks the contract or a promise; inconclusive where trials are too few, or where its points
/// nearly have a structure.
ExitCode check_sampler(const CheckSamplerCommand& command) {
    const auto& sampler = sampler_of(command.sampler, command.outside);
    studies::SamplerCheckRequest request;
    request.points = command.points.value_or(sampler.info.at_hand.empty() ? 256 : sampler.info.at_hand.back());
    if (!command.points && sampler.info.sizes == samplers::Sizes::powers && sampler.info.at_hand.empty()) {
        request.points = sampler.info.multiple;
        while (request.points < 256) request.points *= sampler.info.base;
    }
    request.dimension = command.dimension.value_or(sampler.info.most_dimension);
    request.trials = command.trials.value_or(0);
    request.seed = command.seed;
    for (const std::string& text : command.promises) request.promises.push_back(studies::parse_promise(text));
    const auto found = studies::check_sampler(sampler, request);
    print_folded("{}: {} points of {} coordinates, {}, seed {}\n", sampler.info.name, request.points, request.dimension,
                 reports::counted(found.trials, "trial"), request.seed);
    print_folded(
        "A sound sampler fails with probability {} at most; each statistical check misses an effect of the stated size "
        "with probability {:.2g}. {} searched for structure.\n\n",
        request.alpha, 1 - request.power, found.sets == 1 ? "One set is" : fmt::format("{} sets are", found.sets));
    std::size_t width = 0;
    for (const auto& check : found.checks) width = std::max(width, check.name.size());
    bool failed = false;
    bool undecided = false;
    for (const auto& check : found.checks) {
        print_folded("{:<12}  {:<{}}  {}\n", word(check.verdict), check.name, width, check.found);
        failed |= check.verdict == studies::SamplerVerdict::fail;
        undecided |= check.verdict == studies::SamplerVerdict::inconclusive;
    }
    for (const std::string& what : found.not_asked) print_folded("not asked     {}\n", what);
    return failed ? ExitCode::failed : undecided ? ExitCode::inconclusive : ExitCode::passed;
}

}  // namespace

void add_points(ProgramDefinition& program) {
    const auto [sub, command] = program.command<PointsCommand>(
        laboratory, "points", "Write a point set, or say how evenly it is spread", points);
    sub.option("SAMPLER", command.sampler, "A sampler, file:PATH or command:PROGRAM", {.is_required = true});
    sub.option("--n", command.set.points, "Points", {.shows_default = true});
    sub.option("--d", command.set.dimension, "Coordinates of a point", {.shows_default = true});
    sub.option("--seed", command.set.seed, "Seed of all random numbers", {.shows_default = true});
    sub.option("--trial", command.set.trial, "Which of the trials, from 0", {.shows_default = true});
    add_outside_options(sub, command.outside, OutsideCodeFrom::command_line);
    sub.option("--out", command.out, "File: .npy, .csv, .dat or .svg (default: none is written)", {.type = "FILE"});
}

void add_check_sampler(ProgramDefinition& program) {
    const auto [sub, command] = program.command<CheckSamplerCommand>(
        checks, "check-sampler", "Check the properties that every sampler must have", check_sampler);
    sub.option("SAMPLER", command.sampler, "A sampler, file:PATH#RANDOMISE or command:PROGRAM", {.is_required = true});
    sub.option("--n", command.points, "Points (default: about 256, or those of the largest file)");
    sub.option("--d", command.dimension, "Coordinates of a point (default: all, at most 4)");
    sub.option("--trials", command.trials, "Trials (default: about a second's)", {.numbers = Numbers::positive});
    sub.option("--seed", command.seed, "Seed of all random numbers", {.shows_default = true});
    sub.option(
        "--promises", command.promises,
        "Structure of every set: latin, net:T, stratified, lattice, separated by commas (default: it is looked for)",
        {.type = "STRUCTURE", .delimiter = ','});
    add_outside_options(sub, command.outside, OutsideCodeFrom::command_line);
}

}  // namespace ff::app
