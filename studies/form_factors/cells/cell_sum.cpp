#include "studies/form_factors/cells/cell_sum.hpp"

#include "core/geometry/surface_map.hpp"
#include "core/support/contract.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace ff::studies::form_factors {
namespace {

using Eigen::Vector2d;

/// Where the largest remainder of any cell between lines, times the number of cells, is at most this share of the
/// wanted half width, one random place in a random cell stands for all cells in each randomisation.
constexpr double pooled_left = 0.5;

/// Random places in the cells of a source.
class CellSampling {
  public:
    /// @param stream  its random numbers; each randomisation is a trial of its own
    CellSampling(DividedSource& source, Stream stream) : source_(source), stream_(stream), side_(source.side()) {}

    /// The sum of what Gauss's rule leaves. @param wanted  half width
    SampledShare run(double wanted) {
        share_.means.assign(randomisations, 0.0);
        double largest = 0;
        for (const Cell& cell : source_.cells()) largest = std::max(largest, cell.left[side_]);
        const auto count = static_cast<double>(source_.cells().size());
        double squares = 0;
        if (source_.is_cut() && count > 1 && count * largest <= pooled_left * wanted) {
            const double most = add_left_of_some();
            squares = most * most;
        } else {
            std::vector<std::uint32_t> all(randomisations);
            std::iota(all.begin(), all.end(), 0U);
            for (std::uint32_t c = 0; c < source_.cells().size(); ++c) {
                const double most = add_left(c, 1, all);
                squares += most * most;
            }
        }
        // Between lines, the remainder at places of a cell that were not visited is no larger than elsewhere in it.
        share_.points = randomisations;
        share_.unmet = {.rough = std::sqrt(squares)};
        if (!source_.is_cut()) allow_for_unmet();
        return std::move(share_);
    }

  private:
    DividedSource& source_;
    Stream stream_;
    Side side_;
    SampledShare share_;
    std::vector<Vector2d> uvs_;
    std::vector<CellFactors::RandomPlace> places_;

    /// Adds the remainders at random places, each of which stands for this many cells. @return the largest remainder
    /// met
    double add_left(std::uint32_t index, double cells, std::span<const std::uint32_t> trials) {
        const Cell& cell = source_.cells()[index];
        uvs_.clear();
        places_.clear();
        for (const std::uint32_t trial : trials) {
            stream_.trial = trial;
            for (std::uint32_t k = 0; k < cell.places; ++k) {
                const Words words = philox(stream_, most_places * index + k, Purpose::coordinates);
                places_.push_back(
                    source_.factors().random_place(cell, {(words[0] + 0.5) * 0x1p-32, (words[1] + 0.5) * 0x1p-32}));
                uvs_.push_back(places_.back().uv);
            }
        }
        double most = cell.left[side_] * cells;
        const std::span<const Factors> found = source_.factors().at(cell, uvs_, !source_.is_cut());
        for (std::size_t k = 0; k < found.size(); ++k) {
            const double left = source_.left_at(cell, places_[k], found[k])[side_] * cells;
            share_.means[trials[k / cell.places]] += left / cell.places;
            most = std::max(most, std::abs(left));
        }
        return most;
    }

    /// One random cell of each randomisation stands for all cells. @return the largest remainder met
    double add_left_of_some() {
        const std::size_t count = source_.cells().size();
        std::array<std::uint64_t, randomisations> cell{};
        for (std::uint32_t r = 0; r < randomisations; ++r) {
            stream_.trial = r;
            cell[r] = (philox(stream_, 0, Purpose::coordinates)[2] * std::uint64_t{count}) >> 32;
        }
        double most = 0;
        std::vector<std::uint32_t> trials;
        for (std::uint32_t c = 0; c < count; ++c) {
            trials.clear();
            for (std::uint32_t r = 0; r < randomisations; ++r) {
                if (cell[r] == c) trials.push_back(r);
            }
            most = std::max(most, add_left(c, static_cast<double>(count), trials));
        }
        return most;
    }

    /// What random places may have missed is largest if it lies in one cell: both bounds are convex in the share of
    /// places, so that spreading it over several cells gives no more.
    void allow_for_unmet() {
        const auto all = static_cast<double>(source_.places());
        share_.points *= source_.places();
        share_.unmet.rough *= all;
        for (const Cell& cell : source_.cells()) {
            const double scale = all / cell.places;  // the inverse of the cell's share of places
            const double u = source_.unmet_share() / cell.places;
            const double jumps = cell.jumps[side_];
            const double smooth = cell.missed_smoothly(u);
            if (smooth * std::sqrt(u) < jumps)
                share_.unmet.smooth = std::max(share_.unmet.smooth, smooth * scale * std::sqrt(scale));
            else
                share_.unmet.rough = std::max(share_.unmet.rough, jumps * scale);
        }
    }
};

/// The exchange area of two surfaces.
CellSum cell_sum(const CellPair& pair, const CellLimits& limits, Stream stream) {
    DividedSource source(pair, limits);
    if (source.cells().empty()) return {};
    CellSum result;
    const Side side = source.side();
    const double sign = side == hidden ? -1 : 1;
    for (const Cell& cell : source.cells()) result.sum.offset += sign * cell.integral[side];
    if (side == hidden) {
        result.sum.offset += pair.exchange.area->value;
        result.sum.offset_error = pair.exchange.area->error;
    }
    result.sum.terms.push_back({sign, CellSampling(source, stream).run(limits.wanted)});
    result.evaluations = source.factors().evaluations();
    result.between_lines = source.is_cut();
    result.at_limit = !source.is_fine_enough();
    return result;
}

}  // namespace

CellSum cell_sum(const Scene& scene, const FacePairs& pairs, const FacePair& pair, const CellLimits& limits,
                 StreamKey key) {
    CellSum result;
    result.sum.offset = pair.known;
    const auto count = static_cast<double>(pair.count);
    for (const SampledPair& sampled : pairs.surfaces_of(pair)) {
        const PairExchange exchange = pairs.sampled.exchange(sampled);
        const Surface* source = &scene.surfaces[sampled.from];
        const Surface* target = &scene.surfaces[sampled.to];
        const bool has_smaller_target = area(target->shape) < area(source->shape);
        if (!is_polygon(target->shape) || (is_polygon(source->shape) && has_smaller_target)) std::swap(source, target);
        FF_EXPECT(is_polygon(target->shape));
        const FacedEnd source_end = source == &scene.surfaces[sampled.from] ? FacedEnd::from : FacedEnd::to;
        const std::optional<BoundedValue<double>>& whole = exchange.area;
        const double most = whole ? whole->value : std::min(area(source->shape), area(target->shape));
        CellLimits own = limits;
        own.wanted = limits.wanted / std::sqrt(count) / sampled.times();
        own.evaluations = limits.evaluations / pair.count;
        const Stream stream{.key = key, .trial = 0, .source = sampled.from, .target = sampled.to + 1};
        CellSum found = cell_sum({*source, *target, exchange, source_end, most}, own, stream);
        result.evaluations += found.evaluations;
        result.between_lines = result.between_lines && found.between_lines;
        result.at_limit = result.at_limit || found.at_limit;
        result.sum.offset += sampled.times() * found.sum.offset;
        result.sum.offset_error += sampled.times() * found.sum.offset_error;
        for (SampledSum::Term& term : found.sum.terms) {
            term.scale *= sampled.times();
            result.sum.terms.push_back(std::move(term));
        }
    }
    return result;
}

}  // namespace ff::studies::form_factors
