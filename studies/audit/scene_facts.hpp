#pragma once

#include "core/geometry/scene.hpp"
#include "core/visibility/pair_class.hpp"
#include "studies/published/published.hpp"
#include "studies/theory/sr_distribution.hpp"

#include <Eigen/Core>

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string_view>
#include <tuple>
#include <vector>

namespace ff::studies::audit {

/// Exact facts about the scene of published tables.
struct SceneFacts {
    Scene scene;
    std::optional<Eigen::MatrixXd> exact;      ///< [from, to]; empty where no elementary formula applies
    std::vector<std::size_t> pair_congruence;  ///< [from * faces + to]: equal numbers for congruent pairs
    std::vector<std::size_t> face_congruence;  ///< [face]: equal numbers for faces with congruent pairs

    [[nodiscard]] std::size_t faces() const { return scene.faces.size(); }
    [[nodiscard]] std::optional<std::size_t> face(std::string_view label) const;
};

/// @pre the scene is known and has the faces that figures name, as `parse_published_tables` sees to
SceneFacts scene_facts(const PublishedTables& tables);

/// Exact distributions of ray shooting by size. They take most of an audit's time, so audits of tables of one scene may
/// share them; results do not depend on that.
class DistributionCache {
  public:
    /// Empty where patches_per_face is not a square or above 10000, or the scene has no elementary formula.
    const std::optional<SrDistribution>& at(const SceneFacts& facts, std::uint32_t patches_per_face,
                                            std::uint64_t rays_per_face, Completion completion);

  private:
    std::map<std::uint32_t, std::optional<Eigen::MatrixXd>> patch_to_face_;
    std::map<std::tuple<std::uint32_t, std::uint64_t, Completion>, std::optional<SrDistribution>> distributions_;
};

}  // namespace ff::studies::audit
