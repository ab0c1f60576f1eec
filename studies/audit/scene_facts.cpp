#include "studies/audit/scene_facts.hpp"

#include "core/configurations/built_in_scene.hpp"
#include "core/exact/exact.hpp"

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
            const auto same = std::find_if(kinds.begin(), kinds.end(), [&](const auto& other) {
                return other.second == kind.second && std::abs(other.first - kind.first) < alike;
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
        std::sort(row.begin(), row.end());
        const auto same = std::find(rows.begin(), rows.end(), row);
        result.push_back(static_cast<std::size_t>(same - rows.begin()));
        if (same == rows.end()) rows.push_back(row);
    }
    return result;
}

}  // namespace

std::optional<std::size_t> SceneFacts::face(std::string_view label) const {
    const auto found = std::find(scene.faces.begin(), scene.faces.end(), label);
    if (found == scene.faces.end()) return std::nullopt;
    return static_cast<std::size_t>(found - scene.faces.begin());
}

SceneFacts scene_facts(const PublishedTables& tables) {
    SceneFacts facts;
    facts.scene = built_in_scene(tables.scene);
    if (facts.scene.empty_box) facts.exact = exact_form_factors(facts.scene);
    const std::size_t faces = facts.faces();
    if (facts.exact) {
        facts.pair_congruence = congruent_pairs(facts.scene, *facts.exact);
        facts.face_congruence = congruent_faces(faces, facts.pair_congruence);
    } else {
        for (std::size_t k = 0; k < faces * faces; ++k) facts.pair_congruence.push_back(k);
        for (std::size_t k = 0; k < faces; ++k) facts.face_congruence.push_back(k);
    }
    return facts;
}

const std::optional<SrDistribution>& DistributionCache::at(const SceneFacts& facts, std::uint32_t patches_per_face,
                                                           std::uint64_t rays_per_face, Completion completion) {
    const std::tuple key{patches_per_face, rays_per_face, completion};
    const auto known = distributions_.find(key);
    if (known != distributions_.end()) return known->second;
    auto factors = patch_to_face_.find(patches_per_face);
    if (factors == patch_to_face_.end()) {
        const auto m = static_cast<std::uint32_t>(std::lround(std::sqrt(patches_per_face)));
        std::optional<Eigen::MatrixXd> exact;
        if (facts.exact && m * m == patches_per_face && patches_per_face <= most_patches)
            exact = exact_patch_to_face(facts.scene, Subdivision{m});
        factors = patch_to_face_.emplace(patches_per_face, std::move(exact)).first;
    }
    std::optional<SrDistribution> distribution;
    if (factors->second) {
        const double rays_per_patch = static_cast<double>(rays_per_face) / patches_per_face;
        const auto m = static_cast<std::uint32_t>(std::lround(std::sqrt(patches_per_face)));
        distribution = sr_distribution(facts.scene, Subdivision{m}, *factors->second, rays_per_patch, completion);
    }
    return distributions_.emplace(key, std::move(distribution)).first->second;
}

}  // namespace ff::studies::audit
