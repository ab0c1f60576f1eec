#include "core/support/error.hpp"
#include "studies/point_files/bytes.hpp"
#include "studies/point_files/point_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>

namespace ff::studies {
namespace {

constexpr std::string_view raw_magic = "FFPOINTS";
constexpr std::size_t raw_header = 24;

}  // namespace

bool is_raw(std::string_view bytes) {
    return bytes.starts_with(raw_magic);
}

std::uint64_t raw_size(std::string_view beginning) {
    const std::string_view known = beginning.substr(0, raw_magic.size());
    if (known != raw_magic.substr(0, known.size())) return beginning.size();
    if (beginning.size() < raw_header) return raw_header;
    const auto points = number_at<std::uint64_t>(beginning, 8);
    const auto width = number_at<std::uint64_t>(beginning, 16);
    constexpr std::uint64_t most = std::uint64_t{1} << 56;
    if (width == 0 || points > most / width) return raw_header;  // wrong, as the parser will say
    return raw_header + points * width * sizeof(double);
}

samplers::PointSet parse_raw(std::string_view bytes, const std::string& origin) {
    if (bytes.size() < raw_header)
        throw UserError(fmt::format("{}: its header is cut off (24 bytes: FFPOINTS, n, d). Write it again.", origin));
    const auto points = number_at<std::uint64_t>(bytes, 8);
    const auto width = number_at<std::uint64_t>(bytes, 16);
    expect_size(origin, 1, points, width);
    const std::uint64_t there = (bytes.size() - raw_header) / sizeof(double);
    if (width > there || points > there / width || points * width != there ||
        (bytes.size() - raw_header) % sizeof(double) != 0)
        throw UserError(fmt::format("{}: {} bytes of numbers (its header says {} x {} of 8 bytes). Write them all.",
                                    origin, bytes.size() - raw_header, points, width));
    samplers::PointSet result{points, std::min<std::size_t>(width, max_dimension), 1, {}};
    result.coordinate.resize(result.dimension * points);
    for (std::uint64_t i = 0; i < points; ++i) {
        for (std::size_t d = 0; d < result.dimension; ++d)
            result.coordinate[d * points + i] =
                fixed_point(number_at<double>(bytes, raw_header + (i * width + d) * sizeof(double)), origin, 0, i, d);
    }
    return result;
}

}  // namespace ff::studies
