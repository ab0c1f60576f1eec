#pragma once

#include "core/tracing/tracer.hpp"
#include "studies/form_factors/cells/cell_sum.hpp"
#include "studies/form_factors/row_by_rays.hpp"
#include "studies/form_factors/sampled_row.hpp"

#include <cstdint>
#include <map>
#include <memory>
#include <mutex>
#include <string_view>
#include <vector>

namespace ff::studies::form_factors {

/// Places in FacePairs::pairs, grouped by the face that owns the pairs.
using PairsOfRows = std::map<std::size_t, std::vector<std::size_t>>;

/// Most rounds of a pair whose interval may be reported.
inline constexpr std::size_t most_rounds = 3;

/// Level of the interval of such a round, the first being 0. The rounds share the error rate alpha, so that it does not
/// matter which of them is reported, or why: nine tenths go to the first, which is seldom followed by another, a
/// twentieth to each other one.
double round_level(double alpha, std::size_t round);

/// Samples rows: pairs of a polygon with a surface past polygons in cells, others by rays, for which pilot rounds
/// decide on sizes. Rounds with randomisations of their own, most_rounds at most, give the estimates. Every estimate is
/// compared with those of other rounds. Samples of a row do not depend on which rows are sampled with it, unless the
/// budget ends.
class Rounds {
  public:
    /// All arguments are kept by reference. @param alpha  1 - level of a pair's interval @param rows  all rows that
    /// exist
    Rounds(const Scene& scene, const FacePairs& geometry, const Request& request, double alpha,
           const PairsOfRows& rows);

    /// @param budget  samples, at most
    /// @return whether it was completed; if it was stopped, pairs may lack estimates
    /// @throws UserError where nothing has been sampled yet, and the budget is less than the smallest rounds
    bool sample(const PairsOfRows& rows, std::uint64_t budget);
    /// The results of the last call, row by row.
    [[nodiscard]] std::vector<SampledRow> result() const;

  private:
    /// An earlier estimate of a pair, for comparison.
    struct Earlier {
        std::size_t pair = 0;
        SampledSum sum;
    };
    /// The state of a pair that is sampled.
    struct State {
        PairEstimate estimate;
        bool recorded = false;  ///< the estimate is of a round that counts
        bool done = false;
    };
    /// Pairs that are left to rays, and how far they have come.
    struct Work {
        RowByRays row;
        std::size_t rounds = 0;  ///< completed rounds that count
        bool pilot = true;       ///< its next round only decides and does not count
    };

    const Scene& scene_;
    const Request& request_;
    double alpha_;
    std::size_t sampled_ = 0;  ///< sampled pairs of all rows
    const FacePairs& geometry_;
    /// Exchange area that is expected of each pair, from the samples so far. It decides on numbers of samples, not on
    /// intervals.
    std::vector<double> expected_;
    std::unique_ptr<Tracer> tracer_;
    std::map<std::size_t, SampledRow> rows_;
    std::map<std::size_t, State> pairs_;
    std::vector<Work> work_;
    std::vector<Earlier> earlier_;
    std::size_t round_ = 0;
    bool last_ = false;          ///< the budget ends with this round
    std::uint64_t left_ = 0;     ///< samples left in the budget
    std::uint64_t samples_ = 0;  ///< samples in all calls
    Progress progress_;
    std::mutex reporting_;

    [[nodiscard]] double level(std::size_t rounds_done) const { return round_level(alpha_, rounds_done); }
    [[nodiscard]] StreamKey key_of(std::string_view samples) const;
    [[nodiscard]] bool is_by_cells(std::size_t pair) const;
    [[nodiscard]] double wanted(std::size_t pair) const;
    void integrate_cells();
    bool take(std::size_t pair, CellSum cells, std::size_t round);
    void shoot_rays();
    void run_round();
    void begin_reporting();
    void report(std::uint64_t done, std::uint64_t all, std::uint64_t samples);
    void evaluate();
    bool record(const Work& work, std::size_t pair);
    void set_next(Work& work);
    void note_unfinished();
    [[nodiscard]] std::vector<double> missing(const RowByRays& row) const;
    [[nodiscard]] std::uint64_t planned() const;
    bool allows(std::uint64_t least) const;
    void keep_within_budget();
    void compare();
};

}  // namespace ff::studies::form_factors
