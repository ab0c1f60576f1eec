#pragma once

#include "studies/form_factors/face_pairs.hpp"
#include "studies/form_factors/form_factors.hpp"
#include "studies/form_factors/row_sums.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace ff::studies::form_factors {

/// Puts the exchanges and sums of a matrix together, as estimates come in.
class MatrixBuilder {
  public:
    /// References are kept. The matrix gets its exchanges, sampled ones as geometry bounds them.
    /// @param matrix  with its areas @param known  pairs beside those that are sampled, in order
    /// @param alpha  1 - level of a pair's interval
    MatrixBuilder(Matrix& matrix, const FacePairs& geometry, const std::vector<KnownPair>& known,
                  const Request& request, double alpha);

    /// @param p  place in FacePairs::pairs
    void take(std::size_t p, const PairEstimate& estimate);

    /// When all have been taken that are going to be. @param farthest  coordinate of the scene
    void end(double farthest);

  private:
    /// What is known of a row's sum apart from its sampled part, in form factors.
    struct KnownSum {
        double value = 0;    ///< clipped estimates of all pairs
        double sampled = 0;  ///< of those of RowSums
        double down = 0;
        double up = 0;

        void add(double area, double exchange, double low, double high);
    };

    Matrix& matrix_;
    const FacePairs& geometry_;
    const Request& request_;
    std::array<double, 2> levels_;  ///< of a pair's interval after the first round, and after a later one
    RowSums sums_;
    std::vector<double> row_levels_;     ///< the highest of a row's entries
    std::vector<std::uint32_t> places_;  ///< of sampled pairs among the exchanges
    std::vector<bool> is_summed_;        ///< sampled pairs that are in `sums_`

    /// Keeps the values of a sampled pair's randomisations.
    void keep_values(std::size_t p, const PairEstimate& estimate);
    [[nodiscard]] RowSum row_sum(const KnownSum& known, std::size_t row, double farthest) const;
};

}  // namespace ff::studies::form_factors
