#include "studies/form_factors/sampled_pairs.hpp"

#include "core/support/contract.hpp"

#include <algorithm>
#include <limits>
#include <tuple>

namespace ff::studies::form_factors {
namespace {

constexpr std::uint32_t ends = 3;

}  // namespace

void SampledPairs::add(std::uint32_t face, std::uint32_t other_face, std::uint32_t from, std::uint32_t to,
                       const PairExchange& exchange) {
    FF_EXPECT(exchange.blockers.size() <= std::numeric_limits<std::uint16_t>::max());
    const auto first = static_cast<std::uint32_t>(blockers_.size());
    for (const Blocker& blocker : exchange.blockers) {
        const auto wall = static_cast<std::uint32_t>(blocker.surface - walls_.data());
        blockers_.push_back(wall * ends + static_cast<std::uint32_t>(blocker.faces));
    }
    constexpr double unknown = std::numeric_limits<double>::infinity();
    pairs_.push_back({face, other_face, from, to, first, static_cast<std::uint16_t>(exchange.blockers.size()),
                      exchange.reason, exchange.method, exchange.area.value_or(BoundedValue<double>{unknown, 0})});
}

void SampledPairs::add(const SampledPair& pair, const SampledPairs& others) {
    pairs_.push_back(pair);
    pairs_.back().first_blocker = static_cast<std::uint32_t>(blockers_.size());
    const auto blockers = std::span(others.blockers_).subspan(pair.first_blocker, pair.blockers);
    blockers_.insert(blockers_.end(), blockers.begin(), blockers.end());
}

void SampledPairs::reserve(std::size_t pairs, std::size_t blockers) {
    pairs_.reserve(pairs);
    blockers_.reserve(blockers);
}

void SampledPairs::sort() {
    const auto place = [](const SampledPair& pair) {
        return std::tuple(pair.face, pair.other_face, pair.from, pair.to);
    };
    std::sort(pairs_.begin(), pairs_.end(),
              [&](const SampledPair& a, const SampledPair& b) { return place(a) < place(b); });
}

void SampledPairs::shrink_to_fit() {
    pairs_.shrink_to_fit();
    blockers_.shrink_to_fit();
}

PairExchange SampledPairs::exchange(const SampledPair& pair) const {
    PairExchange result;
    result.method = pair.method;
    result.reason = pair.reason;
    result.area = pair.is_whole_known() ? std::optional(pair.whole) : std::nullopt;
    for (const std::uint32_t blocker : std::span(blockers_).subspan(pair.first_blocker, pair.blockers))
        result.blockers.emplace_back(&walls_[blocker / ends], static_cast<FacedEnd>(blocker % ends));
    return result;
}

}  // namespace ff::studies::form_factors
