#include "studies/form_factors/rounds.hpp"
#include "studies/run/parallel.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace ff::studies::form_factors {
namespace {

/// Least and largest number of evaluations for two surfaces: at most some seconds.
constexpr std::uint64_t least_evaluations = 256;
constexpr std::uint64_t most_evaluations = std::uint64_t{1} << 22;

}  // namespace

/// Integrates pairs cell by cell where that is possible, in rounds of their own.
void Rounds::integrate_cells() {
    constexpr double finer = 0.4;
    std::vector<std::size_t> pairs;
    for (const auto& entry : pairs_) {
        if (is_by_cells(entry.first)) pairs.push_back(entry.first);
    }
    const bool shares_budget = !work_.empty();
    for (std::size_t round = 0; round < most_rounds && !pairs.empty(); ++round) {
        const auto surfaces_of = [&](std::size_t pair) { return std::size_t{geometry_.pairs[pair].count}; };
        std::uint64_t surfaces = 0;  // pairs of them
        for (const std::size_t pair : pairs) surfaces += surfaces_of(pair);
        if (!allows(least_evaluations * surfaces * (shares_budget ? 2 : 1))) return;
        const std::uint64_t most =
            std::min(left_ / (shares_budget ? 2 : 1) / std::max<std::uint64_t>(1, surfaces), most_evaluations);
        progress_.stage = Progress::Stage::rounds;
        progress_.round = round + 1;
        std::size_t done = 0;
        std::vector<std::optional<CellSum>> found(pairs.size());
        const StreamKey key = key_of(fmt::format("cells {}", round + 1));
        for_each_index(pairs.size(), request_.threads, [&](std::uint64_t i) {
            if (request_.stop != nullptr && *request_.stop) return;
            const std::size_t pair = pairs[i];
            const CellLimits limits{wanted(pair) * std::pow(finer, round), level(round), most * surfaces_of(pair),
                                    request_.stop};
            found[i] = cell_sum(scene_, geometry_, geometry_.pairs[pair], limits, key);
            if (!request_.report) return;
            const std::lock_guard lock(reporting_);
            report(++done, pairs.size(), samples_);
        });
        std::vector<std::size_t> wide;
        for (std::size_t i = 0; i < pairs.size(); ++i) {
            if (found[i] && !take(pairs[i], std::move(*found[i]), round)) wide.push_back(pairs[i]);
        }
        if (request_.report) report(1, 1, samples_);
        expect_more_time(request_.stop);
        pairs = std::move(wide);
    }
}

/// @return whether it needs no other round
bool Rounds::take(std::size_t pair, CellSum cells, std::size_t round) {
    rows_[geometry_.owner(pair)].samples += cells.evaluations;
    samples_ += cells.evaluations;
    left_ -= std::min(left_, cells.evaluations);
    const EstimatedSum estimate = estimate_of(cells.sum, level(round));
    expected_[pair] = std::max(0.0, estimate.value);
    const bool within = estimate.half_width() <= wanted(pair);
    const auto method = cells.between_lines ? ExchangeMethod::cells : ExchangeMethod::points;
    State& state = pairs_[pair];
    if (state.recorded) earlier_.push_back({pair, std::move(*state.estimate.sum)});
    state.estimate = {std::move(cells.sum), method, level(round), cells.evaluations, false, {}};
    state.recorded = true;
    state.done = within || cells.at_limit;
    if (within) ++progress_.within;
    return state.done;
}

}  // namespace ff::studies::form_factors
