#pragma once

#include "core/support/error.hpp"
#include "studies/scene_files/meshes/mesh_input.hpp"

#include <fmt/format.h>

#include <string>
#include <string_view>
#include <utility>

namespace ff::studies::meshes {

/// @param place  names file and array
template <class... Values>
[[noreturn]] void refuse(const std::string& place, fmt::format_string<Values...> problem, Values&&... values) {
    throw UserError("{}: {}", place, fmt::format(problem, std::forward<Values>(values)...));
}

/// How a file of VTK's XML packs the bytes of its arrays.
struct Packing {
    Encoding encoding = Encoding::little_endian;
    NumberType header{NumberType::Kind::natural, 4};
    bool is_compressed = false;  ///< compressed by zlib, in blocks
};

enum class ByteForm { raw, base64 };

/// The bytes of an array, behind the header that tells how many there are.
/// @param place  names file and array in messages  @throws UserError where they are fewer, or damaged
std::string unpack(const std::string& place, std::string_view text, ByteForm form, const Packing& packing);

}  // namespace ff::studies::meshes
