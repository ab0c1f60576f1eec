#pragma once

namespace ff::test {

/// Indices of faces of a box, which count from 0 in code; names count from 1.
inline constexpr int face_1 = 0, face_2 = 1, face_6 = 5;

}  // namespace ff::test
