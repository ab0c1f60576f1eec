#include "reports/files/point_set_files.hpp"

#include "core/support/error.hpp"
#include "reports/files/matrix_files.hpp"

#include <fmt/format.h>

#include <string_view>

namespace ff::reports {
namespace {

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

WritePointSet point_set_format(const std::filesystem::path& file) {
    const std::string extension = file.extension().string();
    if (extension == ".npy") return write_npy_set;
    if (extension == ".csv") return [](std::ostream& out, const PointSet& set) { write_text(out, set, ","); };
    if (extension == ".dat") return [](std::ostream& out, const PointSet& set) { write_text(out, set, " "); };
    if (extension == ".svg") return write_svg;
    throw UserError(
        fmt::format("--out {} (the extension says the format). Use .npy, .csv, .dat or .svg.", file.string()));
}

}  // namespace ff::reports
