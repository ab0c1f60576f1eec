#include "studies/heat/heat.hpp"

#include "core/geometry/scene.hpp"
#include "core/radiosity/flow_bounds.hpp"
#include "core/support/error.hpp"
#include "studies/heat/factor_intervals.hpp"
#include "studies/heat/flow_statistics.hpp"
#include "studies/scene_files/orientation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <system_error>
#include <utility>

namespace ff::studies::heat {
namespace {

using Eigen::Index;

double power_of_black_body(double kelvin) {
    return stefan_boltzmann * kelvin * kelvin * kelvin * kelvin;
}

double temperature_of_black_body(double power) {
    return std::pow(power / stefan_boltzmann, 0.25);
}

/// Power per area that a light, or a face with a given temperature, emits.
double emitted_by(const Material& material) {
    if (material.is_light()) return material.emission.value_or(0);
    return *material.emissivity * power_of_black_body(*material.temperature);
}

bool lacks_surroundings(const Materials& materials) {
    return !materials.surroundings && !materials.are_light();
}

void expect_solvable(const Scene& scene, const FactorBounds& factors, const FaceLaws& laws,
                     const Materials& materials) {
    const auto face = [&](Index i) { return scene.faces[static_cast<std::size_t>(i)]; };
    const Index n = factors.low.rows();
    for (Index i = 0; i < n; ++i) {
        if (!can_add_up(factors, i))
            throw ImpossibleRow(
                "scene '{}': the form factors of face '{}' cannot add up to 1 (between {:.6g} and {:.6g}, with a "
                "probability of 0.999999). See the warnings of 'ffstudy form-factors' on this scene; a larger "
                "--tolerance allows for gaps of rounded corners.",
                scene.name, face(i), factors.low.row(i).sum(), factors.high.row(i).sum());
        if (!lacks_surroundings(materials) || !sees_out(factors, i)) continue;
        if (factors.low.coeff(i, n) == 0)
            throw UserError(
                "scene '{}': face '{}' may see out of the scene, with at most {:.3g} of its radiation. Add --closed "
                "where it cannot, or give surroundings = a temperature in the materials file.",
                scene.name, face(i), factors.high.coeff(i, n));
        throw UserError(
            "scene '{}': face '{}' sees out of the scene, or a surface of no face, with {:.3g} of its radiation. Give "
            "surroundings = a temperature in the materials file.",
            scene.name, face(i), factors.high.coeff(i, n));
    }
    const auto [absorption, cut_off] = find_absorption(factors, laws);
    if (absorption == Absorption::not_reached)
        throw UserError(
            "scene '{}': face '{}' and all that it sees have a flux and no temperature (so no "
            "temperatures are determined). Give one of them a temperature.",
            scene.name, face(cut_off));
    if (absorption == Absorption::unresolved)
        throw UnresolvedFlows(
            fmt::format("scene '{}': whether face '{}' sees any face with a temperature is not certain (the "
                        "intervals of its form factors begin at 0). Take a smaller --tolerance, or more time.",
                        scene.name, face(cut_off)));
}

/// An interval that includes the rounding of a few operations. @param size  of the largest number in them
Bounds rounded(double low, double high, double size) {
    const double slack = 8 * std::numeric_limits<double>::epsilon() * size;
    return {low - slack, high + slack};
}

/// @pre a flux can be absorbed
FaceFlow flow_of(const Material& material, double area, Bounds irradiation) {
    FaceFlow flow{.area = area, .radiosity = {}, .irradiation = irradiation, .net = {}, .power = {}, .temperature = {}};
    const double most = std::max(std::abs(irradiation.low), std::abs(irradiation.high));
    if (material.is_light() || material.temperature) {
        const double emitted = emitted_by(material);
        const double reflected = material.reflected();
        const double absorbed = material.absorbed();
        flow.radiosity = rounded(emitted + reflected * irradiation.low, emitted + reflected * irradiation.high,
                                 emitted + reflected * most);
        flow.net = rounded(emitted - absorbed * irradiation.high, emitted - absorbed * irradiation.low,
                           emitted + absorbed * most);
        if (material.temperature) flow.temperature = {*material.temperature, *material.temperature};
    } else {
        const double flux = *material.flux;
        flow.net = {flux, flux};
        flow.radiosity =
            flux == 0 ? irradiation : rounded(irradiation.low + flux, irradiation.high + flux, most + std::abs(flux));
        const double more = flux / *material.emissivity;
        // A true irradiation is large enough; the ends of a wide interval, or an estimate, need not be.
        flow.temperature = {temperature_of_black_body(std::max(0.0, irradiation.low + more)),
                            temperature_of_black_body(std::max(0.0, irradiation.high + more))};
    }
    flow.power = {flow.net.low * area, flow.net.high * area};
    return flow;
}

/// @throws UserError where a face is to absorb more than arrives, whatever the form factors
void expect_absorbable(const Scene& scene, const Materials& materials, const IrradiationBounds& irradiation) {
    double least = 0;
    std::size_t worst = 0;
    for (std::size_t i = 0; i < materials.faces.size(); ++i) {
        const Material& material = materials.faces[i];
        // Where too much is taken away elsewhere, even adiabatic faces would have negative irradiations.
        if (!material.flux || *material.flux >= 0) continue;
        const double black = irradiation.high[static_cast<Index>(i)] + *material.flux / *material.emissivity;
        if (black < least) worst = i;
        least = std::min(least, black);
    }
    if (least == 0) return;
    const Material& material = materials.faces[worst];
    const double most = *material.emissivity * std::max(0.0, irradiation.high[static_cast<Index>(worst)]);
    throw UserError(
        "face '{}': flux = {:g} W/m² (it can absorb at most {:.4g} W/m²). Give a flux nearer to 0, or a temperature.",
        scene.faces[worst], *material.flux, most);
}

void operator+=(Bounds& sum, const Bounds& more) {
    sum.low += more.low;
    sum.high += more.high;
}

Bounds positive_part(const Bounds& bounds) {
    return {std::max(0.0, bounds.low), std::max(0.0, bounds.high)};
}

/// What faces with positive powers, and surroundings that they take power from, give off.
Bounds given_off(const Flows& flows) {
    Bounds sum;
    if (flows.reaches_outside) sum = positive_part({-flows.balance.high, -flows.balance.low});
    for (const FaceFlow& face : flows.faces) sum += positive_part(face.power);
    return sum;
}

GroupFlow flow_of_group(const FaceGroup& group, const std::vector<FaceFlow>& faces, const Bounds& sources) {
    GroupFlow flow{group.name, group.faces.size(), 0, {}, {}};
    Bounds own;  // of its sources
    for (const std::size_t face : group.faces) {
        flow.area += faces[face].area;
        flow.power += faces[face].power;
        own += positive_part(faces[face].power);
    }
    // The share grows with what its own sources give off, and with that of others it gets nearer to 0.
    const Bounds others{sources.low - own.low, sources.high - own.high};
    const auto share = [](double power, double gives, double nearer, double farther) {
        return power / (gives + (power > 0 ? nearer : farther));
    };
    if (sources.low > 0)
        flow.share = Bounds{share(flow.power.low, own.low, others.high, others.low),
                            share(flow.power.high, own.high, others.low, others.high)};
    return flow;
}

Flows all_flows(const Materials& materials, const std::vector<double>& areas, double scale,
                const IrradiationBounds& irradiation, bool reaches_outside) {
    Flows found;
    found.reaches_outside = reaches_outside;
    for (std::size_t i = 0; i < areas.size(); ++i) {
        const auto row = static_cast<Index>(i);
        const FaceFlow& flow = found.faces.emplace_back(
            flow_of(materials.faces[i], areas[i] * scale * scale, {irradiation.low[row], irradiation.high[row]}));
        found.balance += flow.power;
    }
    const Bounds sources = given_off(found);
    for (const FaceGroup& group : materials.groups) found.groups.push_back(flow_of_group(group, found.faces, sources));
    return found;
}

/// Fills in what describes all flows together.
void sum_up(Flows& flows, const FaceLaws& laws) {
    for (std::size_t i = 0; i < flows.faces.size(); ++i) {
        const FaceFlow& flow = flows.faces[i];
        flows.throughput += std::max(0.0, flow.power.middle());
        flows.emitted += std::max(0.0, laws.emitted[static_cast<Index>(i)]) * flow.area;
        flows.exchanged += std::max(0.0, flow.radiosity.high) * flow.area;
        flows.worst = std::max(flows.worst, flow.power.half_width());
    }
    if (flows.balance.middle() < 0) flows.throughput += -flows.balance.middle();  // what the surroundings give off
}

}  // namespace

FlowTolerance read_flow_tolerance(std::string_view place, std::string_view text) {
    FlowTolerance tolerance;
    const char* const end = text.data() + text.size();
    const auto [rest, error] = std::from_chars(text.data(), end, tolerance.amount);
    std::string_view unit(rest, static_cast<std::size_t>(end - rest));
    if (unit.starts_with(' ')) unit.remove_prefix(1);
    if (unit == "%") tolerance.amount /= 100;
    tolerance.is_power = unit == "W";
    const bool is_known = error == std::errc{} && (unit.empty() || unit == "%" || unit == "W");
    if (is_known && tolerance.amount > 0 && std::isfinite(tolerance.amount) &&
        (tolerance.is_power || tolerance.amount < 1))
        return tolerance;
    throw UserError("{} {} (a share above 0 and below 1, or watts). Write 0.001, 0.1% or 40W.", place, text);
}

std::string in_words(const FlowTolerance& tolerance) {
    return tolerance.is_power ? fmt::format("{:g}W", tolerance.amount) : fmt::format("{:g}%", 100 * tolerance.amount);
}

FaceLaws laws_of(const Materials& materials) {
    const auto n = static_cast<Index>(materials.faces.size());
    FaceLaws laws{Eigen::VectorXd(n), Eigen::VectorXd(n), 0};
    for (Index i = 0; i < n; ++i) {
        const Material& material = materials.faces[static_cast<std::size_t>(i)];
        const bool is_given = material.is_light() || material.temperature;
        laws.emitted[i] = is_given ? emitted_by(material) : *material.flux;
        laws.reflected[i] = is_given ? material.reflected() : 1;
    }
    if (materials.surroundings)
        laws.surroundings =
            materials.are_light() ? *materials.surroundings : power_of_black_body(*materials.surroundings);
    return laws;
}

bool Flows::are_at_rest() const {
    constexpr double rounding = 1e-9;
    return std::all_of(faces.begin(), faces.end(), [&](const FaceFlow& face) {
        const auto [low, high] = face.power;
        return low <= 0 && high >= 0 && std::max(-low, high) <= rounding * exchanged;
    });
}

Flows find_flows(const Scene& scene, const form_factors::Matrix& matrix, const Materials& materials, double scale,
                 const FlowIntervals& intervals) {
    const auto [factors, widened] = possible_factors(scene, matrix);
    const FaceLaws laws = laws_of(materials);
    expect_solvable(scene, factors, laws, materials);
    const bool takes_away = std::ranges::any_of(
        materials.faces, [](const Material& material) { return material.flux && *material.flux < 0; });
    std::optional<IrradiationBounds> limits;
    if (takes_away || !intervals.statistical) limits = bound_irradiation(factors, laws);
    if (takes_away) expect_absorbable(scene, materials, *limits);
    const bool outside = sees_out(factors);
    const auto flows_of = [&](const IrradiationBounds& bounds) {
        return all_flows(materials, matrix.areas, scale, bounds, outside);
    };
    std::optional<Flows> statistical;
    if (intervals.statistical) statistical = statistical_flows(scene, matrix, materials, scale, intervals, flows_of);
    if (!statistical && !limits) limits = bound_irradiation(factors, laws);
    Flows found = statistical ? std::move(*statistical) : flows_of(*limits);
    if (!found.statistical) found.widened = widened;
    sum_up(found, laws);
    return found;
}

void expect_surroundings(const Scene& scene, const std::vector<Materials>& cases) {
    if (scene.closed || std::ranges::none_of(cases, lacks_surroundings)) return;
    if (const auto open = face_open_to_outside(scene))
        throw UserError(
            "scene '{}': face '{}' sees out of the scene, with more than half of the radiation of one of its surfaces. "
            "Give surroundings = a temperature in the materials file.",
            scene.name, scene.faces[*open]);
}

std::vector<SolvedCase> solve_cases(const Scene& scene, const form_factors::Matrix& matrix,
                                    std::vector<Materials> cases, double scale, const FlowIntervals& intervals) {
    std::vector<SolvedCase> solved;
    for (Materials& one : cases) {
        try {
            Flows flows = find_flows(scene, matrix, one, scale, intervals);
            solved.push_back({std::move(one), std::move(flows)});
        } catch (const InconclusiveFlows&) {
            throw;
        } catch (const UserError& error) {
            if (one.name.empty()) throw;
            throw UserError("case '{}': {}", one.name, error.what());
        }
    }
    return solved;
}

std::vector<GebhartFactor> find_gebhart_factors(const Scene& scene, const form_factors::Matrix& matrix,
                                                const Materials& materials) {
    const FactorBounds factors = possible_factors(scene, matrix).bounds;
    const auto n = static_cast<Index>(matrix.faces());
    const bool open = sees_out(factors);
    const auto columns = static_cast<std::size_t>(open ? n + 1 : n);
    FaceLaws laws{Eigen::VectorXd::Zero(n), Eigen::VectorXd(n), 0};
    for (Index i = 0; i < n; ++i) laws.reflected[i] = materials.faces[static_cast<std::size_t>(i)].reflected();
    expect_solvable(scene, factors, laws, materials);
    const FlowBounds bounds(factors, laws.reflected);
    std::vector<GebhartFactor> found(columns * matrix.faces());
    // Radiation that leaves a face meets others, where it is absorbed, or is reflected and meets others again: it acts
    // as an irradiation.
    for (std::size_t to = 0; to < columns; ++to) {
        Eigen::VectorXd absorbed = Eigen::VectorXd::Zero(n);
        const auto column = static_cast<Index>(to);
        if (column < n) absorbed[column] = materials.faces[to].absorbed();
        const IrradiationBounds share = bounds.irradiation(absorbed, column < n ? 0 : 1);
        for (Index from = 0; from < n; ++from) {
            const Bounds gebhart{std::clamp(share.low[from], 0.0, 1.0), std::clamp(share.high[from], 0.0, 1.0)};
            const double emissivity = materials.faces[static_cast<std::size_t>(from)].absorbed();
            found[static_cast<std::size_t>(from) * columns + to] = {
                static_cast<std::size_t>(from), to, gebhart, {emissivity * gebhart.low, emissivity * gebhart.high}};
        }
    }
    return found;
}

}  // namespace ff::studies::heat
