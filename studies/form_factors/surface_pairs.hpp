#pragma once

#include "core/exact/pair_exchange.hpp"
#include "core/geometry/fwd.hpp"
#include "core/visibility/occluders.hpp"
#include "studies/form_factors/request.hpp"

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace ff::studies::form_factors {

/// Two faces (or one with itself) whose exchange area is known within a bound.
struct KnownPair {
    std::uint32_t from = 0;  ///< at most `to`
    std::uint32_t to = 0;
    double value = 0;                                     ///< exchange area, in squared units of length
    double bound = 0;                                     ///< bound of the error of `value`
    ExchangeMethod method = ExchangeMethod::none;         ///< the most expensive that a pair of surfaces needs
    ExchangeReason reason = ExchangeReason::turned_away;  ///< why `method` is needed
};

/// Two surfaces whose exchange has to be sampled, and their faces. There may be millions.
struct SampledPair {
    std::uint32_t face = 0;  ///< at most `other_face`
    std::uint32_t other_face = 0;
    std::uint32_t from = 0;  ///< index of the surface
    std::uint32_t to = 0;
    std::uint32_t first_blocker = 0;  ///< place of the first one in the list of all blockers
    std::uint16_t blockers = 0;
    ExchangeReason reason = ExchangeReason::turned_away;
    ExchangeMethod method = ExchangeMethod::rays;
    BoundedValue<double> whole;  ///< unoccluded exchange area; infinite where it is not known

    [[nodiscard]] bool is_whole_known() const { return std::isfinite(whole.value); }
    /// 2 within a face, where both orders count.
    [[nodiscard]] double times() const { return face == other_face && from != to ? 2 : 1; }
};

/// A list of such pairs, with what may stand in between.
class SampledPairs {
  public:
    /// @param occluders  own the blockers
    explicit SampledPairs(const Occluders& occluders) : walls_(occluders.walls()) {}

    void add(std::uint32_t face, std::uint32_t other_face, std::uint32_t from, std::uint32_t to,
             const PairExchange& exchange);
    /// @param pair  from another list with the same occluders
    void add(const SampledPair& pair, const SampledPairs& others);
    void reserve(std::size_t pairs, std::size_t blockers);
    /// Sorts by faces, then by surfaces.
    void sort();
    void shrink_to_fit();

    [[nodiscard]] std::size_t size() const { return pairs_.size(); }
    [[nodiscard]] std::size_t blockers() const { return blockers_.size(); }
    [[nodiscard]] const SampledPair& operator[](std::size_t k) const { return pairs_[k]; }
    [[nodiscard]] std::span<const SampledPair> part(std::size_t first, std::size_t count) const {
        return std::span(pairs_).subspan(first, count);
    }
    [[nodiscard]] PairExchange exchange(const SampledPair& pair) const;

  private:
    std::span<const Surface> walls_;
    std::vector<SampledPair> pairs_;
    std::vector<std::uint32_t> blockers_;  ///< index of the wall, and which end it has to face
};

/// A dropped pair needs little memory.
struct DroppedPair {
    std::uint32_t from = 0;
    std::uint32_t to = 0;
    float least = 0;
    float most = 0;
};

/// The pairs found in a visit.
struct Seen {
    std::vector<KnownPair> known;  ///< pairs of faces, one entry for each pair of surfaces
    SampledPairs open;
    std::vector<DroppedPair> dropped;
};

/// Looks at each pair of surfaces that belong to faces. @return what was found, part by part
/// @param areas  of the faces
/// @throws InterruptedError where the request is stopped and there are more pairs than can be kept as unknown
std::vector<Seen> look_at_pairs(const Scene& scene, const std::vector<double>& areas, const Occluders& occluders,
                                const Request& request);

}  // namespace ff::studies::form_factors
