#pragma once

#include "core/exact/pair_exchange.hpp"
#include "core/geometry/scene.hpp"
#include "studies/form_factors/request.hpp"

#include <array>
#include <cstdint>
#include <vector>

namespace ff::studies {

inline constexpr std::size_t exchange_methods = 7;

/// Two surfaces whose exchange has to be sampled, and how often it counts.
struct SampledPair {
    std::uint32_t from = 0;  ///< index of the surface
    std::uint32_t to = 0;
    double times = 1;  ///< 2 within a face, where both orders count
    PairExchange exchange;
};

/// Where a pair of faces, in either order, is among (0,0), (0,1), .., (1,1), ..
std::size_t pair_index(std::size_t a, std::size_t b, std::size_t faces);

/// Two faces (or one and itself): what is known of their exchange area, and what is left to be sampled.
struct FacePair {
    std::size_t from = 0;  ///< at most `to`
    std::size_t to = 0;
    double known = 0;       ///< sum of what is known, in squared units of length
    double bound = 0;       ///< that it is off by at most
    double resolution = 0;  ///< what rounding of the scene's largest coordinates may change; 0 where it is little
    double most = 0;        ///< the exchange area is not larger: as if nothing stood in between
    bool all_unblocked_known = true;   ///< `most` is the unblocked exchange area, not just what a surface can send
    std::vector<SampledPair> sampled;  ///< empty where `everything` is sampled
    bool everything = false;           ///< all pairs of surfaces, too many to list
    bool by_points = false;            ///< every sampled pair can be done by points
    std::array<std::size_t, exchange_methods> methods{};  ///< pairs of surfaces by method
    ExchangeReason reason = ExchangeReason::turned_away;  ///< of the dearest of them

    [[nodiscard]] bool is_sampled() const { return everything || !sampled.empty(); }
};

/// How much is spent on a pair before anything is known of it by points.
enum class PointEffort : std::uint8_t {
    full,   ///< what its tolerance alone may be worth: intervals are sharp from the first round on
    sized,  ///< by what can pass, in tolerances: for scenes of so many pairs that most of the time would go there
};

struct FacePairs {
    std::vector<FacePair> pairs;  ///< (0,0), (0,1), .., (1,1), ..
    std::vector<double> areas;    ///< of the faces
    PointEffort effort = PointEffort::full;
    SceneSight sight;  ///< owns the blockers of sampled pairs
    /// Whether rays between two surfaces count, [from * surfaces + to]; empty where all do.
    std::vector<std::uint8_t> shot;

    [[nodiscard]] std::size_t faces() const { return areas.size(); }
    /// Where a pair of faces is in `pairs`.
    [[nodiscard]] std::size_t index(std::size_t a, std::size_t b) const { return pair_index(a, b, faces()); }
};

/// Sharper methods are taken where their error would show beside the request's tolerance. What has not been looked at
/// when the request is stopped, is left to be sampled.
/// @throws UserError for more faces than a matrix is made of
FacePairs examine_pairs(const Scene& scene, const FormFactorRequest& request);

}  // namespace ff::studies
