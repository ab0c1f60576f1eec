#pragma once

#include "studies/form_factors/sampled_row.hpp"
#include "studies/form_factors/sampled_share.hpp"

#include <array>
#include <cstddef>
#include <vector>

namespace ff::studies::form_factors {

/// A sum of doubles below 2^20 that does not depend on their order: in fixed point, to 2^-100.
class OrderlessSum {
  public:
    void add(double value);
    [[nodiscard]] double value() const;

  private:
    __extension__ using Units = __int128;
    Units units_ = 0;
};

/// The sampled parts of the sums of rows, in form factors. Independent randomisations add up. Pairs may be added in any
/// order.
class RowSums {
  public:
    /// @param levels  confidence levels at which sums are asked for
    RowSums(std::vector<double> areas, std::vector<double> levels);

    /// Adds an exchange area to the row of a face. @pre the estimate has a sum
    void add(std::size_t face, const PairEstimate& estimate);

    /// The sampled part of a row's sum. @param level  one of those of the constructor
    [[nodiscard]] EstimatedSum at(std::size_t face, double level) const;

  private:
    struct Row {
        OrderlessSum offset;
        OrderlessSum offset_error;
        std::array<OrderlessSum, randomisations> means;
        std::vector<double> unmet;  ///< by level
        bool is_sampled = false;
    };
    std::vector<double> areas_;
    std::vector<double> levels_;
    std::vector<Row> rows_;
};

}  // namespace ff::studies::form_factors
