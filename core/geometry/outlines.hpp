#pragma once

#include "core/geometry/convex_polygon.hpp"
#include "core/geometry/fwd.hpp"

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <utility>
#include <vector>

namespace ff {

/// The outlines of the polygons of a scene, whose corners are numbered by place, so that common edges are known.
class Outlines {
  public:
    /// @param gap  places nearer than this are one, > 0
    Outlines(const Scene& scene, double gap);

    [[nodiscard]] std::size_t size() const { return polygons_.size(); }
    /// Corners of a surface, counter-clockwise around its normal; none of a round one.
    [[nodiscard]] const ConvexPolygon& polygon(std::uint32_t surface) const { return polygons_[surface]; }
    /// Their numbers.
    [[nodiscard]] const std::vector<std::uint32_t>& ring(std::uint32_t surface) const { return rings_[surface]; }
    [[nodiscard]] const Eigen::Vector3d& place(std::uint32_t number) const { return places_[number]; }
    /// The surfaces that have this edge, in either direction. @pre there is one
    [[nodiscard]] const std::vector<std::uint32_t>& at_edge(std::uint32_t a, std::uint32_t b) const {
        return at_edge_.at(edge_between(a, b));
    }
    /// Whether a surface runs through an edge in this direction.
    [[nodiscard]] bool runs(std::uint32_t surface, std::uint32_t from, std::uint32_t to) const;
    /// The surface that bounds a body together with this one at an edge: the first behind it, all around the edge, if
    /// its back is towards this one's. Empty where there is none; the body may then lie against another one.
    [[nodiscard]] std::optional<std::uint32_t> partner_at(std::uint32_t a, std::uint32_t b,
                                                          std::uint32_t surface) const;
    /// A number for each surface, equal for those that bound a body together.
    [[nodiscard]] std::vector<std::uint32_t> bodies() const;

  private:
    using Edge = std::pair<std::uint32_t, std::uint32_t>;  // numbers of its ends
    const Scene& scene_;
    std::vector<ConvexPolygon> polygons_;
    std::vector<std::vector<std::uint32_t>> rings_;
    std::vector<Eigen::Vector3d> places_;
    std::map<Edge, std::vector<std::uint32_t>> at_edge_;

    [[nodiscard]] std::optional<std::uint32_t> partner_among(const std::vector<std::uint32_t>& at_edge,
                                                             const Edge& edge, std::uint32_t surface) const;
    static Edge edge_between(std::uint32_t a, std::uint32_t b) { return {std::min(a, b), std::max(a, b)}; }
};

}  // namespace ff
