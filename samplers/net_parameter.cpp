#include "samplers/net_parameter.hpp"

#include "samplers/sizes.hpp"

#include <algorithm>
#include <vector>

namespace ff::samplers {
namespace {

/// One elementary interval a point: its number among base^(sum of the digits taken).
class Intervals {
  public:
    /// @param most  points that an interval holds where all hold as many
    Intervals(const PointSet& points, std::uint64_t set, std::uint32_t base, std::uint64_t most)
        : points_(points), set_(set), base_(base), most_(most), cell_(points.points, 0) {}

    /// Whether for every way to divide `digits` among the coordinates from `d` on all intervals hold as many points.
    bool are_fair(std::uint32_t digits, std::size_t d = 0) {
        if (d + 1 == points_.dimension) {
            const auto kept = cell_;
            divide(d, digits);
            const bool fair = hold_as_many();
            cell_ = kept;
            return fair;
        }
        for (std::uint32_t own = 0; own <= digits; ++own) {
            const auto kept = cell_;
            divide(d, own);
            const bool fair = are_fair(digits - own, d + 1);
            cell_ = kept;
            if (!fair) return false;
        }
        return true;
    }

  private:
    void divide(std::size_t d, std::uint32_t digits) {
        const std::uint64_t parts = integer_power(base_, digits);
        const auto row = points_.row(set_, d);
        for (std::size_t i = 0; i < row.size(); ++i) {
            const std::uint64_t centre = (std::uint64_t{row[i]} << 1) + 1;  // times 2^-33
            cell_[i] = cell_[i] * parts + static_cast<std::uint64_t>(centre * parts >> 33);
        }
    }

    [[nodiscard]] bool hold_as_many() const {
        std::vector<std::uint64_t> sorted = cell_;
        std::sort(sorted.begin(), sorted.end());
        for (std::size_t i = 0; i + most_ < sorted.size(); ++i) {
            if (sorted[i] == sorted[i + most_]) return false;
        }
        return true;
    }

    const PointSet& points_;
    std::uint64_t set_;
    std::uint32_t base_;
    std::uint64_t most_;
    std::vector<std::uint64_t> cell_;
};

}  // namespace

std::optional<std::uint32_t> net_parameter(const PointSet& points, std::uint64_t set, std::uint32_t base) {
    std::uint32_t m = 0;
    while (integer_power(base, m) < points.points) ++m;
    if (integer_power(base, m) != points.points) return std::nullopt;
    for (std::uint32_t t = 0; t < m; ++t) {
        if (Intervals(points, set, base, integer_power(base, t)).are_fair(m - t)) return t;
    }
    return m;
}

}  // namespace ff::samplers
