#include "studies/comparison/face_difference.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>
#include <vector>

namespace ff::studies {

std::string difference_of_faces(const Scene& a, const Scene& b) {
    if (a.canonical == b.canonical) return {};
    if (a.faces.size() != b.faces.size())
        return fmt::format("{} in the first and {} in the second", a.faces.size(), b.faces.size());
    const auto names = std::mismatch(a.faces.begin(), a.faces.end(), b.faces.begin());
    if (names.first != a.faces.end())
        return fmt::format("number {} is '{}' in the first and '{}' in the second", names.first - a.faces.begin() + 1,
                           *names.first, *names.second);
    const auto faces_of = [](const Scene& scene) {
        std::vector<std::pair<int, Shape>> shapes;
        for (const Surface& surface : scene.surfaces) {
            if (surface.face >= 0) shapes.emplace_back(surface.face, surface.shape);
        }
        std::stable_sort(shapes.begin(), shapes.end(), [](const auto& x, const auto& y) { return x.first < y.first; });
        return shapes;
    };
    const auto in_a = faces_of(a);
    const auto in_b = faces_of(b);
    const auto shapes = std::mismatch(in_a.begin(), in_a.end(), in_b.begin(), in_b.end());
    if (shapes.first == in_a.end() && shapes.second == in_b.end()) return {};
    const int face = std::min(shapes.first == in_a.end() ? shapes.second->first : shapes.first->first,
                              shapes.second == in_b.end() ? shapes.first->first : shapes.second->first);
    return fmt::format("'{}' has another place or shape, or other surfaces", a.faces[static_cast<std::size_t>(face)]);
}

}  // namespace ff::studies
