#include "core/estimators/graded_map.hpp"

#include "core/support/contract.hpp"
#include "core/visibility/occlusion.hpp"

#include <algorithm>
#include <cstddef>

namespace ff {
namespace {

constexpr std::uint32_t edge_power = 3;
constexpr std::uint32_t vertex_power = 2;

/// The same patch with the coordinate along one of its edges running the other way.
void turn(Parallelogram& patch, Eigen::Vector3d& edge) {
    patch.corner += edge;
    edge = -edge;
}

bool is_of_parallelograms(const Scene& scene, int face) {
    return std::all_of(scene.surfaces.begin(), scene.surfaces.end(), [face](const Surface& surface) {
        return surface.face != face || std::holds_alternative<Parallelogram>(surface.shape);
    });
}

bool are_graded(const Scene& scene, int from, int to) {
    return is_of_parallelograms(scene, from) && is_of_parallelograms(scene, to) && !may_be_occluded(scene, from, to);
}

/// Between any two points on the inside of a sphere the kernel has the same value.
bool are_inside_one_sphere(const Scene& scene, int from, int to) {
    const SphereZone* first = nullptr;
    for (const Surface& surface : scene.surfaces) {
        if (surface.face != from && surface.face != to) continue;
        const auto* zone = std::get_if<SphereZone>(&surface.shape);
        if (zone == nullptr || zone->facing != Facing::inward) return false;
        if (first == nullptr) first = zone;
        if (zone->centre != first->centre || zone->radius != first->radius) return false;
    }
    return first != nullptr;
}

}  // namespace

std::optional<double> kernel_tail_index(Contact contact, PointMap map) {
    const bool graded = map == PointMap::graded;
    switch (contact) {
        case Contact::none:
            break;
        case Contact::point:
            return 2.0;
        case Contact::vertex:
            return graded ? std::nullopt : std::optional(2.0);
        case Contact::edge:
            return graded ? (edge_power + 2) / 2.0 : 1.5;
    }
    return std::nullopt;
}

bool kernel_has_variance(const Scene& scene, int from, int to, PointMap map) {
    const Contact contact = closest_contact(scene, from, to);
    if (contact == Contact::none || are_inside_one_sphere(scene, from, to)) return true;
    const auto index = kernel_tail_index(contact, are_graded(scene, from, to) ? map : PointMap::uniform);
    return !index || *index > 2;
}

std::optional<GradedPair> grade_pair(const Parallelogram& from, const Parallelogram& to) {
    const Touch touch = find_touch(from, to);
    if (touch.contact != Contact::edge && touch.contact != Contact::vertex) return std::nullopt;
    GradedPair pair{from, to};
    const std::array edges{&pair.from.edge_u, &pair.from.edge_v, &pair.to.edge_u, &pair.to.edge_v};
    for (std::size_t d = 0; d < 4; ++d) {
        if (touch.sides[d] != Side::neither) pair.power[d] = touch.contact == Contact::edge ? edge_power : vertex_power;
        if (touch.sides[d] == Side::high) turn(d < 2 ? pair.from : pair.to, *edges[d]);
    }
    return pair;
}

void grade_points(const std::array<std::uint32_t, 4>& power, WeightedBlock& block) {
    FF_EXPECT(block.dimension == 4);
    for (std::size_t d = 0; d < 4; ++d) {
        if (power[d] == 1) continue;
        for (std::size_t i = 0; i < block.size; ++i) {
            const double s = block.coordinate[d][i];
            double slope = power[d];
            for (std::uint32_t p = 1; p < power[d]; ++p) slope *= s;
            block.coordinate[d][i] = slope * s / power[d];
            block.weight[i] *= slope;
        }
    }
}

}  // namespace ff
