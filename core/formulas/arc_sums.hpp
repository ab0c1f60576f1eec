#pragma once

#include "core/formulas/arc_terms.hpp"
#include "core/geometry/convex_polygon.hpp"

#include <Eigen/Core>
#include <boost/container/small_vector.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <span>
#include <utility>

namespace ff {

/// Adds up Lambert's formula for pieces of what is seen from several places, many edges at a time.
class ArcSums {
  public:
    ArcSums(Eigen::Vector3d normal, std::size_t places) : normal_(std::move(normal)), sums_(places, 0.0) {}

    /// @param piece  corners, in order
    /// @param sign  of its factor in the sum of a place
    template <class Polygon>
    void add(std::size_t place, const Polygon& piece, double sign) {
        for (std::size_t k = 0; k < piece.size(); ++k) {
            if (arcs_.is_full()) flush();
            of_[arcs_.size] = {static_cast<std::uint32_t>(place), sign};
            arcs_.add(piece[k], next_corner(piece, k));
        }
    }

    /// By place.
    [[nodiscard]] std::span<const double> result() {
        flush();
        return {sums_.data(), sums_.size()};
    }

  private:
    struct Owner {
        std::uint32_t place;
        double sign;
    };
    Eigen::Vector3d normal_;
    boost::container::small_vector<double, 64> sums_;
    Arcs arcs_;
    std::array<Owner, Arcs::capacity> of_;

    void flush() {
        std::array<double, Arcs::capacity> terms;
        find_arc_terms(arcs_, normal_, terms);
        for (std::size_t k = 0; k < arcs_.size; ++k)
            sums_[of_[k].place] += of_[k].sign * terms[k] * (0.5 / std::numbers::pi);
        arcs_.size = 0;
    }
};

}  // namespace ff
