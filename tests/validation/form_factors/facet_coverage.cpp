#include "tests/validation/form_factors/facet_coverage.hpp"

#include "core/geometry/scene.hpp"
#include "stats/error_rates/multiplicity.hpp"
#include "tests/validation/form_factors/facet_entries.hpp"
#include "tests/validation/form_factors/facet_scenes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <limits>
#include <map>
#include <utility>

namespace ff::studies::form_factors {
namespace {

constexpr double facet_family_level = 0.95;
constexpr double stated_level = 0.95;
constexpr double claimed_beyond = 1e-3;
constexpr std::size_t most_outside_shown = 10;

/// Where an entry lies beside its reference, whose own interval counts for the entry.
struct Beside {
    bool outside = false;
    bool beyond = false;  ///< two half widths
    double excess = 0;    ///< distance of both intervals in half widths of the entry's
    bool fine = false;
};

Beside compare(const FacetEntry& entry, const PlainReference& reference) {
    const double half = std::max(entry.high - entry.value, entry.value - entry.low);
    const double gap = std::max(reference.low - entry.high, entry.low - reference.high);
    const double away = std::max(reference.low - entry.value, entry.value - reference.high);
    Beside result;
    result.outside = gap > 0;
    result.beyond = away > 2 * half;
    if (result.outside) result.excess = half > 0 ? gap / half : std::numeric_limits<double>::infinity();
    result.fine = reference.high - reference.low <= 0.1 * 2 * half;
    return result;
}

void add(stats::Proportion& share, bool hit) {
    ++share.trials;
    share.hits += hit ? 1 : 0;
}

/// The results for entries of one kind, in one scene or in all.
struct FacetTally {
    stats::Proportion inside, beyond;          ///< shares of all entries
    stats::Proportion one_inside, one_beyond;  ///< shares of one entry of each pair
    stats::Proportion fine;
    std::uint64_t clipped_beyond = 0;  ///< of all entries
    double worst = 0;

    void take(const FacetEntry& entry, const Beside& beside) {
        add(inside, !beside.outside);
        add(beyond, beside.beyond);
        if (entry.is_one) add(one_inside, !beside.outside);
        if (entry.is_one) add(one_beyond, beside.beyond);
        clipped_beyond += beside.beyond && entry.is_clipped ? 1 : 0;
        if (beside.fine) add(fine, !beside.outside);
        worst = std::max(worst, beside.excess);
    }
};

std::string in_words(const FacetTally& tally) {
    return fmt::format(
        "{} of {} outside, {} beyond two half widths, {} of these moved to the end of what geometry allows, "
        "worst excess {:.2g} half widths",
        tally.inside.trials - tally.inside.hits, tally.inside.trials, tally.beyond.hits, tally.clipped_beyond,
        tally.worst);
}

struct OutsideEntry {
    double excess = 0;
    std::string text;
};

/// The results of one kind.
struct KindTally {
    FacetTally all;
    std::map<std::string, FacetTally> by_scene;
    std::vector<OutsideEntry> outside;
};

std::string in_words(const Scene& scene, const FacetEntry& entry, const PlainReference& reference, std::uint64_t seed) {
    const double scale = 1 / entry.smaller_area;
    return fmt::format(
        "{}, faces {} and {}, seed {}, tolerance {:g}: {:.9g} [{:.9g}, {:.9g}]{}, reference {:.9g} ± {:.2g}",
        scene.name, scene.faces[entry.from], scene.faces[entry.to], seed, entry.tolerance, entry.value * scale,
        entry.low * scale, entry.high * scale, entry.is_clipped ? ", clipped" : "", reference.value * scale,
        (reference.high - reference.low) / 2 * scale);
}

FacetKind kind_of(const std::string& name, KindTally tally) {
    FacetKind kind;
    kind.name = name;
    kind.inside = tally.all.inside;
    kind.beyond = tally.all.beyond;
    kind.fine = tally.all.fine;
    kind.worst = tally.all.worst;
    kind.rates.title = name;
    kind.rates.rates = {{name + ": inside", tally.all.one_inside, RateClaim::at_least, stated_level},
                        {name + ": beyond two half widths", tally.all.one_beyond, RateClaim::at_most, claimed_beyond}};
    for (const auto& [scene, shown] : tally.by_scene) {
        if (shown.one_inside.trials == 0) continue;
        kind.rates.rates.push_back({fmt::format("{}, {}: inside", name, scene), shown.one_inside, RateClaim::none, 0});
        kind.rates.rates.push_back(
            {fmt::format("{}, {}: beyond two half widths", name, scene), shown.one_beyond, RateClaim::none, 0});
    }
    std::ranges::sort(tally.outside, std::greater<>(), &OutsideEntry::excess);
    for (std::size_t k = 0; k < std::min(most_outside_shown, tally.outside.size()); ++k)
        kind.outside.push_back(fmt::format("{:.2g} half widths: {}", tally.outside[k].excess, tally.outside[k].text));
    kind.rates.text = "Of all entries of all seeds: " + in_words(tally.all);
    for (const auto& [scene, shown] : tally.by_scene)
        kind.rates.text += fmt::format("; {}: {}", scene, in_words(shown));
    kind.rates.text += ".";
    return kind;
}

/// In the order in which methods are tried.
bool comes_before(const std::string& a, const std::string& b) {
    static const std::vector<std::string> order{"none",   "closed_form", "contour", "quadrature",
                                                "bounds", "cells",       "points",  "rays"};
    return std::find(order.begin(), order.end(), a) < std::find(order.begin(), order.end(), b);
}

}  // namespace

FacetCoverageOptions small_facets() {
    FacetCoverageOptions options;
    options.scenes = FacetScenes::small;
    options.effort.accuracy = 1e-5;
    options.effort.most_points = 128;
    return options;
}

std::size_t FacetCoverage::contradictions() const {
    std::size_t count = 0;
    for (const FacetKind& kind : kinds) count += kind.rates.contradictions(level);
    return count;
}

ClaimVerdict verdict_of(const MeasuredRate& rate, double level) {
    if (!holds(rate, level)) return ClaimVerdict::fails;
    const stats::Interval interval = interval_of(rate, level);
    const bool shown = rate.claim == RateClaim::at_most ? interval.high <= rate.claimed : interval.low >= rate.claimed;
    return shown ? ClaimVerdict::holds : ClaimVerdict::open;
}

FacetCoverage measure_facet_coverage(const FacetCoverageOptions& options) {
    FacetCoverage coverage;
    coverage.options = options;
    const std::vector<Scene> scenes = facet_scenes(options.scenes);
    std::map<std::string, KindTally> tallies;
    for (const Scene& scene : scenes) {
        coverage.scenes +=
            fmt::format("{}{} ({} facets)", coverage.scenes.empty() ? "" : ", ", scene.name, scene.faces.size());
        const FacetEntries found = facet_entries(scene, options);
        coverage.references += found.references.size();
        coverage.wide_references += found.wide_references;
        // An entry that lies outside by the first reference is compared with a reference of its own.
        std::vector<std::size_t> doubtful;
        for (const FacetEntry& entry : found.entries) {
            if (compare(entry, found.references[entry.reference]).outside) doubtful.push_back(entry.reference);
        }
        const auto again = sharper_references(scene, found, doubtful, options);
        for (const FacetEntry& entry : found.entries) {
            PlainReference reference = found.references[entry.reference];
            Beside beside = compare(entry, reference);
            if (const auto sharper = again.find(entry.reference); beside.outside && sharper != again.end()) {
                reference = sharper->second;
                beside = compare(entry, reference);
            }
            KindTally& tally = tallies[std::string(entry.kind)];
            tally.all.take(entry, beside);
            tally.by_scene[scene.name].take(entry, beside);
            if (beside.outside)
                tally.outside.push_back(
                    {beside.excess, in_words(scene, entry, reference, options.seed.value + entry.seed)});
        }
    }
    for (auto& [name, tally] : tallies) {
        if (tally.all.one_inside.trials > 0) coverage.kinds.push_back(kind_of(name, std::move(tally)));
    }
    std::ranges::sort(coverage.kinds, comes_before, &FacetKind::name);
    coverage.level =
        1 - stats::sidak_level(1 - facet_family_level, 2 * std::max<std::size_t>(1, coverage.kinds.size()));
    return coverage;
}

}  // namespace ff::studies::form_factors
