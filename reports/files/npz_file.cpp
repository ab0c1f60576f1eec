#include "reports/files/npz_file.hpp"

#include "core/support/error.hpp"

#include <fmt/format.h>

#include <boost/crc.hpp>

#include <array>
#include <bit>
#include <limits>

namespace ff::reports {
namespace {

static_assert(std::endian::native == std::endian::little);

template <class Number>
void append(std::string& bytes, Number number) {
    const auto parts = std::bit_cast<std::array<char, sizeof(Number)>>(number);
    bytes.append(parts.data(), parts.size());
}

/// An array in NumPy's format, version 1.0.
std::string array_file(std::string_view type, std::string_view shape, std::span<const std::byte> values) {
    constexpr std::size_t before = 10;  // magic, version, length of the header
    constexpr std::size_t alignment = 64;
    std::string header = fmt::format("{{'descr': '{}', 'fortran_order': False, 'shape': {}, }}", type, shape);
    header.append((alignment - (before + header.size() + 1) % alignment) % alignment, ' ');
    header += '\n';
    std::string file("\x93NUMPY\x01\x00", 8);
    append(file, static_cast<std::uint16_t>(header.size()));
    file += header;
    file.append(reinterpret_cast<const char*>(values.data()), values.size());
    return file;
}

}  // namespace

NpzFile::NpzFile(std::ostream& out, std::size_t bytes, std::string_view content) : out_(out) {
    constexpr std::size_t of_headers = 4096;
    if (bytes + of_headers > std::numeric_limits<std::uint32_t>::max())
        throw UserError(fmt::format("{} (an .npz file holds 4 GiB). Read them from the SQLite file.", content));
}

void NpzFile::add(std::string_view name, std::string_view shape, std::span<const std::int32_t> values) {
    add_file(name, array_file("<i4", shape, std::as_bytes(values)));
}

void NpzFile::add(std::string_view name, std::string_view shape, std::span<const std::int64_t> values) {
    add_file(name, array_file("<i8", shape, std::as_bytes(values)));
}

void NpzFile::add(std::string_view name, std::string_view shape, std::span<const float> values) {
    add_file(name, array_file("<f4", shape, std::as_bytes(values)));
}

void NpzFile::add(std::string_view name, std::string_view shape, std::span<const double> values) {
    add_file(name, array_file("<f8", shape, std::as_bytes(values)));
}

void NpzFile::add(std::string_view name, std::string_view text) {
    add_file(name, array_file(fmt::format("|S{}", text.size()), "()", std::as_bytes(std::span(text))));
}

void NpzFile::add_file(std::string_view array, const std::string& content) {
    const std::string name = fmt::format("{}.npy", array);
    boost::crc_32_type checksum;
    checksum.process_bytes(content.data(), content.size());
    std::string entry;
    constexpr std::uint16_t version = 20;
    constexpr std::uint16_t first_day = 0x21;  // 1 January 1980, whenever it is written
    for (const std::uint16_t word : {version, {}, {}, {}, first_day}) append(entry, word);
    append(entry, std::uint32_t{checksum.checksum()});
    for (int k = 0; k < 2; ++k) append(entry, static_cast<std::uint32_t>(content.size()));
    append(entry, static_cast<std::uint16_t>(name.size()));
    append(entry, std::uint16_t{0});
    append(directory_, std::uint32_t{0x02014b50});
    append(directory_, version);
    directory_ += entry;
    directory_.append(10, '\0');
    append(directory_, static_cast<std::uint32_t>(size_));
    directory_ += name;
    ++files_;
    std::string head;
    append(head, std::uint32_t{0x04034b50});
    for (const std::string_view part :
         {std::string_view(head), std::string_view(entry), std::string_view(name), std::string_view(content)})
        put(part);
}

void NpzFile::finish() {
    std::string end;
    append(end, std::uint32_t{0x06054b50});
    append(end, std::uint32_t{0});
    for (int k = 0; k < 2; ++k) append(end, files_);
    append(end, static_cast<std::uint32_t>(directory_.size()));
    append(end, static_cast<std::uint32_t>(size_));
    append(end, std::uint16_t{0});
    put(directory_);
    put(end);
}

void NpzFile::put(std::string_view bytes) {
    size_ += bytes.size();
    out_.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
}

}  // namespace ff::reports
