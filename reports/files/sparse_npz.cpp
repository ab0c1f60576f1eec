#include "reports/files/sparse_npz.hpp"

#include "core/support/contract.hpp"
#include "core/support/error.hpp"

#include <fmt/format.h>

#include <boost/crc.hpp>

#include <array>
#include <bit>
#include <cstdint>
#include <limits>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace ff::reports {
namespace {

static_assert(std::endian::native == std::endian::little);

template <class Number>
void append(std::string& bytes, Number number) {
    const auto parts = std::bit_cast<std::array<char, sizeof(Number)>>(number);
    bytes.append(parts.data(), parts.size());
}

/// An array in NumPy's format, version 1.0. @param shape  as Python writes a tuple
template <class Number>
std::string array_file(std::string_view type, std::string_view shape, std::span<const Number> values) {
    constexpr std::size_t before = 10;  // magic, version, length of the header
    constexpr std::size_t alignment = 64;
    std::string header = fmt::format("{{'descr': '{}', 'fortran_order': False, 'shape': {}, }}", type, shape);
    header.append((alignment - (before + header.size() + 1) % alignment) % alignment, ' ');
    header += '\n';
    std::string file("\x93NUMPY\x01\x00", 8);
    append(file, static_cast<std::uint16_t>(header.size()));
    file += header;
    file.append(reinterpret_cast<const char*>(values.data()), values.size_bytes());
    return file;
}

/// A zip archive whose files are stored as they are.
class Archive {
  public:
    explicit Archive(std::ostream& out) : out_(out) {}

    void add(std::string_view name, const std::string& content) {
        boost::crc_32_type checksum;
        checksum.process_bytes(content.data(), content.size());
        std::string entry;
        constexpr std::uint16_t version = 20;
        constexpr std::uint16_t first_day = 0x21;  // 1 January 1980: the same matrix, the same bytes
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
        put(head);
        put(entry);
        put(name);
        put(content);
    }

    void finish() {
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

  private:
    std::ostream& out_;
    std::string directory_;
    std::uint64_t size_ = 0;
    std::uint16_t files_ = 0;

    void put(std::string_view bytes) {
        size_ += bytes.size();
        out_.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    }
};

}  // namespace

void write_sparse_npz(std::ostream& out, const Eigen::SparseMatrix<double, Eigen::RowMajor>& matrix) {
    FF_EXPECT(matrix.isCompressed());
    const auto entries = static_cast<std::size_t>(matrix.nonZeros());
    const auto rows = static_cast<std::size_t>(matrix.rows());
    constexpr std::size_t of_headers = 4096;
    const std::size_t size = entries * (sizeof(double) + sizeof(int)) + (rows + 1) * sizeof(int) + of_headers;
    if (size > std::numeric_limits<std::uint32_t>::max())
        throw UserError(
            fmt::format("a matrix of {} entries (an .npz file holds 4 GiB). Read them from the SQLite file.", entries));
    const std::array shape{std::int64_t{matrix.rows()}, std::int64_t{matrix.cols()}};
    const std::string of_entries = fmt::format("({},)", entries);
    Archive archive(out);
    archive.add("indices.npy", array_file("<i4", of_entries, std::span(matrix.innerIndexPtr(), entries)));
    archive.add("indptr.npy",
                array_file("<i4", fmt::format("({},)", rows + 1), std::span(matrix.outerIndexPtr(), rows + 1)));
    archive.add("format.npy", array_file("|S3", "()", std::span<const char>("csr", 3)));
    archive.add("shape.npy", array_file("<i8", "(2,)", std::span<const std::int64_t>(shape)));
    archive.add("data.npy", array_file("<f8", of_entries, std::span(matrix.valuePtr(), entries)));
    archive.finish();
}

}  // namespace ff::reports
