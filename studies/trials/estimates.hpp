#pragma once

#include "studies/store/store.hpp"
#include "studies/theory/known_variance.hpp"

#include <cstddef>
#include <cstdint>
#include <list>
#include <memory>
#include <optional>
#include <vector>

namespace ff::studies {

/// All trials of one cell after completion.
struct CellEstimates {
    std::size_t cell = 0;
    std::size_t faces = 0;
    std::vector<std::uint64_t> trial_numbers;   ///< ascending; all of them in a complete study
    std::vector<std::vector<double>> factors;   ///< [(from - 1) * faces + to - 1], by trial; diagonal empty
    std::vector<std::vector<double>> row_sums;  ///< [from - 1]
    std::vector<double> sum_relative_error;     ///< percent, over all faces; empty in an open scene
    std::vector<double>
        rays;  ///< [(from - 1) * faces + to - 1], rays behind a trial's hits; empty where none are counted
    std::uint64_t lost_rays = 0;
    /// N: rays from or points on a face, or kernel values of a face pair, in a trial; where surfaces have grids, of
    /// each part or pair of parts.
    std::uint64_t samples_of_pair = 0;
    /// What a trial costs: its evaluations, those of all pairs, over the number of faces; rounded up.
    std::uint64_t evaluations_per_face = 0;

    [[nodiscard]] const std::vector<double>& values(Quantity quantity) const;
    /// The lattice spacing of the values of a pair or a row, for equal face areas; empty where hits are not counted.
    [[nodiscard]] std::optional<double> lattice(Quantity quantity) const;
    [[nodiscard]] std::size_t trials() const { return row_sums.empty() ? 0 : row_sums.front().size(); }
};

/// The observations of one cell, before completion.
struct DirectEstimates {
    std::vector<std::uint64_t> trial_numbers;
    /// [(from - 1) * faces + to - 1], by trial: estimates, or hits where they are counted. Diagonal empty.
    std::vector<std::vector<double>> values;
    std::uint64_t lost_rays = 0;

    [[nodiscard]] std::size_t trials() const { return trial_numbers.size(); }
};

/// The estimates of a cell, completed. Only pairs with from < to are used under reciprocal completion.
CellEstimates complete(const StudyPlan& plan, std::size_t cell, Completion completion, DirectEstimates direct);

/// The limits that theory knows for a quantity in all trials of the cell (studies/theory/known_variance.hpp).
stats::KnownLimits known_limits(const StudyPlan& plan, const CellEstimates& estimates, Quantity quantity);

/// Reads the direct estimates of a cell and completes them by its method. The same rays serve both completions.
CellEstimates load_estimates(const Store& store, std::size_t cell);

/// The same with a completion of the caller's choice.
CellEstimates load_estimates(const Store& store, std::size_t cell, Completion completion);

/// Pairs of faces whose estimates are free: all ordered pairs, or those with from < to under reciprocal completion.
std::vector<Quantity> distinct_pairs(std::size_t faces, Completion completion);

/// Every pair, every row sum and, in a closed scene, the sum of relative errors; the order of all result tables.
std::vector<Quantity> all_quantities(const CellEstimates& estimates);

/// The estimates of the cells of a store, for analysis: what asks for a cell again gets those that were read, unless
/// cells read since take more memory than is kept. Not for several threads at once.
class CellReader {
  public:
    /// Bytes of estimates that are kept beside those of the cell read last.
    static constexpr std::size_t most_kept = std::size_t{128} << 20;

    /// Implicit: a store serves wherever cells are read once. @param store  has to outlive the reader
    // NOLINTNEXTLINE(google-explicit-constructor)
    CellReader(const Store& store, std::size_t kept = most_kept) : store_(&store), most_kept_(kept) {}

    [[nodiscard]] const Store& store() const { return *store_; }
    [[nodiscard]] const StudyPlan& plan() const { return store_->plan(); }
    /// The cell's estimates as `load_estimates` gives them. @throws IoError
    [[nodiscard]] std::shared_ptr<const CellEstimates> load(std::size_t cell) const;

  private:
    const Store* store_;
    std::size_t most_kept_;
    mutable std::list<std::shared_ptr<const CellEstimates>> kept_;  ///< the one asked for last comes first
};

}  // namespace ff::studies
