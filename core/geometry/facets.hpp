#pragma once

#include "core/geometry/scene.hpp"

#include <cstddef>

namespace ff {

/// A scene whose curved surfaces are replaced by polygons.
struct FacetedScene {
    Scene scene;
    std::size_t curved = 0;  ///< surfaces that were replaced
    double deviation = 0;    ///< largest distance of a place on such a surface from its polygons, at most
};

/// Replaces round surfaces by polygons whose corners lie on them: a full turn by so many, a sphere by half as many
/// zones. Grids are left out. @param facets  at least 3
FacetedScene with_facets(const Scene& scene, std::size_t facets);

}  // namespace ff
