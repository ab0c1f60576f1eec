#include "studies/audit/experiment_model.hpp"

#include "core/support/contract.hpp"
#include "studies/audit/scene_facts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <set>
#include <utility>
#include <vector>

namespace ff::studies::audit {
namespace {

/// Two different variables, one for each direction.
struct TiedPair {
    std::size_t from = 0;
    std::size_t to = 0;
    std::size_t there = 0;  ///< variable of the factor from `from` to `to`
    std::size_t back = 0;
};

/// Each two variables once: congruent pairs share theirs, and a completed entry has that of the one it follows from.
std::vector<TiedPair> tied_pairs(const ExperimentModel& model) {
    const std::size_t faces = model.facts.faces();
    std::vector<TiedPair> tied;
    std::set<std::pair<std::size_t, std::size_t>> seen;
    for (std::size_t i = 0; i < faces; ++i) {
        for (std::size_t j = i + 1; j < faces; ++j) {
            const std::size_t there = model.pairs.at(i * faces + j).variable;
            const std::size_t back = model.pairs.at(j * faces + i).variable;
            if (there != back && seen.insert(std::minmax(there, back)).second) tied.push_back({i, j, there, back});
        }
    }
    return tied;
}

/// Counts of the pairs that are printed both ways.
struct BothWays {
    std::size_t kept = 0;
    std::size_t broken = 0;
    std::size_t both_off = 0;  ///< broken, with neither figure a print of the true factor
};

BothWays count_both_ways(const SceneFacts& facts, const std::vector<TiedPair>& tied,
                         const std::map<std::size_t, Range>& printed) {
    BothWays count;
    for (const TiedPair& pair : tied) {
        const auto there = printed.find(pair.there);
        const auto back = printed.find(pair.back);
        if (there == printed.end() || back == printed.end()) continue;
        const double ratio = facts.areas[pair.from] / facts.areas[pair.to];
        const double off = facts.area_error[pair.from] + facts.area_error[pair.to];
        const Range expected{there->second.low * ratio * (1 - off), there->second.high * ratio * (1 + 2 * off)};
        if (expected.meets(back->second)) {
            ++count.kept;
            continue;
        }
        ++count.broken;
        if (!there->second.meets(facts.factor(pair.from, pair.to)) &&
            !back->second.meets(facts.factor(pair.to, pair.from)))
            ++count.both_off;
    }
    return count;
}

/// The assumption that a deterministic method keeps reciprocity. A method that does not has most pairs wrong, in both
/// directions, and keeps others by luck alone: the more are kept, the less easily the assumption is given up.
Suspect keeps_reciprocity(const Experiment& experiment, const BothWays& count) {
    Suspect suspect{.figures = {},
                    .assumption = fmt::format("the method keeps reciprocity ({})", describe(experiment))};
    const double more = 0.5 * static_cast<double>(std::max<std::size_t>(1, count.kept + count.broken) - 1);
    const bool is_hopeless = count.broken > most_misprints || count.both_off > std::max<std::size_t>(1, count.kept);
    suspect.cost = is_hopeless ? 0.5 : 1.2 + more;
    suspect.weight = is_hopeless ? 0 : 0.9 + more;
    return suspect;
}

}  // namespace

void add_reciprocity(const std::map<std::size_t, Range>& printed, double z_limit, ExperimentModel& model) {
    const SceneFacts& facts = model.facts;
    const Experiment& experiment = model.experiment;
    constexpr double unbounded = std::numeric_limits<double>::infinity();
    const std::vector<TiedPair> tied = tied_pairs(model);
    const bool direct = experiment.completion == Completion::direct;
    std::optional<std::size_t> suspect;
    if (!tied.empty() && direct && !experiment.rays_per_face) {
        suspect = model.system.suspects.size();
        model.system.suspects.push_back(keeps_reciprocity(experiment, count_both_ways(facts, tied, printed)));
    }
    for (const TiedPair& pair : tied) {
        const double scale = std::max(facts.areas[pair.from], facts.areas[pair.to]);
        const double there = facts.areas[pair.from] / scale;
        const double back = facts.areas[pair.to] / scale;
        double chance = 0;
        if (direct && experiment.rays_per_face) {
            const std::uint64_t rays = *experiment.rays_per_face;
            const double sigma = std::hypot(there * most_sigma(facts, model.distribution, rays, pair.from, pair.to),
                                            back * most_sigma(facts, model.distribution, rays, pair.to, pair.from));
            chance = reach_of_chance(sigma, 1 / static_cast<double>(rays), z_limit);
        }
        // Where areas are uncertain, one bound holds with the smallest ratio of areas and the other with the largest.
        const double off = facts.area_error[pair.from] + facts.area_error[pair.to];
        const auto add = [&](double ratio, Range values) {
            model.system.constraints.push_back({.relation = Relation::reciprocity,
                                                .terms = {{pair.there, there * ratio}, {pair.back, -back}},
                                                .values = values,
                                                .suspect = suspect});
        };
        if (off == 0) {
            add(1, {-chance, chance});
        } else if (off < 0.5) {
            add(1 - off, {-unbounded, chance});
            add(1 / (1 - off), {-chance, unbounded});
        }
    }
}

std::string quote(const PublishedTables& tables, std::size_t figure) {
    return fmt::format("{} (\"{}\")", describe(tables, figure), tables.figures[figure].printed);
}

std::string both_ways(const ExperimentModel& model, const Constraint& constraint) {
    const std::vector<TiedPair> tied = tied_pairs(model);
    const auto pair = std::ranges::find_if(tied, [&](const TiedPair& p) {
        return p.there == constraint.terms.front().variable && p.back == constraint.terms.back().variable;
    });
    FF_EXPECT(pair != tied.end());
    const auto side = [&](std::size_t variable, std::size_t from, std::size_t to) {
        const auto print = std::ranges::find_if(model.links, [&](const FigureLink& link) {
            return model.tables.figures[link.figure].kind == FigureKind::form_factor &&
                   link.quantity->variable == variable;
        });
        const auto& faces = model.facts.labels;
        return fmt::format("{} from an area of {:.6g}",
                           print == model.links.end() ? fmt::format("F {}-{}", faces[from], faces[to])
                                                      : quote(model.tables, print->figure),
                           model.facts.areas[from]);
    };
    return fmt::format("{} and {}", side(pair->there, pair->from, pair->to), side(pair->back, pair->to, pair->from));
}

}  // namespace ff::studies::audit
