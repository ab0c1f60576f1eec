#pragma once

#include "core/geometry/fwd.hpp"
#include "studies/form_factors/form_factors.hpp"
#include "studies/form_factors/request.hpp"
#include "studies/form_factors/surface_pairs.hpp"

#include <cstdint>
#include <memory>
#include <span>
#include <utility>
#include <vector>

namespace ff::studies::form_factors {

/// Two faces (or one with itself) that are sampled: the known part of their exchange area, and the part that is left.
struct FacePair {
    std::uint32_t from = 0;  ///< at most `to`
    std::uint32_t to = 0;
    std::uint32_t first = 0;  ///< place of its first pair of surfaces in FacePairs::sampled
    std::uint32_t count = 0;  ///< number of its pairs of surfaces; 0 where `everything` is sampled
    double known = 0;         ///< sum of what is known, in squared units of length
    double bound = 0;         ///< upper bound of its error
    double resolution = 0;    ///< possible effect of rounding coordinates that are, or were, large; 0 where it is small
    double most = 0;          ///< upper bound of the exchange area: the unoccluded one
    bool all_unblocked_known = true;  ///< `most` is the unblocked exchange area, not merely the area of a surface
    bool everything = false;          ///< all pairs of surfaces, too many to list
    bool by_cells = false;            ///< every sampled pair can be done in cells
    ExchangeReason reason = ExchangeReason::turned_away;  ///< why it is sampled
};

/// Adds a pair to both of its faces, which differ.
void add_dropped(std::vector<DroppedExchange>& faces, std::size_t from, std::size_t to, double value, double low,
                 double high);

struct FacePairs {
    explicit FacePairs(std::shared_ptr<const Occluders> owner) : sampled(*owner), occluders(std::move(owner)) {}

    // Both lists in the order (0,0), (0,1), .., (1,1), .. without pairs that cannot see each other, and without those
    // that are dropped.
    std::vector<KnownPair> known;
    std::vector<FacePair> pairs;           ///< those that are sampled
    SampledPairs sampled;                  ///< pairs of surfaces of `pairs`, in order
    std::vector<double> areas;             ///< area of each face, in squared units of length
    std::vector<DroppedExchange> dropped;  ///< one for each face
    std::shared_ptr<const Occluders> occluders;
    /// The surfaces to which the rays of each surface count, in order; empty if all rays count.
    std::vector<std::vector<std::uint32_t>> shot;

    [[nodiscard]] std::size_t faces() const { return areas.size(); }
    [[nodiscard]] std::span<const SampledPair> surfaces_of(const FacePair& pair) const {
        return sampled.part(pair.first, pair.count);
    }
    /// The face from which samples tell more about a sampled pair: the smaller one.
    [[nodiscard]] std::size_t owner(std::size_t pair) const {
        const FacePair& faces = pairs[pair];
        return areas[faces.to] < areas[faces.from] ? faces.to : faces.from;
    }
};

/// Sharper methods are used where an error would show beside the request's tolerance. Pairs not yet examined when the
/// request is stopped are left to be sampled.
/// @throws UserError for more faces than a matrix may have
FacePairs examine_pairs(const Scene& scene, const Request& request);

/// Widens what is known of each pair by the effect of coordinates that may be off by this much.
void allow_for_rounding(double rounding, const Scene& scene, FacePairs& pairs);

}  // namespace ff::studies::form_factors
