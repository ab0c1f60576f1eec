#pragma once

#include "studies/trials/estimates.hpp"

#include <cstddef>
#include <list>
#include <memory>

namespace ff::studies {

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
    /// As load_estimates. @throws IoError
    [[nodiscard]] std::shared_ptr<const CellEstimates> load(std::size_t cell) const;

  private:
    const Store* store_;
    std::size_t most_kept_;
    mutable std::list<std::shared_ptr<const CellEstimates>> kept_;  ///< the one asked for last comes first
};

}  // namespace ff::studies
