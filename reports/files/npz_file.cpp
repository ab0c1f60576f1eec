#include "reports/files/npz_file.hpp"

#include "core/support/contract.hpp"
#include "core/support/error.hpp"
#include "reports/files/matrix_files.hpp"

#include <fmt/format.h>
#include <boost/crc.hpp>

#include <array>
#include <bit>
#include <cstdint>
#include <limits>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

namespace ff::reports {
namespace {

static_assert(std::endian::native == std::endian::little);

template <class Number>
void append(std::string& bytes, Number number) {
    const auto parts = std::bit_cast<std::array<char, sizeof(Number)>>(number);
    bytes.append(parts.data(), parts.size());
}

/// A file that numpy.load reads: a zip archive, not compressed, of arrays in NumPy's format. The same arrays give the
/// same bytes.
class NpzFile {
  public:
    /// @param bytes  of all arrays together @param content  what the arrays are, in words
    /// @throws UserError for more than a zip archive holds, 4 GiB
    NpzFile(std::ostream& out, std::size_t bytes, std::string_view content) : out_(out) {
        constexpr std::size_t of_headers = 4096;
        if (bytes + of_headers > std::numeric_limits<std::uint32_t>::max())
            throw UserError(fmt::format("{} (an .npz file holds 4 GiB). Read them from the SQLite file.", content));
    }

    /// Adds an array of signed integers or floating-point numbers. @param shape  as Python writes a tuple
    template <class Number>
    void add(std::string_view name, std::string_view shape, std::span<const Number> values) {
        const std::string type = fmt::format("<{}{}", std::is_integral_v<Number> ? 'i' : 'f', sizeof(Number));
        add_file(name, npy_header(type, "False", shape), std::as_bytes(values));
    }
    /// Adds a text without a dimension.
    void add(std::string_view name, std::string_view text) {
        add_file(name, npy_header(fmt::format("|S{}", text.size()), "False", "()"), std::as_bytes(std::span(text)));
    }

    /// Ends the file; nothing may be added any more.
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
    void add_file(std::string_view array, std::string content, std::span<const std::byte> values) {
        content.append(reinterpret_cast<const char*>(values.data()), values.size());
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

    void put(std::string_view bytes) {
        size_ += bytes.size();
        out_.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    }

    std::ostream& out_;
    std::string directory_;
    std::uint64_t size_ = 0;
    std::uint16_t files_ = 0;
};

}  // namespace

void write_sparse_npz(std::ostream& out, const Eigen::SparseMatrix<double, Eigen::RowMajor>& matrix) {
    FF_EXPECT(matrix.isCompressed());
    const auto entries = static_cast<std::size_t>(matrix.nonZeros());
    const auto rows = static_cast<std::size_t>(matrix.rows());
    const std::array shape{std::int64_t{matrix.rows()}, std::int64_t{matrix.cols()}};
    const std::string of_entries = fmt::format("({},)", entries);
    NpzFile file(out, entries * (sizeof(double) + sizeof(int)) + (rows + 1) * sizeof(int),
                 fmt::format("a matrix of {} entries", entries));
    file.add("indices", of_entries, std::span<const int>(matrix.innerIndexPtr(), entries));
    file.add("indptr", fmt::format("({},)", rows + 1), std::span<const int>(matrix.outerIndexPtr(), rows + 1));
    file.add("format", "csr");
    file.add("shape", "(2,)", std::span<const std::int64_t>(shape));
    file.add("data", of_entries, std::span<const double>(matrix.valuePtr(), entries));
    file.finish();
}

void write_randomisations(std::ostream& out, const studies::form_factors::Matrix& matrix) {
    using studies::form_factors::randomisations;
    std::vector<std::int32_t> from, to, rays_of;
    std::vector<float> values;
    for (const studies::form_factors::PairRandomisations& pair : matrix.randomisations) {
        from.push_back(static_cast<std::int32_t>(pair.from));
        to.push_back(static_cast<std::int32_t>(pair.to));
        rays_of.push_back(pair.rays_of ? static_cast<std::int32_t>(*pair.rays_of) : -1);
        values.insert(values.end(), pair.values.begin(), pair.values.end());
    }
    const std::size_t pairs = from.size();
    const std::string of_pairs = fmt::format("({},)", pairs);
    NpzFile file(out, pairs * (3 * sizeof(std::int32_t) + randomisations * sizeof(float)),
                 fmt::format("randomisations of {} pairs", pairs));
    file.add("from", of_pairs, std::span<const std::int32_t>(from));
    file.add("to", of_pairs, std::span<const std::int32_t>(to));
    file.add("rays_of", of_pairs, std::span<const std::int32_t>(rays_of));
    file.add("values", fmt::format("({}, {})", pairs, randomisations), std::span<const float>(values));
    file.finish();
}

}  // namespace ff::reports
