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
constexpr std::array shares{1.0, 0.1};  ///< of the widths

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

/// Whether limits with this share of their widths contain the known values.
bool holds(const Bounds& found, const Bounds& exact, double share) {
    const double room = exact.half_width() + 1e-12 * std::max(std::abs(exact.low), std::abs(exact.high));
    return found.middle() - share * found.half_width() - room <= exact.middle() &&
           exact.middle() <= found.middle() + share * found.half_width() + room;
}

bool all_hold(const Flows& found, const Flows& exact, double share) {
    for (std::size_t i = 0; i < found.faces.size(); ++i) {
        if (!holds(found.faces[i].power, exact.faces[i].power, share) ||
            !holds(found.faces[i].temperature, exact.faces[i].temperature, share))
            return false;
    }
    return true;
}

/// Empty where intervals miss the factors by so much that some row cannot add up to 1: the program then says so.
std::optional<Flows> flows_of(const Scene& scene, const form_factors::Matrix& matrix, const Materials& materials) {
    try {
        Flows flows = find_flows(scene, matrix, materials, 1);
        return flows.widened.empty() ? std::optional(std::move(flows)) : std::nullopt;
    } catch (const UserError&) {
        return std::nullopt;
    }
}

form_factors::Matrix sampled_matrix(const Scene& scene, const form_factors::FormFactorCoverageOptions& options,
                                    std::uint64_t seed) {
    form_factors::Request request;
    request.tolerance = options.tolerance;
    request.level = options.level;
    request.cells = options.cells;
    request.level_of = form_factors::LevelOf::matrix;
    request.seed = Seed{options.seed.value + seed};
    return form_factors::find_matrix(scene, request);
}

/// A row of each table. @param holds  whether flows, with this share of their widths, contain the known values
void add_rates(const std::string& name, const Scene& scene, const Materials& materials,
               const form_factors::FormFactorCoverageOptions& options, FlowCoverage& coverage,
               const std::function<bool(const Flows&, double share)>& holds) {
    std::vector<std::array<bool, shares.size()>> held(options.seeds);
    for_each_index(held.size(), options.threads, [&](std::uint64_t i) {
        const auto found = flows_of(scene, sampled_matrix(scene, options, i), materials);
        for (std::size_t k = 0; k < shares.size(); ++k) held[i].at(k) = found && holds(*found, shares.at(k));
    });
    const auto rate = [&](std::size_t k, RateClaim claim) {
        const auto hits = std::count_if(held.begin(), held.end(), [&](const auto& seed) { return seed.at(k); });
        return MeasuredRate{
            name, {.hits = static_cast<std::uint64_t>(hits), .trials = held.size()}, claim, options.level};
    };
    coverage.flows.rates.push_back(rate(0, RateClaim::at_least));
    coverage.narrower.rates.push_back(rate(1, RateClaim::none));
}

/// Adds a scene whose factors are all known, as where nothing is sampled.
void add_scene(const std::string& name, const Scene& scene, const KnownFactor& known, FlowCoverage& coverage) {
    const Materials materials = test_materials(scene.faces.size());
    const auto matrix = exact_matrix(known, sampled_matrix(scene, coverage.options, 0));
    if (!matrix) return;
    const Flows exact = find_flows(scene, *matrix, materials, 1);
    add_rates(name, scene, materials, coverage.options, coverage,
              [&](const Flows& found, double share) { return all_hold(found, exact, share); });
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
/// from cells are narrower than it.
void add_furnace(FlowCoverage& coverage) {
    const Bounds known = furnace_power();
    const Scene scene = furnace_scene();
    const auto block =
        static_cast<std::size_t>(std::find(scene.faces.begin(), scene.faces.end(), "block") - scene.faces.begin());
    const auto roof =
        static_cast<std::size_t>(std::find(scene.faces.begin(), scene.faces.end(), "roof") - scene.faces.begin());
    form_factors::FormFactorCoverageOptions by_rays = coverage.options;
    by_rays.cells = false;
    add_rates("furnace", scene, furnace_materials(), by_rays, coverage, [&](const Flows& found, double share) {
        const auto holds_all = [&](const Bounds& power, double sign) {
            const double middle = sign * power.middle();
            const double half = share * power.half_width();
            return middle - half <= known.low && known.high <= middle + half;
        };
        return holds_all(found.faces[block].power, 1) && holds_all(found.faces[roof].power, -1);
    });
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
    return flows.contradictions(level);
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
    std::vector<std::string> names = options.scenes;
    if (names.empty()) {
        for (const std::string_view scene : configuration_scene_names()) names.emplace_back(scene);
        for (const char* const scene : {"cube", "annulus", "furnace"}) names.emplace_back(scene);
    }
    for (const std::string& name : names) add_row(name, coverage);
    coverage.level = 1 - stats::sidak_level(1 - family_level, std::max<std::size_t>(1, coverage.flows.rates.size()));
    return coverage;
}

}  // namespace ff::studies::heat
