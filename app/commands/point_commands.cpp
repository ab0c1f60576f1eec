#include "app/commands/point_commands.hpp"

#include "core/support/error.hpp"
#include "reports/files/output_file.hpp"
#include "reports/files/point_set_files.hpp"
#include "samplers/net_parameter.hpp"
#include "stats/discrepancy.hpp"
#include "studies/sampler_checks/sampler_checks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string_view>

namespace ff::app {
namespace {

const samplers::CatalogueEntry& sampler_of(const std::string& name, const OutsideOptions& outside) {
    load_plugins(outside);
    return studies::sampler_of_user(name, deadline_of(outside));
}

/// One set, as a study with this seed and these points could use it.
samplers::PointSet draw(const samplers::CatalogueEntry& sampler, const PointsCommand& command) {
    if (!sampler.info.equal_weights)
        throw UserError(fmt::format(
            "{} (its points have weights, which these files do not hold). Choose another sampler.", sampler.info.name));
    if (sampler.info.most_trials != 0 && command.trial >= sampler.info.most_trials)
        throw UserError(fmt::format("--trial {} ({} has {}, counted from 0). Take a smaller number.", command.trial,
                                    sampler.info.name, sampler.info.most_trials));
    const auto source = sampler.make({.points = command.points, .dimension = command.dimension});
    const Stream stream{.key = derive_key(Seed{command.seed}, fmt::format("points|{}|d={}|n={}", sampler.info.name,
                                                                          command.dimension, command.points)),
                        .trial = command.trial};
    samplers::PointSet set{command.points, command.dimension, 1, {}};
    set.coordinate.resize(command.points * command.dimension);
    PointBlock block;
    block.dimension = command.dimension;
    for (PointIndex first = 0; first < command.points; first += block.size) {
        block.size = std::min<std::uint64_t>(block_capacity, command.points - first);
        source->fill(stream, first, block);
        for (std::size_t d = 0; d < command.dimension; ++d)
            std::copy_n(block.coordinate[d].begin(), block.size, &set.coordinate[d * command.points + first]);
    }
    return set;
}

void describe(const samplers::PointSet& set, std::uint32_t base) {
    constexpr std::uint64_t most = 1u << 14;  // quadratic
    stats::Coordinates coordinates(set.dimension);
    double gap = 0;
    for (std::size_t d = 0; d < set.dimension; ++d) {
        for (const std::uint32_t x : set.row(0, d)) coordinates[d].push_back((x + 0.5) * 0x1p-32);
        gap = std::max(gap, stats::largest_gap(coordinates[d]));
    }
    const auto t = set.points <= most * 4 ? samplers::net_parameter(set, 0, base) : std::nullopt;
    fmt::print("{} points of {} coordinates\n", set.points, set.dimension);
    fmt::print("t-value in base {}: {}\n", base,
               t                       ? fmt::format("{}", *t)
               : set.points > most * 4 ? "not computed for more than 65536 points"
                                       : "none, the number of points is no power of it");
    if (set.points <= most) {
        fmt::print("L2-star discrepancy: {:.4g}\ncentred L2 discrepancy: {:.4g}\n",
                   stats::l2_star_discrepancy(coordinates), stats::centred_discrepancy(coordinates));
    } else {
        fmt::print("discrepancies: not computed for more than {} points\n", most);
    }
    fmt::print("largest gap of an axis: {:.4g} (1/n is {:.4g})\n", gap, 1 / static_cast<double>(set.points));
}

std::string_view word(studies::SamplerVerdict verdict) {
    switch (verdict) {
        case studies::SamplerVerdict::pass:
            return "pass";
        case studies::SamplerVerdict::fail:
            return "FAIL";
        case studies::SamplerVerdict::inconclusive:
            break;
    }
    return "inconclusive";
}

}  // namespace

ExitCode points(const PointsCommand& command) {
    const auto& sampler = sampler_of(command.sampler, command.outside);
    if (command.out.empty()) {
        describe(draw(sampler, command), sampler.info.sizes == samplers::Sizes::powers ? sampler.info.base : 2);
        return ExitCode::passed;
    }
    const auto format = reports::point_set_format(command.out);
    const auto set = draw(sampler, command);
    reports::write_file(command.out, [&](std::ostream& out) { format(out, set); });
    return ExitCode::passed;
}

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
    const auto found = studies::check_sampler(sampler, request);
    fmt::print("{}: {} points of {} coordinates, {} trials, seed {}\n", sampler.info.name, request.points,
               request.dimension, found.trials, request.seed);
    fmt::print(
        "A sound sampler fails with probability {} at most; in each statistical check, what is said to be seen is "
        "missed with probability {:.2g}.\n\n",
        request.alpha, 1 - request.power);
    std::size_t width = 0;
    for (const auto& check : found.checks) width = std::max(width, check.name.size());
    bool failed = false;
    bool undecided = false;
    for (const auto& check : found.checks) {
        fmt::print("{:<12}  {:<{}}  {}\n", word(check.verdict), check.name, width, check.found);
        failed |= check.verdict == studies::SamplerVerdict::fail;
        undecided |= check.verdict == studies::SamplerVerdict::inconclusive;
    }
    for (const std::string& what : found.not_asked) fmt::print("not asked     {}\n", what);
    return failed ? ExitCode::failed : undecided ? ExitCode::inconclusive : ExitCode::passed;
}

}  // namespace ff::app
