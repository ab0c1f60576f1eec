#pragma once

#include "core/geometry/fwd.hpp"
#include "stats/basics/binomial.hpp"
#include "studies/heat/heat.hpp"
#include "studies/heat/materials.hpp"

#include <string_view>
#include <utility>

namespace ff::studies::heat {

/// The materials of the first case of a file.
inline Materials read_materials(std::string_view toml, std::string_view origin, const NamedFaces& faces) {
    return std::move(read_cases(toml, origin, faces).front());
}

/// Scenes beside the catalogue whose flows are known.

/// Coaxial cylinders of radius 1 and 2 and height 2, closed by rings: faces inner, outer, bottom, top.
Scene annulus_scene();

/// Form factors of the annulus, by the closed forms of the cylinders, reciprocity and closure.
double annulus_factor(int from, int to);

/// Form factors of the scene "cube", by the textbook's formula for opposite faces, and closure. @see [howell] C-11
double cube_factor(int from, int to);

/// The room with a block of docs/scenes.md, with the materials of docs/heat.md: the block has 1200 K, the roof 400 K,
/// the other faces are adiabatic.
Scene furnace_scene();
Materials furnace_materials();

/// W that the block gives off, with an interval of its own at level 1 - 1e-6: by 10^9 independent random walks without
/// form factors (tests/references/furnace_walks.hpp says of what kind, and how they are repeated).
Bounds furnace_power();

/// The walks behind that value, and the number of them that end on the roof: seeds 1 to 4, 250 000 000 each.
stats::Proportion furnace_walks();

}  // namespace ff::studies::heat
