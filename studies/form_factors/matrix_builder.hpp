#pragma once

#include "studies/form_factors/face_pairs.hpp"
#include "studies/form_factors/form_factors.hpp"
#include "studies/form_factors/sampled_row.hpp"

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace ff::studies::form_factors {

/// A sum of doubles below 2^20 that does not depend on their order: in fixed point, to 2^-100.
class OrderlessSum {
  public:
    void add(double value) { units_ += static_cast<Units>(std::ldexp(value, 100)); }
    [[nodiscard]] double value() const { return std::ldexp(static_cast<double>(units_), -100); }

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
        std::vector<double> unmet;  ///< one for each level
        bool is_sampled = false;
    };
    std::vector<double> areas_;
    std::vector<double> levels_;
    std::vector<Row> rows_;
};

/// Puts the exchanges and sums of a matrix together, as estimates come in.
class MatrixBuilder {
  public:
    /// References are kept. The matrix gets its exchanges; sampled ones begin with their geometric bounds.
    /// @param matrix  with its areas @param alpha  1 - level of a pair's interval
    MatrixBuilder(Matrix& matrix, const FacePairs& geometry, const Request& request, double alpha);

    /// @param p  place in FacePairs::pairs
    void take(std::size_t p, const PairEstimate& estimate);

    /// Has to be called after the last estimate. @param farthest  largest coordinate of the scene
    void end(double farthest);

  private:
    /// The sum of a row's estimates, and how far it may be off apart from what is sampled, in form factors.
    struct KnownSum {
        double value = 0;    ///< clipped estimates of all pairs
        double sampled = 0;  ///< part of `value` from pairs in RowSums
        double down = 0;
        double up = 0;

        void add(double area, double exchange, double low, double high);
    };

    Matrix& matrix_;
    const FacePairs& geometry_;
    const Request& request_;
    std::array<double, 2> levels_;  ///< levels of a pair's interval after the first round and after a later one
    RowSums sums_;
    std::vector<double> row_levels_;     ///< for each row, the highest level of its entries
    std::vector<std::uint32_t> places_;  ///< places of sampled pairs among the exchanges
    std::vector<bool> is_summed_;        ///< for each sampled pair, whether it is in `sums_`

    /// Keeps the values of a sampled pair's randomisations.
    void keep_values(std::size_t p, const PairEstimate& estimate);
    [[nodiscard]] RowSum row_sum(const KnownSum& known, std::size_t row, double farthest) const;
};

}  // namespace ff::studies::form_factors
