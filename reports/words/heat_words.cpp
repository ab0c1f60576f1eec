#include "reports/words/heat_words.hpp"

#include "core/geometry/scene.hpp"
#include "reports/text/numbers.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <functional>

namespace ff::reports {

using studies::heat::Bounds;
using studies::heat::Flows;
using studies::heat::SolvedCase;

namespace {

std::string_view unit_of_power(const HeatReport& report) {
    return report.is_light() ? "" : " W";
}

/// How a sentence about flows that are not trusted begins.
std::string lead(const HeatReport& report) {
    return report.trusted ? "" : "NOT to be trusted (see the warnings); as the scene is read, ";
}

}  // namespace

std::string with_error(const Bounds& bounds, bool is_rounding) {
    if (bounds.half_width() <= 1e-9 * std::abs(bounds.middle())) return brief(bounds.middle(), 6);
    constexpr double unseen = 0.01;
    if (is_rounding || std::abs(bounds.middle()) < unseen * bounds.half_width())
        return fmt::format("0 ± {}", brief(bounds.half_width(), 2));
    return with_half_width(bounds.middle(), bounds.half_width());
}

std::string heat_answer(const HeatReport& report) {
    if (report.cases.size() > 1 || !report.trusted) return {};
    std::vector<studies::heat::GroupFlow> groups = report.cases.front().flows.groups;
    std::erase_if(groups, [](const auto& group) { return group.power.low <= 0 && group.power.high >= 0; });
    std::ranges::stable_sort(groups, std::ranges::greater(),
                             [](const auto& group) { return std::abs(group.power.middle()); });
    constexpr std::size_t most_groups = 4;
    std::vector<std::string> clauses;
    for (const auto& [name, faces, area, power, share] : groups) {
        if (clauses.size() == most_groups) break;
        clauses.push_back(
            power.low > 0
                ? fmt::format("{} gives off {}{}", name, with_error(power), unit_of_power(report))
                : fmt::format("{} takes up {}{}", name, with_error({-power.high, -power.low}), unit_of_power(report)));
    }
    return fmt::format("{}{}", fmt::join(clauses, "; "), groups.size() > most_groups ? "; others less" : "");
}

std::string heat_balance(const HeatReport& report, const SolvedCase& solved) {
    const Flows& flows = solved.flows;
    const std::string& name = solved.materials.name;
    if (flows.reaches_outside)
        return fmt::format("{}o the surroundings: {}{}", name.empty() ? "T" : name + ", t", with_error(flows.balance),
                           unit_of_power(report));
    return fmt::format("{}alance: the powers add up to {}{}.", name.empty() ? "B" : name + ", b",
                       with_error(flows.balance, flows.are_at_rest()), unit_of_power(report));
}

std::string heat_verdict(const HeatReport& report) {
    const auto share = [](const SolvedCase& solved) {
        return solved.flows.are_at_rest() ? 0 : solved.flows.worst / solved.flows.throughput;
    };
    const SolvedCase& worst = *std::ranges::max_element(report.cases, {}, share);
    const Flows& flows = worst.flows;
    const std::string unit(unit_of_power(report));
    if (flows.are_at_rest())
        return lead(report) + fmt::format("{}othing is exchanged: every power is 0 within {}{} (the faces emit {}{}).",
                                          report.trusted ? "N" : "n", brief(flows.worst, 2), unit,
                                          brief(flows.emitted, 4), unit);
    const std::string sources = fmt::format("the {}{} that the sources give off", brief(flows.throughput, 4), unit);
    const std::string of_case =
        report.cases.size() > 1 ? fmt::format(" in the worst case, {}", worst.materials.name) : std::string();
    const std::string at_level = fmt::format(
        "{} at level {:g}", flows.statistical && !report.all_at_once ? "each" : "all at once", report.request.level);
    if (!flows.within(report.tolerance))
        return lead(report) + fmt::format("{}he tolerance of {} is missed{}: powers are within {} % of {}, {}.",
                                          report.trusted ? "T" : "t", in_words(report.tolerance), of_case,
                                          brief(100 * share(worst), 2), sources, at_level);
    return lead(report) + fmt::format("{}very power is within {} % of {}{}, {}.", report.trusted ? "E" : "e",
                                      brief(100 * share(worst), 2), sources, of_case, at_level);
}

std::string heat_effort(const HeatReport& report) {
    if (report.sampled == nullptr || report.sampled->samples == 0) return {};
    return fmt::format("{} samples.", thousands_apart(report.sampled->samples));
}

std::optional<std::string> widened_rows(const HeatReport& report) {
    // They depend on the form factors alone.
    const auto& widened = report.cases.front().flows.widened;
    if (widened.empty()) return std::nullopt;
    const std::string& first = report.scene.faces[widened.front()];
    const std::string faces = widened.size() == 1 ? fmt::format("face '{}'", first)
                                                  : fmt::format("{} faces (the first is '{}')", widened.size(), first);
    return fmt::format(
        "the form factors of {} cannot add up to 1 within their intervals, which hold all at once with a probability "
        "of {:g}; their sampled ones have wider intervals here, which hold with a probability of 0.999999",
        faces, report.request.level);
}

}  // namespace ff::reports
