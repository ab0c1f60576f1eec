#include "studies/form_factors/matrix_builder.hpp"

#include "core/support/contract.hpp"
#include "studies/form_factors/rounds.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace ff::studies::form_factors {
namespace {

/// Clips an interval to what geometry allows, and the value to the interval.
void clip(FaceExchange& exchange, double least, double most) {
    exchange.clipped = exchange.value < least || exchange.value > most;
    // Moved with the value: what remains of an interval may be narrower than its error, or empty.
    if (exchange.clipped) {
        const double moved = std::clamp(exchange.value, least, most) - exchange.value;
        exchange.low += moved;
        exchange.high += moved;
    }
    exchange.low = std::clamp(exchange.low, least, most);
    exchange.high = std::clamp(exchange.high, least, most);
    exchange.value = std::clamp(exchange.value, exchange.low, exchange.high);
}

/// @param smaller  area of the smaller face
FaceExchange face_exchange(const KnownPair& pair, double smaller) {
    FaceExchange result{pair.from, pair.to,     pair.value, pair.value - pair.bound, pair.value + pair.bound,
                        0,         pair.method, pair.reason};
    clip(result, 0, smaller);
    return result;
}

FaceExchange face_exchange(const FacePair& pair, const PairEstimate& estimate) {
    FaceExchange result{.from = pair.from, .to = pair.to, .method = std::nullopt, .reason = pair.reason};
    const double least = std::max(0.0, pair.known - pair.bound - pair.resolution);
    const double most = std::max(least, pair.most + pair.resolution);
    if (!estimate.sum) {
        // Only geometry is known: sampling was stopped before the end of the first round.
        result.low = least;
        result.high = pair.most;
        result.value = (result.low + result.high) / 2;
    } else {
        const EstimatedSum found = estimate_of(*estimate.sum, estimate.level);
        result.value = found.value;
        result.low = found.value - found.down - pair.bound - pair.resolution;
        result.high = found.value + found.up + pair.bound + pair.resolution;
        result.method = estimate.method;
        result.samples = estimate.samples;
        result.contradicted = estimate.contradicted;
        if (estimate.contradicted) {
            result.low = std::min(result.low, estimate.other.value - estimate.other.down);
            result.high = std::max(result.high, estimate.other.value + estimate.other.up);
        }
    }
    clip(result, least, most);
    return result;
}

/// Level of a row's interval at which some row of a closed scene is said not to add up to 1, though it does, in 0.001
/// of runs.
double alarm_level(std::size_t faces) {
    return 1 - 1e-3 / static_cast<double>(faces);
}

template <class Pair, class Use>
void for_both(const Pair& pair, const Use& use) {
    use(pair.from);
    if (pair.from != pair.to) use(pair.to);
}

}  // namespace

RowSums::RowSums(std::vector<double> areas, std::vector<double> levels)
    : areas_(std::move(areas)), levels_(std::move(levels)), rows_(areas_.size()) {}

void RowSums::add(std::size_t face, const PairEstimate& estimate) {
    FF_EXPECT(estimate.sum.has_value());
    Row& row = rows_[face];
    const double area = areas_[face];
    row.offset.add(estimate.sum->offset / area);
    row.offset_error.add(estimate.sum->offset_error / area);
    row.unmet.resize(levels_.size(), 0.0);
    for (const auto& [scale, share] : estimate.sum->terms) {
        FF_EXPECT(share.means.size() == randomisations);
        row.is_sampled = true;
        for (std::size_t r = 0; r < randomisations; ++r) row.means[r].add(scale * share.means[r] / area);
        for (std::size_t k = 0; k < levels_.size(); ++k)
            row.unmet[k] = std::max(row.unmet[k], unmet_of(scale, share, levels_[k]) / area);
    }
}

EstimatedSum RowSums::at(std::size_t face, double level) const {
    const Row& row = rows_[face];
    EstimatedSum result{row.offset.value(), row.offset_error.value(), row.offset_error.value(), 0};
    if (!row.is_sampled) return result;
    const auto known = std::find(levels_.begin(), levels_.end(), level);
    FF_EXPECT(known != levels_.end());
    std::vector<double> means;
    for (const OrderlessSum& mean : row.means) means.push_back(mean.value());
    return with_means(result, means, row.unmet[static_cast<std::size_t>(known - levels_.begin())], level);
}

MatrixBuilder::MatrixBuilder(Matrix& matrix, const FacePairs& geometry, const Request& request, double alpha)
    : matrix_(matrix),
      geometry_(geometry),
      request_(request),
      levels_{round_level(alpha, 0), round_level(alpha, 1)},
      sums_(geometry.areas, {levels_[0], levels_[1], alarm_level(geometry.faces())}),
      row_levels_(geometry.faces(), levels_[0]) {
    auto known = geometry.known.begin();
    const auto add_known_before = [&](std::uint32_t from, std::uint32_t to) {
        for (; known != geometry.known.end() && std::pair(known->from, known->to) < std::pair(from, to); ++known)
            matrix_.exchanges.push_back(
                face_exchange(*known, std::min(matrix.areas[known->from], matrix.areas[known->to])));
    };
    matrix_.exchanges.reserve(geometry.known.size() + geometry.pairs.size());
    for (const FacePair& pair : geometry.pairs) {
        add_known_before(pair.from, pair.to);
        places_.push_back(static_cast<std::uint32_t>(matrix_.exchanges.size()));
        matrix_.exchanges.push_back(face_exchange(pair, {}));
    }
    constexpr auto end = std::numeric_limits<std::uint32_t>::max();
    add_known_before(end, end);
    is_summed_.assign(geometry.pairs.size(), false);
}

void MatrixBuilder::take(std::size_t p, const PairEstimate& estimate) {
    const FacePair& pair = geometry_.pairs[p];
    matrix_.exchanges[places_[p]] = face_exchange(pair, estimate);
    if (!estimate.sum || estimate.contradicted) return;
    is_summed_[p] = true;
    if (request_.randomisations) keep_values(p, estimate);
    for_both(pair, [&](std::size_t face) {
        sums_.add(face, estimate);
        row_levels_[face] = std::max(row_levels_[face], estimate.level);
    });
}

void MatrixBuilder::keep_values(std::size_t p, const PairEstimate& estimate) {
    const FacePair& pair = geometry_.pairs[p];
    PairRandomisations& kept = matrix_.randomisations.emplace_back();
    kept.from = pair.from;
    kept.to = pair.to;
    if (estimate.method == ExchangeMethod::rays) kept.rays_of = static_cast<std::uint32_t>(geometry_.owner(p));
    for (std::size_t k = 0; k < randomisations; ++k) {
        double value = estimate.sum->offset;
        for (const SampledSum::Term& term : estimate.sum->terms) value += term.scale * term.share.means[k];
        kept.values[k] = static_cast<float>(value / matrix_.areas[pair.from]);
    }
    const double hidden =
        estimate_of(*estimate.sum, request_.level).unmet + estimate.sum->offset_error + pair.bound + pair.resolution;
    kept.hidden = static_cast<float>(hidden / matrix_.areas[pair.from]);
}

void MatrixBuilder::end(double farthest) {
    std::sort(matrix_.randomisations.begin(), matrix_.randomisations.end(),
              [](const auto& a, const auto& b) { return std::pair(a.from, a.to) < std::pair(b.from, b.to); });
    std::vector<KnownSum> rows(matrix_.faces());
    for (std::size_t face = 0; face < rows.size(); ++face) {
        const DroppedExchange& before = geometry_.dropped[face];
        rows[face].add(matrix_.areas[face], before.value, before.low, before.high);
    }
    std::size_t p = 0;
    for (std::size_t e = 0; e < matrix_.exchanges.size(); ++e) {
        FaceExchange& exchange = matrix_.exchanges[e];
        exchange.within = is_within(matrix_, exchange, request_);
        const FacePair* pair = p < places_.size() && places_[p] == e ? &geometry_.pairs[p++] : nullptr;
        const bool is_summed = pair != nullptr && is_summed_[p - 1];
        for_both(exchange, [&](std::size_t face) {
            const double area = matrix_.areas[face];
            if (!is_summed) return rows[face].add(area, exchange.value, exchange.low, exchange.high);
            rows[face].value += exchange.value / area;
            rows[face].sampled += exchange.value / area;
            rows[face].down += (pair->bound + pair->resolution) / area;
            rows[face].up += (pair->bound + pair->resolution) / area;
        });
    }
    for (std::size_t face = 0; face < rows.size(); ++face) matrix_.rows.push_back(row_sum(rows[face], face, farthest));
}

/// Independent randomisations add up, bounds do.
RowSum MatrixBuilder::row_sum(const KnownSum& known, std::size_t row, double farthest) const {
    const auto ends = [&](double at) {
        const EstimatedSum found = sums_.at(row, at);
        const double value = known.value - known.sampled + found.value;
        return std::pair(value - found.down - known.down, value + found.up + known.up);
    };
    const auto [low, high] = ends(row_levels_[row]);
    const auto [least, most] = ends(alarm_level(matrix_.faces()));
    // Coordinates in the file are rounded, and with them the edges of the row's face.
    const double rounding =
        std::max(1e-12, 16 * std::numeric_limits<double>::epsilon() * farthest / std::sqrt(matrix_.areas[row]));
    // No true sum is above 1; where the interval is above 1, the scene is faulty, and the interval is shown as it is.
    const double end = low > 1 + rounding ? high : std::min(1.0, high);
    const double off = least > 1 + rounding ? least - 1 : most < 1 - rounding ? 1 - most : 0;
    return {known.value, std::min(known.value, std::max(0.0, low)), std::max(known.value, end), false, {}, off};
}

void MatrixBuilder::KnownSum::add(double area, double exchange, double low, double high) {
    value += exchange / area;
    down += (exchange - low) / area;
    up += (high - exchange) / area;
}

}  // namespace ff::studies::form_factors
