#include "studies/form_factors/rounds.hpp"
#include "studies/run/parallel.hpp"

#include <algorithm>
#include <utility>

namespace ff::studies::form_factors {

/// Integrates pairs cell by cell where that is possible, in as many rounds as leave one to points.
void Rounds::integrate_cells() {
    constexpr double finer = 0.4;
    std::vector<std::size_t> pairs;
    for (const auto& entry : pairs_) {
        if (request_.cells && aim_.geometry.pairs[entry.first].by_points) pairs.push_back(entry.first);
    }
    for (std::size_t round = 0; round + 1 < most_rounds && !pairs.empty(); ++round) {
        progress_.stage = Progress::Stage::rounds;
        progress_.round = round + 1;
        std::size_t done = 0;
        std::vector<std::optional<CellSum>> found(pairs.size());
        const StreamKey key = key_of(round == 0 ? "cells" : "finer cells");
        for_each_index(pairs.size(), request_.threads, [&](std::uint64_t i) {
            expect_more_time(request_.stop);
            const double wanted = aim_.wanted(pairs[i]) * (round == 0 ? 1 : finer);
            found[i] = cell_sum(scene_, aim_.geometry.pairs[pairs[i]], aim_.geometry.effort, wanted, key);
            if (!request_.report) return;
            const std::lock_guard lock(reporting_);
            report(++done, pairs.size(), samples_);
        });
        std::vector<std::size_t> wide;
        for (std::size_t i = 0; i < pairs.size(); ++i) {
            if (found[i] && found[i]->evaluations <= left_ && !take(pairs[i], std::move(*found[i]), round))
                wide.push_back(pairs[i]);
        }
        if (request_.report) report(1, 1, samples_);
        pairs = std::move(wide);
    }
}

/// @return whether the half width is what is wanted
bool Rounds::take(std::size_t pair, CellSum cells, std::size_t round) {
    State& state = pairs_[pair];
    rows_[aim_.owner(pair)].samples += cells.evaluations;
    samples_ += cells.evaluations;
    left_ -= cells.evaluations;
    const EstimatedSum estimate = estimate_of(cells.sum, level(round));
    aim_.expected[pair] = std::max(0.0, estimate.value);
    if (estimate.half_width() > aim_.wanted(pair)) {
        earlier_.push_back({pair, std::move(cells.sum)});
        state.rounds = round + 1;
        return false;
    }
    state.estimate = {std::move(cells.sum), ExchangeMethod::cells, level(round), cells.evaluations, false, {}};
    state.recorded = state.done = true;
    ++progress_.within;
    return true;
}

}  // namespace ff::studies::form_factors
