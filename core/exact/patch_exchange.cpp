#include "core/exact/patch_exchange.hpp"

#include "core/exact/exact.hpp"
#include "core/formulas/polygon_exchange.hpp"

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

namespace ff {
namespace {

using Eigen::Vector3d;

/// Gives pairs of patches in the same relative position the same number. A pair is given by column and row of both
/// patches; its offset is a sum of these times the patches' edges, in which equal edges of the two count together.
class Offsets {
  public:
    /// @param from, to  one patch of each
    Offsets(const Parallelogram& from, Grid from_grid, const Parallelogram& to, Grid to_grid)
        : last_{from_grid.columns - 1, from_grid.rows - 1, to_grid.columns - 1, to_grid.rows - 1} {
        const std::array<Vector3d, 2> from_edges{from.edge_u, from.edge_v};
        const std::array<Vector3d, 2> to_edges{to.edge_u, to.edge_v};
        std::array<bool, 2> taken{};
        for (std::size_t i = 0; i < 2; ++i) {
            strides_[i] = size_;
            std::size_t values = last_[i] + 1;
            for (std::size_t j = 0; j < 2; ++j) {
                const int sign = equal(from_edges[i], to_edges[j]) - equal(from_edges[i], -to_edges[j]);
                if (sign == 0 || taken[j]) continue;
                taken[j] = true;
                values = last_[i] + last_[2 + j] + 1;
                // -a + b from -(last a) to (last b), or -a - b: equal offsets for equal a + b.
                strides_[2 + j] = size_;
                if (sign > 0) reversed_[2 + j] = true;
            }
            size_ *= values;
        }
        for (std::size_t j = 0; j < 2; ++j) {
            if (taken[j]) continue;
            strides_[2 + j] = size_;
            size_ *= last_[2 + j] + 1;
        }
    }

    [[nodiscard]] std::size_t size() const { return size_; }

    /// @param place  column and row of the first patch, column and row of the second
    [[nodiscard]] std::size_t number(const std::array<std::uint32_t, 4>& place) const {
        std::size_t number = 0;
        for (std::size_t k = 0; k < place.size(); ++k)
            number += strides_[k] * (reversed_[k] ? last_[k] - place[k] : place[k]);
        return number;
    }

  private:
    static bool equal(const Vector3d& a, const Vector3d& b) {
        return (a - b).norm() <= 4 * std::numeric_limits<double>::epsilon() * a.norm();
    }

    std::array<std::size_t, 4> strides_{};
    std::array<bool, 4> reversed_{};
    std::size_t size_ = 1;
    std::array<std::size_t, 4> last_;
};

BoundedValue<double> exchange_of(const Surface& from, const Surface& to) {
    if (const auto exact = exact_exchange_area(from, to)) return {*exact, 1e-15 * squared_extent(from, to)};
    return polygon_exchange_area<double>(corners_of<double>(from), corners_of<double>(to));
}

}  // namespace

PatchExchange patch_exchange(const Surface& from, const Surface& to, Subdivision subdivision) {
    const Grid of_from = subdivision.of(from);
    const Grid of_to = subdivision.of(to);
    const Offsets offsets(patch(parallelogram(from), of_from, 0), of_from, patch(parallelogram(to), of_to, 0), of_to);
    std::vector<std::optional<double>> known(offsets.size());
    PatchExchange result;
    result.areas.resize(of_from.parts(), of_to.parts());
    for (std::uint32_t j = 0; j < of_to.parts(); ++j) {
        for (std::uint32_t i = 0; i < of_from.parts(); ++i) {
            auto& exchange =
                known[offsets.number({i % of_from.columns, i / of_from.columns, j % of_to.columns, j / of_to.columns})];
            if (!exchange) {
                const auto value = exchange_of(patch(from, of_from, i), patch(to, of_to, j));
                exchange = value.value;
                result.error = std::max(result.error, value.error);
                ++result.computed;
            }
            result.areas(i, j) = *exchange;
        }
    }
    return result;
}

}  // namespace ff
