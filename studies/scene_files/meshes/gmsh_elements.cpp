#include "studies/scene_files/meshes/gmsh_elements.hpp"

#include <algorithm>
#include <array>
#include <utility>

// Numbers of types: https://gmsh.info/doc/texinfo/gmsh.html#MSH-file-format

namespace ff::studies::meshes {
namespace {

constexpr std::array<std::pair<std::uint8_t, GmshElement>, 66> gmsh_types{{
    {1, {1, 2, 2}},   {2, {2, 3, 3}},   {3, {2, 4, 4}},   {4, {3, 4, 4}},    {5, {3, 8, 8}},    {6, {3, 6, 6}},
    {7, {3, 5, 5}},   {8, {1, 2, 3}},   {9, {2, 3, 6}},   {10, {2, 4, 9}},   {11, {3, 4, 10}},  {12, {3, 8, 27}},
    {13, {3, 6, 18}}, {14, {3, 5, 14}}, {15, {0, 1, 1}},  {16, {2, 4, 8}},   {17, {3, 8, 20}},  {18, {3, 6, 15}},
    {19, {3, 5, 13}}, {20, {2, 3, 9}},  {21, {2, 3, 10}}, {22, {2, 3, 12}},  {23, {2, 3, 15}},  {24, {2, 3, 15}},
    {25, {2, 3, 21}}, {26, {1, 2, 4}},  {27, {1, 2, 5}},  {28, {1, 2, 6}},   {29, {3, 4, 20}},  {30, {3, 4, 35}},
    {31, {3, 4, 56}}, {36, {2, 4, 16}}, {37, {2, 4, 25}}, {38, {2, 4, 36}},  {39, {2, 4, 12}},  {40, {2, 4, 16}},
    {41, {2, 4, 20}}, {42, {2, 3, 28}}, {43, {2, 3, 36}}, {44, {2, 3, 45}},  {45, {2, 3, 55}},  {46, {2, 3, 66}},
    {47, {2, 4, 49}}, {48, {2, 4, 64}}, {49, {2, 4, 81}}, {50, {2, 4, 100}}, {51, {2, 4, 121}}, {52, {2, 3, 18}},
    {53, {2, 3, 21}}, {54, {2, 3, 24}}, {55, {2, 3, 27}}, {56, {2, 3, 30}},  {57, {2, 4, 24}},  {58, {2, 4, 28}},
    {59, {2, 4, 32}}, {60, {2, 4, 36}}, {61, {2, 4, 40}}, {62, {1, 2, 7}},   {63, {1, 2, 8}},   {64, {1, 2, 9}},
    {65, {1, 2, 10}}, {66, {1, 2, 11}}, {90, {3, 6, 40}}, {91, {3, 6, 75}},  {92, {3, 8, 64}},  {93, {3, 8, 125}},
}};

}  // namespace

std::optional<GmshElement> gmsh_element(std::int64_t type) {
    const auto* const found =
        std::find_if(gmsh_types.begin(), gmsh_types.end(), [&](const auto& entry) { return entry.first == type; });
    return found == gmsh_types.end() ? std::nullopt : std::optional(found->second);
}

}  // namespace ff::studies::meshes
