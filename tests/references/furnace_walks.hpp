#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <random>

namespace ff::test {

/// Random walks through the furnace of docs/scenes.md with the materials of docs/heat.md: a room of 4 x 3 x 2.5 with a
/// block of 1 x 1 x 1.5 on its floor. A walk begins on the block, continues in directions by the cosine law, and ends
/// on the block (emissivity 0.8) or on the roof (0.6); the other faces are adiabatic and pass everything on. A face has
/// one radiosity: what it passes on leaves it from anywhere. No form factor, no system of equations, and nothing of
/// this project: walks are independent, so that the number of those that end on the roof is binomial.
class FurnaceWalks {
  public:
    explicit FurnaceWalks(std::uint64_t seed) : engine_(seed) {}

    /// The number of walks, out of so many, that end on the roof.
    std::uint64_t to_roof(std::uint64_t walks) {
        std::uint64_t count = 0;
        for (std::uint64_t i = 0; i < walks; ++i) {
            if (ends_on_roof()) ++count;
        }
        return count;
    }

  private:
    using Vector = std::array<double, 3>;
    static constexpr Vector room{4, 3, 2.5};
    static constexpr Vector block_low{1.5, 1, 0};
    static constexpr Vector block_high{2.5, 2, 1.5};
    static constexpr double block_emissivity = 0.8;
    static constexpr double roof_emissivity = 0.6;
    enum class Face { adiabatic, roof, block };

    std::mt19937_64 engine_;
    Vector place_{};
    std::size_t axis_ = 0;  ///< axis of the normal
    double side_ = 1;       ///< its sign

    double uniform() { return static_cast<double>(engine_() >> 11) * 0x1p-53; }

    /// Anywhere on the block: four sides of 1.5, and a top of 1.
    void leave_block() {
        const double u = 7 * uniform();
        axis_ = u < 3 ? 0 : u < 6 ? 1 : 2;
        side_ = axis_ == 2 || u < 1.5 || (u >= 3 && u < 4.5) ? 1 : -1;
        for (std::size_t k = 0; k < 3; ++k)
            place_.at(k) = block_low.at(k) + (block_high.at(k) - block_low.at(k)) * uniform();
        place_.at(axis_) = side_ > 0 ? block_high.at(axis_) : block_low.at(axis_);
    }

    /// Anywhere on the wall that was met; the floor is bare where the block stands.
    void leave_wall() {
        do {
            for (std::size_t k = 0; k < 3; ++k) {
                if (k != axis_) place_.at(k) = room.at(k) * uniform();
            }
        } while (axis_ == 2 && side_ > 0 && is_within_block(0) && is_within_block(1));
    }

    [[nodiscard]] bool is_within_block(std::size_t k) const {
        return place_.at(k) > block_low.at(k) && place_.at(k) < block_high.at(k);
    }

    /// A direction by the cosine law: its foot is uniform on the unit disc.
    Vector direction() {
        double x = 0;
        double y = 0;
        do {
            x = 2 * uniform() - 1;
            y = 2 * uniform() - 1;
        } while (x * x + y * y >= 1);
        Vector way{};
        way.at(axis_) = side_ * std::sqrt(1 - x * x - y * y);
        way.at((axis_ + 1) % 3) = x;
        way.at((axis_ + 2) % 3) = y;
        return way;
    }

    /// Goes to the wall that a ray meets, or says that it meets the block.
    Face move(const Vector& way) {
        double end = std::numeric_limits<double>::max();
        double enter = 0;
        double leave = end;
        std::size_t wall = 0;
        for (std::size_t k = 0; k < 3; ++k) {
            const double d = way.at(k);
            const double x = place_.at(k);
            if (d == 0) {
                if (!is_within_block(k)) leave = 0;
                continue;
            }
            const auto length_to = [&](double from_below, double from_above) {
                return ((d > 0 ? from_below : from_above) - x) / d;
            };
            if (length_to(room.at(k), 0) < end) {
                end = length_to(room.at(k), 0);
                wall = k;
            }
            enter = std::max(enter, length_to(block_low.at(k), block_high.at(k)));
            leave = std::min(leave, length_to(block_high.at(k), block_low.at(k)));
        }
        if (enter > 0 && enter < leave) return Face::block;
        axis_ = wall;
        side_ = way.at(wall) > 0 ? -1 : 1;
        place_.at(wall) = side_ < 0 ? room.at(wall) : 0;
        return wall == 2 && side_ < 0 ? Face::roof : Face::adiabatic;
    }

    bool ends_on_roof() {
        leave_block();
        for (;;) {
            const Face met = move(direction());
            if (met == Face::roof && uniform() < roof_emissivity) return true;
            if (met == Face::block && uniform() < block_emissivity) return false;
            if (met == Face::block)
                leave_block();
            else
                leave_wall();
        }
    }
};

}  // namespace ff::test
