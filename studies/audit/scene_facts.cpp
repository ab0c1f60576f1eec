#include "studies/audit/scene_facts.hpp"

#include "core/exact/exact.hpp"
#include "core/geometry/surface_map.hpp"
#include "core/visibility/facing.hpp"
#include "studies/form_factors/form_factors.hpp"
#include "studies/scene_files/scene_file.hpp"

#include <algorithm>
#include <cmath>

namespace ff::studies::audit {
namespace {

constexpr double alike = 1e-9;
constexpr std::uint32_t most_patches = 10000;  // a face; more take seconds and hardly change sigma

std::vector<std::size_t> congruent_pairs(const Scene& scene, const Eigen::MatrixXd& exact) {
    const auto faces = static_cast<int>(scene.faces.size());
    std::vector<std::pair<double, PairClass>> kinds;
    std::vector<std::size_t> result;
    for (int i = 0; i < faces; ++i) {
        for (int j = 0; j < faces; ++j) {
            const std::pair kind{exact(i, j), pair_class(scene, i, j)};
            const auto same = std::ranges::find_if(kinds, [&](const auto& other) {
                return other.second == kind.second && std::abs(other.first - kind.first) < alike * kind.first;
            });
            result.push_back(static_cast<std::size_t>(same - kinds.begin()));
            if (same == kinds.end()) kinds.push_back(kind);
        }
    }
    return result;
}

std::vector<std::size_t> congruent_faces(std::size_t faces, const std::vector<std::size_t>& pairs) {
    std::vector<std::vector<std::size_t>> rows;
    std::vector<std::size_t> result;
    for (std::size_t i = 0; i < faces; ++i) {
        std::vector<std::size_t> row(pairs.begin() + static_cast<std::ptrdiff_t>(i * faces),
                                     pairs.begin() + static_cast<std::ptrdiff_t>((i + 1) * faces));
        std::ranges::sort(row);
        const auto same = std::ranges::find(rows, row);
        result.push_back(static_cast<std::size_t>(same - rows.begin()));
        if (same == rows.end()) rows.push_back(row);
    }
    return result;
}

/// Largest relative error of each face's area. Edges are at most pi times as long as the diagonals, and are off by
/// sqrt(3) times the rounding of coordinates; half as much again leaves room for what is of second order.
std::vector<double> area_errors(const Scene& scene, const std::vector<double>& areas) {
    constexpr double of_diagonals = 8;
    std::vector<double> errors(areas.size());
    for (const Surface& surface : scene.surfaces) {
        if (surface.face < 0) continue;
        const auto face = static_cast<std::size_t>(surface.face);
        errors[face] += of_diagonals * scene.coordinate_rounding * box_around(surface).diagonal().norm() / areas[face];
    }
    return errors;
}

/// Limits that all hold at once, except with probability 1e-6, which is far below the other risks of the audit.
void find_limits(SceneFacts& facts) {
    namespace matrices = form_factors;
    matrices::Request request;
    request.level = 1 - 1e-6;
    request.level_of = matrices::LevelOf::matrix;
    request.max_samples = 2'000'000;  // seconds
    for (const matrices::FaceExchange& exchange : matrices::find_matrix(*facts.scene, request).exchanges) {
        for (const auto& [from, to] : {std::pair(exchange.from, exchange.to), std::pair(exchange.to, exchange.from)}) {
            facts.low(from, to) = exchange.low / facts.areas[from];
            facts.high(from, to) = exchange.high / facts.areas[from];
        }
    }
}

}  // namespace

Range SceneFacts::factor(std::size_t from, std::size_t to) const {
    const auto i = static_cast<Eigen::Index>(from);
    const auto j = static_cast<Eigen::Index>(to);
    return {low(i, j), high(i, j)};
}

std::optional<std::size_t> SceneFacts::face(std::string_view label) const {
    const auto found = std::ranges::find(labels, label);
    if (found == labels.end()) return std::nullopt;
    return static_cast<std::size_t>(found - labels.begin());
}

SceneFacts scene_facts(const PublishedTables& tables) {
    SceneFacts facts;
    facts.scene = std::make_shared<const Scene>(make_scene(tables.scene));
    const Scene& scene = *facts.scene;
    facts.labels = scene.faces;
    facts.closed = scene.closed;
    facts.has_certain_areas = scene.coordinate_rounding == 0;
    const std::size_t faces = facts.faces();
    for (int i = 0; i < static_cast<int>(faces); ++i) {
        facts.areas.push_back(face_area(scene, i));
        facts.sees_itself.push_back(sees_itself(scene, i));
    }
    facts.area_error = area_errors(scene, facts.areas);
    if (scene.empty_box) facts.exact = exact_form_factors(scene);
    if (facts.exact) {
        facts.low = facts.high = *facts.exact;
        facts.pair_congruence = congruent_pairs(scene, *facts.exact);
        facts.face_congruence = congruent_faces(faces, facts.pair_congruence);
    } else {
        facts.low = facts.high =
            Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(faces), static_cast<Eigen::Index>(faces));
        if (!tables.figures.empty()) find_limits(facts);
        for (std::size_t k = 0; k < faces * faces; ++k) facts.pair_congruence.push_back(k);
        for (std::size_t k = 0; k < faces; ++k) facts.face_congruence.push_back(k);
    }
    return facts;
}

double reach_of_chance(double sigma, double hit, double z_limit) {
    const double few = z_limit * z_limit * hit / 6;
    return few + std::hypot(few, z_limit * sigma);
}

double most_sigma(const SceneFacts& facts, const std::optional<SrDistribution>& distribution, std::uint64_t rays,
                  std::size_t from, std::size_t to) {
    if (distribution) return distribution->pair_sigma(static_cast<int>(from), static_cast<int>(to));
    const Range factor = facts.factor(from, to);
    const double worst = std::clamp(0.5, factor.low, factor.high);
    return std::sqrt(worst * std::max(0.0, 1 - worst) / static_cast<double>(rays));
}

const std::optional<SrDistribution>& DistributionCache::at(const SceneFacts& facts, std::uint32_t patches_per_face,
                                                           std::uint64_t rays_per_face, Completion completion) {
    const std::tuple key{patches_per_face, rays_per_face, completion};
    const auto known = distributions_.find(key);
    if (known != distributions_.end()) return known->second;
    const auto m = static_cast<std::uint32_t>(std::lround(std::sqrt(patches_per_face)));
    const auto [factors, is_new] = patch_to_face_.try_emplace(patches_per_face);
    if (is_new && facts.exact && m * m == patches_per_face && patches_per_face <= most_patches)
        factors->second = exact_patch_to_face(*facts.scene, Subdivision{m});
    std::optional<SrDistribution> distribution;
    if (factors->second) {
        const double rays_per_patch = static_cast<double>(rays_per_face) / patches_per_face;
        distribution = sr_distribution(*facts.scene, Subdivision{m}, *factors->second, rays_per_patch, completion);
    }
    return distributions_.emplace(key, std::move(distribution)).first->second;
}

}  // namespace ff::studies::audit
