#include "app/commands/point_commands.hpp"

#include "core/support/error.hpp"
#include "reports/files/output_file.hpp"
#include "reports/files/point_set_files.hpp"
#include "samplers/point_sets/draw_set.hpp"
#include "studies/sampler_checks/evenness_of_set.hpp"
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

samplers::PointSet draw(const samplers::CatalogueEntry& sampler, const PointsCommand& command) {
    return samplers::draw_set(sampler, {command.points, command.dimension, command.seed, command.trial});
}

void describe(const samplers::PointSet& set, std::uint32_t base) {
    const auto found = studies::evenness_of(set, base);
    const bool too_many = set.points > studies::most_for_t_value;
    fmt::print("{} points of {} coordinates\n", set.points, set.dimension);
    fmt::print("t-value in base {}: {}\n", base,
               found.t_value ? fmt::format("{}", *found.t_value)
               : too_many    ? fmt::format("not computed for more than {} points", studies::most_for_t_value)
                             : "none, the number of points is no power of it");
    if (found.l2_star_discrepancy) {
        fmt::print("L2-star discrepancy: {:.4g}\ncentred L2 discrepancy: {:.4g}\n", *found.l2_star_discrepancy,
                   *found.centred_discrepancy);
    } else {
        fmt::print("discrepancies: not computed for more than {} points\n", studies::most_quadratic);
    }
    fmt::print("largest gap of an axis: {:.4g} (1/n is {:.4g})\n", found.largest_gap,
               1 / static_cast<double>(set.points));
}

std::string_view word(studies::SamplerVerdict verdict) {
    switch (verdict) {
        case studies::SamplerVerdict::pass:
            return "pass";
        case studies::SamplerVerdict::fail:
            return "FAIL";
        case studies::SamplerVerdict::note:
            return "note";
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
    for (const std::string& text : command.promises) request.promises.push_back(studies::parse_promise(text));
    const auto found = studies::check_sampler(sampler, request);
    fmt::print("{}: {} points of {} coordinates, {} trial{}, seed {}\n", sampler.info.name, request.points,
               request.dimension, found.trials, found.trials == 1 ? "" : "s", request.seed);
    fmt::print(
        "A sound sampler fails with probability {} at most; in each statistical check, what is said to be seen is "
        "missed with probability {:.2g}. Structure is looked for in {} set{}.\n\n",
        request.alpha, 1 - request.power, found.sets, found.sets == 1 ? "" : "s");
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
