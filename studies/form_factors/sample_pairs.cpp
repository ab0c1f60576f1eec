#include "studies/form_factors/sample_pairs.hpp"

#include "core/support/error.hpp"
#include "studies/form_factors/rounds.hpp"

#include <algorithm>
#include <exception>
#include <thread>
#include <utility>

namespace ff::studies::form_factors {
namespace {

PairsOfRows pairs_to_sample(const FacePairs& geometry) {
    PairsOfRows rows;
    for (std::size_t pair = 0; pair < geometry.pairs.size(); ++pair) rows[geometry.owner(pair)].push_back(pair);
    return rows;
}

/// Rows that are sampled at a time have at least this many pairs, or all that there are: unfinished rows are lost if
/// the process ends.
PairsOfRows next_batch(PairsOfRows& rows) {
    constexpr std::size_t most_pairs_at_once = 512;
    PairsOfRows batch;
    for (std::size_t pairs = 0; pairs < most_pairs_at_once && !rows.empty();) {
        pairs += rows.begin()->second.size();
        batch.insert(rows.extract(rows.begin()));
    }
    return batch;
}

class RowSampling {
  public:
    using Take = std::function<void(std::size_t, const PairEstimate&)>;

    // The analyser does not see the constructor of Rounds, which is in another file.
    // NOLINTNEXTLINE(clang-analyzer-optin.cplusplus.UninitializedObject)
    RowSampling(const Scene& scene, const FacePairs& geometry, const Request& request, double alpha, const Take& take)
        : request_(request),
          take_(take),
          rows_(pairs_to_sample(geometry)),
          rounds_(scene, geometry, request, alpha, rows_) {
        outcome_.lost_of_rows.resize(geometry.faces());
    }

    SamplingOutcome run() {
        PairsOfRows own = rows_;
        if (request_.earlier) {
            request_.earlier([&](const SampledRow& row) {
                take(row);
                own.erase(row.row);
            });
        }
        outcome_.left_out = own.size();
        std::erase_if(own, [&](const auto& row) { return !is_own(row.first); });
        const std::vector<SampledRow> received = while_others_send([&] {
            while (!own.empty() && !outcome_.interrupted) {
                const PairsOfRows batch = next_batch(own);
                sample(batch, own.empty());
            }
        });
        for (const SampledRow& row : received) {
            take(row);
            --outcome_.left_out;
        }
        return outcome_;
    }

  private:
    const Request& request_;
    const Take& take_;
    const PairsOfRows rows_;
    Rounds rounds_;
    SamplingOutcome outcome_;

    [[nodiscard]] bool is_own(std::size_t row) const {
        return request_.shard.holds(row) && (row >= request_.finished.size() || !request_.finished[row]);
    }

    /// Does some work. @return rows of other processes, when all have come
    template <class Work>
    std::vector<SampledRow> while_others_send(Work work) const {
        std::vector<SampledRow> received;
        std::exception_ptr failure;
        {
            std::jthread listener;
            if (request_.others) {
                listener = std::jthread([&] {
                    try {
                        request_.others([&](SampledRow row) { received.push_back(std::move(row)); });
                    } catch (...) {
                        failure = std::current_exception();
                    }
                });
            }
            work();
        }
        if (failure) std::rethrow_exception(failure);
        return received;
    }

    /// Samples a batch of rows. It may take only half of the budget that is left, since later rows need some as well;
    /// the last batch may take all of it.
    void sample(const PairsOfRows& batch, bool is_last) {
        const std::uint64_t left =
            request_.max_samples > outcome_.samples ? request_.max_samples - outcome_.samples : 0;
        const bool complete = rounds_.sample(batch, is_last ? left : left / 2);
        for (const SampledRow& row : rounds_.result()) {
            take(row);
            if (!complete) continue;
            --outcome_.left_out;
            if (request_.keep) request_.keep(row);
        }
        outcome_.interrupted = !complete;
    }

    void take(const SampledRow& row) {
        const auto found = rows_.find(row.row);
        if (found == rows_.end() ||
            !std::ranges::equal(row.estimates, found->second, {}, &std::pair<std::uint32_t, PairEstimate>::first)) {
            throw UserError(
                "row {} was sampled for another matrix (by another version of ffstudy?). Begin again in "
                "another folder.",
                row.row + 1);
        }
        for (const auto& [pair, estimate] : row.estimates) take_(pair, estimate);
        outcome_.samples += row.samples;
        outcome_.rays += row.rays;
        outcome_.lost += row.lost;
        outcome_.lost_of_rows[row.row] = {row.lost, row.rays};
    }
};

}  // namespace

SamplingOutcome sample_pairs(const Scene& scene, const FacePairs& geometry, const Request& request, double alpha,
                             const std::function<void(std::size_t, const PairEstimate&)>& take) {
    return RowSampling(scene, geometry, request, alpha, take).run();
}

}  // namespace ff::studies::form_factors
