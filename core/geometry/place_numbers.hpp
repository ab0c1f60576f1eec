#pragma once

#include <Eigen/Core>

#include <array>
#include <cmath>
#include <cstdint>
#include <map>

namespace ff {

/// Places that are the same but for rounding have the same number. Two of them may be taken for different ones, where
/// a boundary of the lattice runs between them.
class PlaceNumbers {
  public:
    /// @param cell  places nearer than this are one, > 0
    explicit PlaceNumbers(double cell) : cell_(cell) {}

    std::uint32_t operator()(const Eigen::Vector3d& place) {
        const std::array<double, 3> at{std::round(place.x() / cell_), std::round(place.y() / cell_),
                                       std::round(place.z() / cell_)};
        return numbers_.try_emplace(at, static_cast<std::uint32_t>(numbers_.size())).first->second;
    }

    [[nodiscard]] std::size_t size() const { return numbers_.size(); }

  private:
    double cell_;
    std::map<std::array<double, 3>, std::uint32_t> numbers_;
};

/// Nearer places are one, as a share of a scene's largest coordinate.
inline constexpr double resolution_of_places = 0x1p-36;

}  // namespace ff
