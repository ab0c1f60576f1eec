#include "reports/files/array_files.hpp"

#include "core/support/contract.hpp"
#include "core/support/error.hpp"

#include <fmt/format.h>
#include <boost/crc.hpp>

#include <array>
#include <bit>
#include <cstdint>
#include <limits>
#include <span>
#include <sstream>
#include <string_view>
#include <type_traits>
#include <vector>

namespace ff::reports {
namespace {

static_assert(std::endian::native == std::endian::little);

/// The header before the numbers of an array in NumPy's format, version 1.0. @param fortran_order, shape  as Python
/// writes them
std::string npy_header(std::string_view type, std::string_view fortran_order, std::string_view shape) {
    constexpr std::size_t before = 10;  // magic, version, length of the header
    constexpr std::size_t alignment = 64;
    std::string header =
        fmt::format("{{'descr': '{}', 'fortran_order': {}, 'shape': {}, }}", type, fortran_order, shape);
    header.append((alignment - (before + header.size() + 1) % alignment) % alignment, ' ');
    header += '\n';
    const std::array length{static_cast<char>(header.size() % 256), static_cast<char>(header.size() / 256)};
    return std::string("\x93NUMPY\x01\x00", 8).append(length.data(), length.size()) + header;
}

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
            throw UserError("{} (an .npz file holds 4 GiB). Read them from the SQLite file.", content);
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

using samplers::PointSet;

double at(const PointSet& set, std::size_t d, std::uint64_t i) {
    return set.row(0, d)[i] * 0x1p-32;
}

void write_npy_set(std::ostream& out, const PointSet& set) {
    Eigen::MatrixXd matrix(static_cast<Eigen::Index>(set.points), static_cast<Eigen::Index>(set.dimension));
    for (std::size_t d = 0; d < set.dimension; ++d) {
        for (std::uint64_t i = 0; i < set.points; ++i)
            matrix(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(d)) = at(set, d, i);
    }
    write_npy(out, matrix);
}

void write_text(std::ostream& out, const PointSet& set, std::string_view separator) {
    for (std::uint64_t i = 0; i < set.points; ++i) {
        for (std::size_t d = 0; d < set.dimension; ++d)
            out << fmt::format("{}{}", d == 0 ? "" : separator, at(set, d, i));
        out << '\n';
    }
}

void write_svg(std::ostream& out, const PointSet& set) {
    constexpr int side = 240;
    constexpr int step = side + 20;
    const auto pairs = static_cast<int>(set.dimension) - 1;
    out << fmt::format(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0}\" height=\"{0}\" viewBox=\"0 0 {0} {0}\">\n"
        "<rect width=\"100%\" height=\"100%\" fill=\"white\"/>\n",
        pairs * step + 20);
    for (int a = 0; a < pairs; ++a) {
        for (int b = a + 1; b <= pairs; ++b) {
            out << fmt::format(
                "<g transform=\"translate({} {})\"><title>coordinates {} and {}</title><rect width=\"{}\" "
                "height=\"{}\" fill=\"none\" stroke=\"gray\"/>\n",
                20 + a * step, 20 + (b - 1) * step, a, b, side, side);
            for (std::uint64_t i = 0; i < set.points; ++i) {
                out << fmt::format("<circle cx=\"{:.2f}\" cy=\"{:.2f}\" r=\"1\"/>\n",
                                   side * at(set, static_cast<std::size_t>(a), i),
                                   side * (1 - at(set, static_cast<std::size_t>(b), i)));
            }
            out << "</g>\n";
        }
    }
    out << "</svg>\n";
}

}  // namespace

void write_matrix_market(std::ostream& out, const Eigen::MatrixXd& matrix, const std::string& comment) {
    out << "%%MatrixMarket matrix array real general\n";
    if (!comment.empty()) out << fmt::format("% {}\n", comment);
    out << fmt::format("{} {}\n", matrix.rows(), matrix.cols());
    for (const double value : matrix.reshaped()) out << fmt::format("{}\n", value);
}

std::string matrix_market(const Eigen::MatrixXd& matrix, const std::string& comment) {
    std::ostringstream out;
    write_matrix_market(out, matrix, comment);
    return out.str();
}

void write_sparse_matrix_market(std::ostream& out, const Eigen::SparseMatrix<double>& matrix,
                                const std::string& comment) {
    const Eigen::Index entries = (matrix.coeffs() != 0).count();
    if (4 * entries > matrix.size()) {
        write_matrix_market(out, matrix, comment);
        return;
    }
    out << "%%MatrixMarket matrix coordinate real general\n";
    if (!comment.empty()) out << fmt::format("% {}\n", comment);
    out << fmt::format("{} {} {}\n", matrix.rows(), matrix.cols(), entries);
    for (Eigen::Index j = 0; j < matrix.cols(); ++j) {
        for (Eigen::SparseMatrix<double>::InnerIterator entry(matrix, j); entry; ++entry) {
            if (entry.value() != 0) out << fmt::format("{} {} {}\n", entry.row() + 1, j + 1, entry.value());
        }
    }
}

void write_npy(std::ostream& out, const Eigen::MatrixXd& matrix) {
    write_npy(out, matrix, matrix.cols() == 1 ? 1 : 2);
}

void write_npy(std::ostream& out, const Eigen::MatrixXd& matrix, int dimensions) {
    const std::string shape =
        dimensions == 1 ? fmt::format("({},)", matrix.rows()) : fmt::format("({}, {})", matrix.rows(), matrix.cols());
    out << npy_header("<f8", "True", shape);
    for (const double value : matrix.reshaped()) {
        const auto bytes = std::bit_cast<std::array<char, sizeof(double)>>(value);
        out.write(bytes.data(), bytes.size());
    }
}

std::string npy(const Eigen::MatrixXd& matrix) {
    std::ostringstream out;
    write_npy(out, matrix);
    return out.str();
}

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

WritePointSet point_set_format(const std::filesystem::path& file) {
    const std::string extension = file.extension().string();
    if (extension == ".npy") return write_npy_set;
    if (extension == ".csv") return [](std::ostream& out, const PointSet& set) { write_text(out, set, ","); };
    if (extension == ".dat") return [](std::ostream& out, const PointSet& set) { write_text(out, set, " "); };
    if (extension == ".svg") return write_svg;
    throw UserError("--out {} (the extension says the format). Use .npy, .csv, .dat or .svg.", file.string());
}

}  // namespace ff::reports
