#include "studies/radiosity/enclosure_study.hpp"

#include "core/configurations/built_in_scene.hpp"
#include "core/geometry/scene.hpp"
#include "core/support/error.hpp"
#include "core/support/nearest_name.hpp"
#include "core/support/words.hpp"
#include "studies/radiosity/collector.hpp"
#include "studies/radiosity/systems.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

namespace ff::studies::radiosity {
namespace {

using std::numbers::pi;

constexpr double interval_level = 0.95;
constexpr std::array<std::string_view, 6> kinds{"cylinder", "cap", "cone", "spheres", "box", "cube"};

[[noreturn]] void fail(std::string_view name, std::string_view problem) {
    throw UserError("enclosure {} {}", name, problem);
}

/// The two lengths of "kind:AxB".
std::pair<double, double> lengths(std::string_view name) {
    const auto parts = split_at('x', name.substr(std::min(name.size(), name.find(':') + 1)));
    const double first = parse_bare_number<double>(parts.front()).value_or(0);
    const double second = parse_bare_number<double>(parts.back()).value_or(0);
    const auto is_length = [](double value) { return value >= 1e-70 && value <= 1e70; };
    if (parts.size() != 2 || !is_length(first) || !is_length(second))
        fail(name, "(expected two lengths from 1e-70 to 1e70). Write it like cylinder:1x2.");
    return {first, second};
}

NamedEnclosure mirrored_box(std::string_view name, const std::optional<std::string>& mirror) {
    const Scene scene = built_in_scene(name);
    if (!mirror) fail(name, "without a mirror is a scene: see ffstudy radiosity. Add --mirror 6.");
    const auto face = std::find(scene.faces.begin(), scene.faces.end(), *mirror);
    if (face == scene.faces.end())
        fail(name, fmt::format("has no face '{}' to be a mirror. Its faces are 1 to {}.", *mirror, scene.faces.size()));
    NamedEnclosure named{
        fmt::format("the inside of {} with face {} a perfect mirror: factors straight and by way of it", name, *mirror),
        scene.faces, box_with_mirror(scene, static_cast<int>(face - scene.faces.begin())).value()};
    named.surfaces.erase(named.surfaces.begin() + (face - scene.faces.begin()));
    return named;
}

Lighting light(const NamedEnclosure& named, const RadiosityRequest& request) {
    const Eigen::Index n = named.enclosure.areas.size();
    const auto size = static_cast<std::size_t>(n);
    if (request.emission.size() > 1 && request.emission.size() != size)
        fail(named.description, fmt::format("has {} surfaces, --emission {} numbers. Give one, or one for each.", size,
                                            request.emission.size()));
    Lighting lighting;
    lighting.elements = {named.enclosure.areas, (named.enclosure.factors.array() > 0).eval()};
    lighting.exact = named.enclosure.factors;
    for (const auto& setting : request.reflectance)
        lighting.reflectance.emplace_back(Eigen::VectorXd::Constant(n, setting.front()));
    lighting.emission = for_faces(request.emission, n);
    return lighting;
}

/// The shares of independent rays that fall on each surface.
Eigen::MatrixXd draw(const Eigen::MatrixXd& factors, StreamKey key, std::uint32_t trial, std::uint64_t rays) {
    Eigen::MatrixXd hits = Eigen::MatrixXd::Zero(factors.rows(), factors.cols());
    for (Eigen::Index from = 0; from < factors.rows(); ++from) {
        const Stream stream{.key = key, .trial = trial, .source = static_cast<std::uint32_t>(from)};
        for (std::uint64_t ray = 0; ray < rays; ++ray) {
            const Words words = philox(stream, static_cast<std::uint32_t>(ray), Purpose::coordinates);
            const std::uint64_t bits = (std::uint64_t{words[0]} << 32 | words[1]) >> 11;
            double left = static_cast<double>(bits) * 0x1p-53 * factors.row(from).sum();
            Eigen::Index to = 0;
            while (to + 1 < factors.cols() && left >= factors(from, to)) left -= factors(from, to++);
            hits(from, to) += 1;
        }
    }
    return hits / static_cast<double>(rays);
}

}  // namespace

NamedEnclosure find_enclosure(std::string_view name, const std::optional<std::string>& mirror) {
    const std::string_view kind = name.substr(0, name.find(':'));
    if (kind == "box" || kind == "cube") return mirrored_box(name, mirror);
    if (std::find(kinds.begin(), kinds.end(), kind) == kinds.end())
        fail(name, fmt::format("(unknown). Did you mean {}? There are {}.", nearest_name(kind, kinds),
                               fmt::join(kinds, ", ")));
    if (mirror) fail(name, "(only a face of a box can be a mirror). Leave --mirror out.");
    const auto [a, b] = lengths(name);
    if (kind == "cylinder") {
        return {fmt::format("a cylinder of radius {} and height {} from inside", a, b),
                {"base", "top", "wall"},
                closed_cylinder(a, b)};
    }
    if (kind == "cap") {
        if (b >= 2 * a) fail(name, "(the cap is higher than its sphere). Take H below 2 R.");
        return {fmt::format("a cap of height {} of a sphere of radius {}, and the disk that closes it", b, a),
                {"cap", "disk"},
                cavity(2 * pi * a * b, pi * b * (2 * a - b))};
    }
    if (kind == "cone") {
        return {fmt::format("a cone of radius {} and height {} from inside", a, b),
                {"wall", "base"},
                cavity(pi * a * std::hypot(a, b), pi * a * a)};
    }
    if (b >= a) fail(name, "(the inner sphere is no smaller than the outer one). Take S below R.");
    return {fmt::format("a sphere of radius {} from inside, and one of radius {} in it", a, b),
            {"outer", "inner"},
            cavity(4 * pi * a * a, 4 * pi * b * b)};
}

EnclosureResults study_enclosure(const EnclosureRequest& request) {
    constexpr std::uint64_t most = std::uint64_t{1} << 32;
    if (request.trials == 1 || request.trials > most)
        throw UserError("--trials {} (0 for exact factors only, or 2 to 2^32). Try 1000.", request.trials);
    if (request.trials > 0 && (request.rays == 0 || request.rays > most))
        throw UserError("--rays {} (1 to 2^32 from each surface). Try 1000.", request.rays);
    EnclosureResults results{find_enclosure(request.name, request.mirror), {}, {}, {}};
    const Lighting lighting = light(results.of, request.light);
    results.emission = lighting.emission;
    const SolverOptions options{.tolerance = request.light.tolerance};
    const auto always = [](std::size_t) { return true; };
    const auto exitance = solve_with_exact_factors(lighting, options, 0, 0, always, results.exact);
    if (request.trials == 0) return results;
    std::vector<ConsequencesCollector> collectors;
    for (const Treatment treatment : all_treatments) {
        collectors.emplace_back(lighting, exitance, Between::faces, treatment,
                                std::vector(exitance.size(), request.light.solver_trials), options);
    }
    const StreamKey key = derive_key(
        request.seed, fmt::format("enclosure {}|{}|n={}", request.name, request.mirror.value_or(""), request.rays));
    const auto rays = Eigen::VectorXd::Constant(lighting.exact.rows(), static_cast<double>(request.rays)).eval();
    for (std::uint64_t trial = 0; trial < request.trials; ++trial) {
        const Eigen::MatrixXd direct = draw(lighting.exact, key, static_cast<std::uint32_t>(trial), request.rays);
        for (ConsequencesCollector& collector : collectors) collector.add(direct, rays);
    }
    for (ConsequencesCollector& collector : collectors)
        results.consequences.push_back(collector.finish(0, interval_level));
    return results;
}

}  // namespace ff::studies::radiosity
