#pragma once

#include "studies/scene_files/meshes/mesh_input.hpp"

#include <string>
#include <string_view>

namespace ff::studies::meshes {

/// How a file of VTK's XML packs the bytes of its arrays.
struct Packing {
    Encoding encoding = Encoding::little_endian;
    NumberType header{NumberType::Kind::natural, 4};
    bool is_compressed = false;  ///< compressed by zlib, in blocks
};

/// How bytes are stored in a file: in base64 or raw.
enum class ByteForm { raw, base64 };

/// The bytes of an array, behind the header that tells how many there are.
/// @param place  names file and array in messages  @throws UserError where they are fewer, or damaged
std::string unpack(const std::string& place, std::string_view text, ByteForm form, const Packing& packing);

}  // namespace ff::studies::meshes
