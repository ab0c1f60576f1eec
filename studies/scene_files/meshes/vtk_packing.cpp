#include "studies/scene_files/meshes/vtk_packing.hpp"

#include <fmt/format.h>
#include <zlib.h>

#include <cctype>
#include <vector>

// The format: https://docs.vtk.org/en/latest/vtk_file_formats/vtkxml_file_format.html

namespace ff::studies::meshes {
namespace {

/// Bytes of an array, from front to back.
class EncodedBytes {
  public:
    EncodedBytes(const std::string& place, std::string_view text, ByteForm form)
        : place_(place), text_(text), form_(form) {}

    [[nodiscard]] const std::string& place() const { return place_; }

    /// The next bytes. @throws UserError where there are fewer, before storage is taken for them
    std::string take(std::uint64_t count) {
        const std::size_t most = form_ == ByteForm::raw ? text_.size() : decoded_.size() + text_.size();
        if (count > most)
            refuse(
                place_,
                "{} bytes are announced, and {} follow (the file was cut off, or the number is wrong). Write it again.",
                count, most);
        std::string bytes;
        if (form_ == ByteForm::raw) {
            bytes = text_.substr(0, count);
            text_.remove_prefix(count);
            return bytes;
        }
        while (decoded_.size() < count) decode_group();
        bytes = decoded_.substr(0, count);
        decoded_.erase(0, count);
        return bytes;
    }

  private:
    const std::string& place_;
    std::string_view text_;
    ByteForm form_;
    std::string decoded_;  ///< the bytes of the last group of base64 that were not taken yet

    void decode_group() {
        constexpr std::string_view digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
        std::uint32_t bits = 0;
        int count = 0;
        int padding = 0;
        while (count < 4) {
            if (text_.empty()) refuse(place_, "its bytes end early (the file was cut off). Write it again.");
            const char c = text_.front();
            text_.remove_prefix(1);
            if (std::isspace(static_cast<unsigned char>(c)) != 0) continue;
            const std::size_t digit = c == '=' ? 0 : digits.find(c);
            if (digit == std::string_view::npos || (padding > 0 && c != '=') || (c == '=' && count < 2))
                refuse(place_, "a character that is not base64 (damaged). Write it again.");
            padding += c == '=' ? 1 : 0;
            bits = bits << 6 | static_cast<std::uint32_t>(digit);
            ++count;
        }
        for (int byte = 0; byte < 3 - padding; ++byte)
            decoded_ += static_cast<char>(static_cast<unsigned char>(bits >> (16 - 8 * byte) & 0xff));
    }
};

std::uint64_t next_of_header(EncodedBytes& bytes, const Packing& packing) {
    const std::string number = bytes.take(packing.header.bytes);
    return static_cast<std::uint64_t>(MeshInput::part(bytes.place(), number, packing.encoding).whole(packing.header));
}

std::string inflate_block(const std::string& packed, std::uint64_t size, const std::string& place) {
    constexpr std::uint64_t most_expansion = 1032;  // what deflate can do: https://zlib.net/zlib_tech.html
    if (size / most_expansion > packed.size())
        refuse(place, "a block of {} bytes is said to have {} (more than zlib can pack into it). Write it again.",
               packed.size(), size);
    std::string block(size, '\0');
    uLongf length = size;
    // NOLINTNEXTLINE(cppcoreguidelines-pro-type-reinterpret-cast): bytes of zlib are unsigned
    const auto* const source = reinterpret_cast<const Bytef*>(packed.data());
    // NOLINTNEXTLINE(cppcoreguidelines-pro-type-reinterpret-cast): the same
    const int status = uncompress(reinterpret_cast<Bytef*>(block.data()), &length, source, packed.size());
    if (status != Z_OK || length != size)
        refuse(place,
               "a compressed block cannot be unpacked to its {} bytes (damaged). Write it again, or uncompressed.",
               size);
    return block;
}

std::string unpack_blocks(EncodedBytes& bytes, const Packing& packing) {
    const auto next = [&] { return next_of_header(bytes, packing); };
    const std::uint64_t blocks = next();
    if (blocks == 0) return {};
    const std::uint64_t size = next();
    const std::uint64_t last_size = next();
    std::vector<std::uint64_t> packed_sizes;
    for (std::uint64_t i = 0; i < blocks; ++i) packed_sizes.push_back(next());
    std::string all;
    for (std::uint64_t i = 0; i < blocks; ++i) {
        const bool is_partial = i + 1 == blocks && last_size != 0;
        all += inflate_block(bytes.take(packed_sizes[i]), is_partial ? last_size : size, bytes.place());
    }
    return all;
}

}  // namespace

std::string unpack(const std::string& place, std::string_view text, ByteForm form, const Packing& packing) {
    EncodedBytes bytes(place, text, form);
    if (packing.is_compressed) return unpack_blocks(bytes, packing);
    return bytes.take(next_of_header(bytes, packing));
}

}  // namespace ff::studies::meshes
