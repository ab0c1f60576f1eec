#pragma once

#include "core/geometry/fwd.hpp"
#include "core/visibility/pair_class.hpp"
#include "studies/audit/printed_number.hpp"
#include "studies/published/published.hpp"
#include "studies/theory/sr_distribution.hpp"

#include <Eigen/Core>

#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <tuple>
#include <vector>

namespace ff::studies::audit {

/// The known facts about the scene of published tables.
struct SceneFacts {
    std::shared_ptr<const Scene> scene;
    std::vector<std::string> labels;  ///< of the faces
    bool closed = false;
    bool has_certain_areas = true;   ///< coordinates are not rounded
    std::vector<double> areas;       ///< area of each face
    std::vector<double> area_error;  ///< largest relative error of each area, where coordinates of a file are rounded
    std::vector<bool> sees_itself;   ///< for each face, whether it sees itself
    std::optional<Eigen::MatrixXd> exact;  ///< [from, to]; of the inside of a box only
    Eigen::MatrixXd low;                   ///< limits of all factors, [from, to]: equal to `exact` where there is one
    Eigen::MatrixXd high;
    /// [from * faces + to]: equal numbers for congruent pairs. Only a box has some: elsewhere they could not be told
    /// from pairs that are equal by chance.
    std::vector<std::size_t> pair_congruence;
    std::vector<std::size_t> face_congruence;  ///< [face]: equal numbers for faces with congruent pairs

    [[nodiscard]] Range factor(std::size_t from, std::size_t to) const;
    [[nodiscard]] bool can_see(std::size_t from, std::size_t to) const { return from != to || sees_itself[from]; }
    [[nodiscard]] std::size_t faces() const { return labels.size(); }
    [[nodiscard]] std::optional<std::size_t> face(std::string_view label) const;
};

/// Where no formula gives all factors, they are those of `ffstudy form-factors`, with its intervals.
/// @pre the scene is known and has the faces that figures name, as `parse_published_tables` sees to
SceneFacts scene_facts(const PublishedTables& tables);

/// How far chance takes a sum of independent hits from its mean: `z_limit` standard deviations, and a few hits more, as
/// rare hits are not normally distributed (Bernstein's inequality; exp(-z_limit^2 / 2) bounds the risk of each side).
/// @param hit  the most that one hit adds to the sum
double reach_of_chance(double sigma, double hit, double z_limit);

/// Standard deviation of the share of a face's own rays that hit another: of the exact distribution, otherwise an upper
/// bound, that of rays which start anywhere on the face. Patches of equal area make it smaller.
double most_sigma(const SceneFacts& facts, const std::optional<SrDistribution>& distribution, std::uint64_t rays,
                  std::size_t from, std::size_t to);

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
