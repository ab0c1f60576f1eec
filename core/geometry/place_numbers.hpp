#pragma once

#include <Eigen/Core>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <unordered_map>
#include <utility>
#include <vector>

namespace ff {

/// Numbers places from 0 up; places that differ only by rounding get the same number.
class PlaceNumbers {
  public:
    /// @param nearest  places nearer than this are one, > 0
    explicit PlaceNumbers(double nearest) : nearest_(nearest) {}

    std::uint32_t operator()(const Eigen::Vector3d& place) {
        // Cells are so large that a place seldom is near to more than one, and so small that they hold few places.
        const double cell = 16 * nearest_;
        Cell at;
        Cell low;
        Cell high;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const double x = place[static_cast<Eigen::Index>(axis)];
            at[axis] = std::floor(x / cell);
            low[axis] = std::floor((x - nearest_) / cell);
            high[axis] = std::floor((x + nearest_) / cell);
        }
        for (unsigned corner = 0; corner < 8; ++corner) {
            Cell near = low;
            bool is_new = true;
            for (unsigned axis = 0; axis < 3; ++axis) {
                if ((corner >> axis & 1U) == 0) continue;
                is_new = is_new && high.at(axis) != low.at(axis);
                near.at(axis) = high.at(axis);
            }
            const auto here = is_new ? places_.find(near) : places_.end();
            if (here == places_.end()) continue;
            for (const auto& [other, number] : here->second) {
                if ((other - place).cwiseAbs().maxCoeff() < nearest_) return number;
            }
        }
        places_[at].emplace_back(place, count_);
        return count_++;
    }

  private:
    using Cell = std::array<double, 3>;
    struct CellHash {
        std::size_t operator()(const Cell& cell) const {
            std::size_t hash = 0;
            for (const double x : cell) hash = hash * 0x9e3779b97f4a7c15U + std::hash<double>{}(x);
            return hash;
        }
    };
    double nearest_;
    std::uint32_t count_ = 0;
    std::unordered_map<Cell, std::vector<std::pair<Eigen::Vector3d, std::uint32_t>>, CellHash> places_;
};

/// Places nearer than this share of a scene's largest coordinate are one.
inline constexpr double resolution_of_places = 0x1p-36;

}  // namespace ff
