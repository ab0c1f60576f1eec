#pragma once

#include "core/geometry/scene.hpp"

#include <cstdint>

namespace ff {

/// The end of a pair of surfaces, `from` or `to`, that a side of a body has to face for what it hides to count: sides
/// that turn their back to it hide nothing that no other side of the body hides.
enum class FacedEnd : std::uint8_t { either, from, to };

/// What may stand between two surfaces.
struct Blocker {
    const Surface* surface = nullptr;
    FacedEnd faces = FacedEnd::either;

    Blocker(const Surface* blocker, FacedEnd end = FacedEnd::either)  // NOLINT(google-explicit-constructor): a surface
        : surface(blocker), faces(end) {}                             // alone hides whatever it faces
};

}  // namespace ff
