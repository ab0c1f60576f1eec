#include "tests/validation/heat/coverage.hpp"

#include "core/configurations/built_in_scene.hpp"
#include "core/configurations/catalogue.hpp"
#include "core/geometry/scene.hpp"
#include "core/support/error.hpp"
#include "stats/error_rates/multiplicity.hpp"
#include "studies/form_factors/form_factors.hpp"
#include "studies/heat/heat.hpp"
#include "studies/run/parallel.hpp"
#include "tests/support/known_flows.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace ff::studies::heat {
namespace {

constexpr double family_level = 0.95;
constexpr std::array shares{1.0, 0.1};              ///< of the widths of bounds
constexpr std::array statistical_shares{1.0, 0.5};  ///< of those of statistical intervals

/// Different emissivities and temperatures; every third face is adiabatic.
Materials test_materials(std::size_t faces) {
    Materials materials;
    constexpr double surroundings = 250;
    materials.surroundings = surroundings;
    for (std::size_t i = 0; i < faces; ++i) {
        Material material;
        material.emissivity = 0.9 - 0.1 * static_cast<double>(i % 7);
        if (i % 3 == 2)
            material.flux = 0;
        else
            material.temperature = 900 - 100 * static_cast<double>(i % 6);
        materials.faces.push_back(material);
    }
    return materials;
}

using KnownFactor = std::function<std::optional<double>(int from, int to)>;

/// The matrix with exact factors in place of intervals; empty where some are not known.
std::optional<form_factors::Matrix> exact_matrix(const KnownFactor& known, form_factors::Matrix matrix) {
    std::vector<double> sums(matrix.faces());
    for (form_factors::FaceExchange& exchange : matrix.exchanges) {
        const auto factor = known(static_cast<int>(exchange.from), static_cast<int>(exchange.to));
        if (!factor) return std::nullopt;
        const double area = *factor * matrix.areas[exchange.from];
        exchange.value = exchange.low = exchange.high = area;
        sums[exchange.from] += *factor;
        if (exchange.from != exchange.to) sums[exchange.to] += area / matrix.areas[exchange.to];
    }
    // Exact factors are rounded: in a closed scene the last digits have to leave room for rows of exactly 1.
    constexpr double digits = 1e-13;
    for (form_factors::FaceExchange& exchange : matrix.exchanges) {
        exchange.low *= 1 - digits;
        exchange.high *= 1 + digits;
    }
    for (std::size_t row = 0; row < sums.size(); ++row)
        matrix.rows[row] = {sums[row], sums[row] - digits, std::min(1.0, sums[row] + digits), false};
    return matrix;
}

/// Limits of a flow, and the known ones.
struct Compared {
    Bounds found;
    Bounds known;

    /// Whether limits with this share of their width contain the known ones, up to rounding.
    [[nodiscard]] bool holds(double share) const {
        constexpr double rounding = 1e-9;
        const double room = share * found.half_width() + rounding * std::max(std::abs(known.low), std::abs(known.high));
        return found.middle() - room <= known.low && known.high <= found.middle() + room;
    }
    [[nodiscard]] bool is_uncertain() const {
        constexpr double rounding = 1e-9;
        return found.half_width() > rounding * std::abs(found.middle());
    }
};

using Compare = std::function<std::vector<Compared>(const Flows&)>;

std::vector<Compared> compare_all(const Flows& found, const Flows& exact) {
    std::vector<Compared> all;
    for (std::size_t i = 0; i < found.faces.size(); ++i) {
        all.push_back({found.faces[i].power, exact.faces[i].power});
        all.push_back({found.faces[i].temperature, exact.faces[i].temperature});
    }
    return all;
}

/// Empty where intervals miss the factors by so much that some row cannot add up to 1: the program then says so.
std::optional<Flows> flows_of(const Scene& scene, const form_factors::Matrix& matrix, const Materials& materials,
                              const FlowIntervals& intervals) {
    try {
        Flows flows = find_flows(scene, matrix, materials, 1, intervals);
        return flows.widened.empty() ? std::optional(std::move(flows)) : std::nullopt;
    } catch (const UserError&) {
        return std::nullopt;
    }
}

/// What one seed has shown: whether bounds hold, all of them at once, with each share of their widths, and whether the
/// statistical interval of one flow does, a different flow for each seed.
struct Held {
    std::array<bool, shares.size()> bounds{};
    std::array<bool, shares.size()> statistical{};
};

/// How the flows of a scene are compared with known ones.
struct Known {
    Compare bounds;
    Compare statistical;
};

Held held_by(const std::optional<Flows>& bounds, const std::optional<Flows>& statistical, const Known& known,
             std::uint64_t seed) {
    Held held;
    if (bounds) {
        const std::vector<Compared> all = known.bounds(*bounds);
        for (std::size_t k = 0; k < shares.size(); ++k)
            held.bounds.at(k) = std::ranges::all_of(all, [&](const Compared& one) { return one.holds(shares.at(k)); });
    }
    if (statistical) {
        std::vector<Compared> all = known.statistical(*statistical);
        std::erase_if(all, [](const Compared& one) { return !one.is_uncertain(); });
        for (std::size_t k = 0; k < shares.size(); ++k)
            held.statistical.at(k) = all.empty() || all[seed % all.size()].holds(statistical_shares.at(k));
    }
    return held;
}

form_factors::Matrix sampled_matrix(const Scene& scene, const form_factors::FormFactorCoverageOptions& options,
                                    std::uint64_t seed) {
    form_factors::Request request;
    request.tolerance = options.tolerance;
    request.level = options.level;
    request.cells = options.cells;
    request.level_of = form_factors::LevelOf::matrix;
    request.seed = Seed{options.seed.value + seed};
    request.randomisations = true;
    return form_factors::find_matrix(scene, request);
}

/// A row of each table.
void add_rates(const std::string& name, const Scene& scene, const Materials& materials,
               const form_factors::FormFactorCoverageOptions& options, FlowCoverage& coverage, const Known& known) {
    std::vector<Held> held(options.seeds);
    for_each_index(held.size(), options.threads, [&](std::uint64_t i) {
        const form_factors::Matrix matrix = sampled_matrix(scene, options, i);
        held[i] = held_by(flows_of(scene, matrix, materials, {}),
                          flows_of(scene, matrix, materials, {.statistical = true, .level = options.level}), known, i);
    });
    const auto add = [&](RateTable& table, auto has_held, RateClaim claim) {
        const auto hits = std::ranges::count_if(held, has_held);
        table.rates.push_back(
            {name, {.hits = static_cast<std::uint64_t>(hits), .trials = held.size()}, claim, options.level});
    };
    add(
        coverage.flows, [](const Held& one) { return one.bounds[0]; }, RateClaim::at_least);
    add(
        coverage.narrower, [](const Held& one) { return one.bounds[1]; }, RateClaim::none);
    add(
        coverage.statistical, [](const Held& one) { return one.statistical[0]; }, RateClaim::at_least);
    add(
        coverage.statistical_narrower, [](const Held& one) { return one.statistical[1]; }, RateClaim::none);
}

/// Adds a scene whose factors are all known, as where nothing is sampled.
void add_scene(const std::string& name, const Scene& scene, const KnownFactor& known, FlowCoverage& coverage) {
    const Materials materials = test_materials(scene.faces.size());
    const auto matrix = exact_matrix(known, sampled_matrix(scene, coverage.options, 0));
    if (!matrix) return;
    const Flows exact = find_flows(scene, *matrix, materials, 1);
    const Compare compare = [&](const Flows& found) { return compare_all(found, exact); };
    add_rates(name, scene, materials, coverage.options, coverage, {compare, compare});
}

/// Adds a scene of the catalogue, if some of its factors are sampled.
void add_scene_of_catalogue(const std::string& name, FlowCoverage& coverage) {
    const Scene scene = built_in_scene(name);
    const form_factors::Matrix matrix = sampled_matrix(scene, coverage.options, 0);
    if (std::none_of(matrix.exchanges.begin(), matrix.exchanges.end(),
                     [](const form_factors::FaceExchange& exchange) { return exchange.is_sampled(); }))
        return;
    add_scene(
        name, scene, [&](int from, int to) { return known_form_factor(scene, from, to); }, coverage);
}

/// Limits have to hold the reference's whole interval, so that its own uncertainty never makes them look better. Those
/// from cells are narrower than that of random walks, and statistical ones of rays are as well: these are compared with
/// bounds from cells.
void add_furnace(FlowCoverage& coverage) {
    const Bounds known = furnace_power();
    const Scene scene = furnace_scene();
    const auto block =
        static_cast<std::size_t>(std::find(scene.faces.begin(), scene.faces.end(), "block") - scene.faces.begin());
    const auto roof =
        static_cast<std::size_t>(std::find(scene.faces.begin(), scene.faces.end(), "roof") - scene.faces.begin());
    form_factors::FormFactorCoverageOptions by_rays = coverage.options;
    by_rays.cells = false;
    form_factors::FormFactorCoverageOptions fine = coverage.options;
    fine.tolerance = 1e-6;
    const Flows by_cells = find_flows(scene, sampled_matrix(scene, fine, 0), furnace_materials(), 1);
    const auto compare_with_walks = [&](const Flows& found) {
        return std::vector<Compared>{{found.faces[block].power, known},
                                     {found.faces[roof].power, {-known.high, -known.low}}};
    };
    add_rates("furnace", scene, furnace_materials(), by_rays, coverage,
              {compare_with_walks, [&](const Flows& found) { return compare_all(found, by_cells); }});
}

void add_row(const std::string& name, FlowCoverage& coverage) {
    if (name == "cube") {
        add_scene(name, built_in_scene(name), cube_factor, coverage);
    } else if (name == "annulus") {
        add_scene(name, annulus_scene(), annulus_factor, coverage);
    } else if (name == "furnace") {
        add_furnace(coverage);
    } else {
        add_scene_of_catalogue(name, coverage);
    }
}

}  // namespace

std::size_t FlowCoverage::contradictions() const {
    return flows.contradictions(level) + statistical.contradictions(level);
}

FlowCoverage measure_flow_coverage(const form_factors::FormFactorCoverageOptions& options) {
    FlowCoverage coverage;
    coverage.options = options;
    coverage.flows.title = "Limits of flows";
    coverage.flows.text =
        "How often the limits of all powers and temperatures of a scene contain the exact ones at once. They allow for "
        "all form factors within their intervals: rates above the level are intended. A run that refuses to answer "
        "or widens its intervals, because some row cannot add up to 1 within them counts as a miss.";
    coverage.narrower.title = "A tenth of these limits";
    coverage.narrower.text =
        "How often limits of a tenth of the width would contain them, which shows how cautious the limits are.";
    coverage.statistical.title = "Statistical intervals of flows";
    coverage.statistical.text =
        "How often the statistical interval of a power or temperature contains the exact one, each by itself: the "
        "first flow with the first seed, the next with the next, and so on. A run that refuses to answer counts as a "
        "miss.";
    coverage.statistical_narrower.title = "Half of these intervals";
    coverage.statistical_narrower.text =
        "How often half the width would contain it: 0.67 where the errors are normal and nothing is added for what no "
        "spread shows.";
    std::vector<std::string> names = options.scenes;
    if (names.empty()) {
        for (const std::string_view scene : configuration_scene_names()) names.emplace_back(scene);
        for (const char* const scene : {"cube", "annulus", "furnace"}) names.emplace_back(scene);
    }
    for (const std::string& name : names) add_row(name, coverage);
    coverage.level =
        1 - stats::sidak_level(1 - family_level, std::max<std::size_t>(1, 2 * coverage.flows.rates.size()));
    return coverage;
}

}  // namespace ff::studies::heat
