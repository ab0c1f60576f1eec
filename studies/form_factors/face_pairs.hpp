#pragma once

#include "core/exact/pair_exchange.hpp"
#include "core/geometry/scene.hpp"
#include "studies/form_factors/request.hpp"

#include <cstdint>
#include <vector>

namespace ff::studies {

/// Of larger matrices what is 0 by geometry is not written, and nothing takes the square of the faces in memory.
inline constexpr std::size_t most_dense_faces = 4096;

/// Two surfaces whose exchange has to be sampled, and how often it counts.
struct SampledPair {
    std::uint32_t from = 0;  ///< index of the surface
    std::uint32_t to = 0;
    double times = 1;  ///< 2 within a face, where both orders count
    PairExchange exchange;
};

/// Pairs that so many faces make, each with itself among them.
std::size_t pairs_of(std::size_t faces);

/// Of each face the places of its pairs in a list, by the other face.
/// @param pairs  with members `from` and `to`, in the order (0,0), (0,1), .., (1,1), ..
template <class Pairs>
std::vector<std::vector<std::uint32_t>> by_face(const Pairs& pairs, std::size_t faces) {
    std::vector<std::vector<std::uint32_t>> result(faces);
    for (std::size_t p = 0; p < pairs.size(); ++p) {
        result[pairs[p].from].push_back(static_cast<std::uint32_t>(p));
        if (pairs[p].from != pairs[p].to) result[pairs[p].to].push_back(static_cast<std::uint32_t>(p));
    }
    return result;
}

/// Two faces (or one and itself): what is known of their exchange area, and what is left to be sampled.
struct FacePair {
    std::uint32_t from = 0;  ///< at most `to`
    std::uint32_t to = 0;
    double known = 0;       ///< sum of what is known, in squared units of length
    double bound = 0;       ///< that it is off by at most
    double resolution = 0;  ///< what rounding of the scene's largest coordinates may change; 0 where it is little
    double most = 0;        ///< the exchange area is not larger: as if nothing stood in between
    bool all_unblocked_known = true;   ///< `most` is the unblocked exchange area, not just what a surface can send
    std::vector<SampledPair> sampled;  ///< empty where `everything` is sampled
    bool everything = false;           ///< all pairs of surfaces, too many to list
    bool by_points = false;            ///< every sampled pair can be done by points
    ExchangeMethod method = ExchangeMethod::none;         ///< the most expensive that a pair of surfaces needs
    ExchangeReason reason = ExchangeReason::turned_away;  ///< of that

    [[nodiscard]] bool is_sampled() const { return everything || !sampled.empty(); }
};

/// How much is spent on a pair before anything is known of it by points.
enum class PointEffort : std::uint8_t {
    full,   ///< what its tolerance alone may be worth: intervals are sharp from the first round on
    sized,  ///< by what can pass, in tolerances: for scenes of so many pairs that most of the time would go there
};

struct FacePairs {
    std::vector<FacePair> pairs;  ///< (0,0), (0,1), .., (1,1), .. without those that cannot see each other
    std::vector<double> areas;    ///< of the faces
    PointEffort effort = PointEffort::full;
    SceneSight sight;  ///< owns the blockers of sampled pairs
    /// Whether rays between two surfaces count, [from * surfaces + to]; empty where all do.
    std::vector<bool> shot;

    [[nodiscard]] std::size_t faces() const { return areas.size(); }
};

/// Sharper methods are taken where their error would show beside the request's tolerance. What has not been looked at
/// when the request is stopped, is left to be sampled.
/// @throws UserError for more faces than a matrix is made of
FacePairs examine_pairs(const Scene& scene, const FormFactorRequest& request);

}  // namespace ff::studies
