#pragma once

#include "studies/scene_files/meshes/mesh_input.hpp"

#include <cstddef>
#include <string>
#include <string_view>

namespace ff::studies::meshes {

/// Bytes of an array in base64 or as they are, from front to back.
class EncodedBytes {
  public:
    enum class Form { raw, base64 };

    /// @param place  names file and array in messages
    EncodedBytes(std::string place, std::string_view text, Form form)
        : place_(std::move(place)), text_(text), form_(form) {}

    /// The next bytes. @throws UserError where there are fewer, before storage is taken for them
    std::string take(std::uint64_t count);

  private:
    std::string place_;
    std::string_view text_;
    Form form_;
    std::string decoded_;  ///< of the last group of base64, what was not taken yet

    void decode_group();
};

/// How a file of VTK's XML packs the bytes of its arrays.
struct Packing {
    Encoding encoding = Encoding::little_endian;
    NumberType header{NumberType::Kind::natural, 4};
    bool is_compressed = false;  ///< by zlib, in blocks
};

/// The bytes of an array, behind the header that tells how many there are.
/// @throws UserError where they are fewer, or damaged
std::string unpack(EncodedBytes bytes, const Packing& packing, const std::string& place);

}  // namespace ff::studies::meshes
