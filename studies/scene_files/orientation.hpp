#pragma once

#include "core/geometry/fwd.hpp"

#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace ff::studies {

/// Surfaces of a face that face the other way than the rest of it, for example because some of its triangles are wound
/// the other way: then neighbours run through their common edge in the same direction.
struct Winding {
    /// Surfaces to reverse, so that all of each connected part of a face faces the same way.
    std::vector<std::size_t> turned;
    std::vector<int> undecided;  ///< faces of which nothing decides, or area and sight disagree, which side is right
};

/// Surfaces of a face are joined where they meet. Those that clearly have the smaller area are turned round; where
/// halves are nearly equal, those without which clearly more is seen of other faces.
Winding find_winding(const Scene& scene);

/// Two faces that run through a common edge in the same direction: one of them may face the wrong way.
std::vector<std::pair<int, int>> faces_wound_differently(const Scene& scene);

/// Where rays from both sides of each face end. Sides: 0 is the radiating one, 1 the back.
struct SideProbes {
    explicit SideProbes(std::size_t count) : faces(count), ends(4 * count * count), rays(2 * count), lost(2 * count) {}

    std::size_t faces;
    std::vector<std::size_t> ends;  ///< use `met`
    std::vector<std::size_t> rays;  ///< [2 * face + side]
    std::vector<std::size_t> lost;  ///< [2 * face + side]
    double area = 0;                ///< of the surfaces whose front sides were probed
    double area_lost = 0;           ///< the same, each times its share of lost rays

    /// Number of rays from one side of a face that ended on one side of another.
    [[nodiscard]] std::size_t& met(std::size_t from, std::size_t side, std::size_t to, std::size_t on) {
        return ends[((2 * from + side) * faces + to) * 2 + on];
    }
    [[nodiscard]] std::size_t met(std::size_t from, std::size_t side, std::size_t to, std::size_t on) const {
        return ends[((2 * from + side) * faces + to) * 2 + on];
    }
    /// Whether a ray from that side of any face ended on a face.
    [[nodiscard]] bool any_met(std::size_t side) const {
        for (std::size_t from = 0; from < faces; ++from) {
            if (lost[2 * from + side] < rays[2 * from + side]) return true;
        }
        return false;
    }
};

/// Shoots 64 rays from both sides of each surface of a face, or of a subset where there are more than 1000 surfaces.
/// The same rays for the same scene.
SideProbes probe_sides(const Scene& given);

/// A face from a surface of which more than half of 64 rays meet nothing, which no gap of rounding explains. Empty
/// where none was found, though some face may see out. At most 1000 surfaces are looked at.
std::optional<std::size_t> face_open_to_outside(const Scene& given);

/// The faces that seem to be reversed: with them flipped, at most a tenth as many rays end on backs (or, in a closed
/// scene, nowhere), and at least half of those on fronts. Empty where fewer than one ray in 20 ends so, or where
/// flipping does not explain it.
std::vector<std::size_t> turned_faces(const SideProbes& probes, bool closed);

}  // namespace ff::studies
