#include "samplers/point_sets/net_parameter.hpp"

#include "core/support/contract.hpp"
#include "samplers/point_sets/parts.hpp"
#include "samplers/support/sizes.hpp"

#include <algorithm>
#include <vector>

namespace ff::samplers {
namespace {

/// The elementary interval of each point: its number among base^(sum of the digits taken).
class Intervals {
  public:
    /// @param most  points that an interval holds where all hold as many
    Intervals(const Sorting& reading, std::uint32_t base, std::uint64_t most)
        : points_(reading.set), edge_(reading.edge), base_(base), most_(most), cell_(reading.set.points, 0) {}

    /// An interval that holds more than its share, for any way to divide `digits` among the coordinates from `d` on.
    std::optional<ElementaryInterval> find_crowded(std::uint32_t digits, std::size_t d = 0) {
        const bool last = d + 1 == points_.dimension;
        for (std::uint32_t own = last ? digits : 0; own <= digits; ++own) {
            const auto kept = cell_;
            digits_[d] = own;
            divide(d, own);
            auto found = last ? most_crowded() : find_crowded(digits - own, d + 1);
            cell_ = kept;
            if (found) return found;
        }
        return std::nullopt;
    }

  private:
    void divide(std::size_t d, std::uint32_t digits) {
        const std::uint64_t parts = integer_power(base_, digits);
        const auto row = points_.row(0, d);
        for (std::size_t i = 0; i < row.size(); ++i) cell_[i] = cell_[i] * parts + part_of(row[i], parts, edge_);
    }

    [[nodiscard]] std::optional<ElementaryInterval> most_crowded() const {
        std::uint64_t intervals = 1;
        for (std::size_t d = 0; d < points_.dimension; ++d) intervals *= integer_power(base_, digits_[d]);
        std::vector<std::uint64_t> counts(intervals, 0);
        for (const std::uint64_t cell : cell_) ++counts[cell];
        const auto largest = std::max_element(counts.begin(), counts.end());
        if (*largest <= most_) return std::nullopt;
        const auto inside =
            std::find(cell_.begin(), cell_.end(), static_cast<std::uint64_t>(largest - counts.begin())) - cell_.begin();
        ElementaryInterval found{digits_, {}, *largest};
        for (std::size_t d = 0; d < points_.dimension; ++d)
            found.number[d] =
                part_of(points_.row(0, d)[static_cast<std::size_t>(inside)], integer_power(base_, digits_[d]), edge_);
        return found;
    }

    const PointSet& points_;
    Edge edge_;
    std::uint32_t base_;
    std::uint64_t most_;
    std::vector<std::uint64_t> cell_;
    std::array<std::uint32_t, max_dimension> digits_{};  ///< number of digits by which each coordinate is divided
};

/// m where the number of points is base^m.
std::optional<std::uint32_t> exponent_of(const PointSet& points, std::uint32_t base) {
    std::uint32_t m = 0;
    while (integer_power(base, m) < points.points) ++m;
    if (integer_power(base, m) != points.points) return std::nullopt;
    return m;
}

}  // namespace

std::optional<ElementaryInterval> crowded_interval(const PointSet& points, std::uint64_t set, std::uint32_t base,
                                                   std::uint32_t t) {
    const auto m = exponent_of(points, base);
    FF_EXPECT(m && t <= *m);
    std::optional<ElementaryInterval> found;
    for (const Sorting& reading : sortings(points, set, integer_power(base, *m - t))) {
        const auto crowded = Intervals(reading, base, integer_power(base, t)).find_crowded(*m - t);
        if (!crowded) return std::nullopt;
        if (!found) found = crowded;
    }
    return found;
}

std::optional<std::uint32_t> net_parameter(const PointSet& points, std::uint64_t set, std::uint32_t base) {
    const auto m = exponent_of(points, base);
    if (!m) return std::nullopt;
    std::uint32_t t = 0;
    while (t < *m && crowded_interval(points, set, base, t)) ++t;
    return t;
}

}  // namespace ff::samplers
