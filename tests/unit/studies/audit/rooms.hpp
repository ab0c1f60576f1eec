#pragma once

#include <string>

namespace ff::test {

/// An L-shaped room: the audit knows no congruent pairs in it, walls hide walls, and its corners are rounded to
/// centimetres.
inline const std::string l_room =
    R"(room.obj\n# closed\nv 0 0 0\nv 4.27 0 0\nv 4.27 2.13 0\nv 2.13 2.13 0\nv 2.13 4.27 0)"
    R"(\nv 0 4.27 0\nv 0 0 3.05\nv 4.27 0 3.05\nv 4.27 2.13 3.05\nv 2.13 2.13 3.05)"
    R"(\nv 2.13 4.27 3.05\nv 0 4.27 3.05\ng floor\nf 1 2 3 4 5 6\ng roof\nf 12 11 10 9 8 7)"
    R"(\ng a-south\nf 1 7 8 2\ng east\nf 2 8 9 3\ng inner-north\nf 3 9 10 4)"
    R"(\ng inner-east\nf 4 10 11 5\ng north\nf 5 11 12 6\ng west\nf 6 12 7 1)";

}  // namespace ff::test
