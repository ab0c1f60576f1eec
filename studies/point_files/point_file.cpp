#include "studies/point_files/point_file.hpp"

#include "core/support/error.hpp"
#include "core/support/excerpt.hpp"
#include "core/support/words.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <cstring>
#include <vector>

namespace ff::studies {
namespace {

/// x * 2^32. @throws UserError unless 0 <= x < 1, with the place counted from 0
std::uint32_t fixed_point(double x, const std::string& origin, std::uint64_t set, std::uint64_t point, std::size_t d) {
    if (x >= 0 && x < 1) return static_cast<std::uint32_t>(x * 0x1p32);
    throw UserError("{}: set {}, point {}, coordinate {} is {} (counted from 0; not in [0, 1)). {}", origin, set, point,
                    d, x, x == 1 ? "Leave out the upper end." : "Check the program that made the points.");
}

/// @throws UserError for a size that no set has
void expect_size(const std::string& origin, std::uint64_t sets, std::uint64_t points, std::uint64_t dimension) {
    if (sets == 0 || points == 0 || dimension == 0)
        throw UserError("{}: no points (a set has at least one). Give an array (n, d) or (trials, n, d).", origin);
    if (points > samplers::max_points || sets > (std::uint64_t{1} << 32) / points * 16)
        throw UserError("{}: {} sets of {} points (too many). Split the file.", origin, sets, points);
}

/// The little-endian number that stands at a place. @pre all its bytes are there
template <class Number>
Number number_at(std::string_view bytes, std::size_t at) {
    static_assert(std::endian::native == std::endian::little);
    Number value;
    std::memcpy(&value, bytes.data() + at, sizeof value);
    return value;
}

constexpr std::string_view npy_magic = "\x93NUMPY";
constexpr std::string_view raw_magic = "FFPOINTS";
constexpr std::size_t raw_header = 24;

struct NpyHeader {
    std::string_view type;
    bool by_columns = false;
    std::vector<std::uint64_t> shape;
    std::size_t data = 0;  ///< where the numbers begin
};

[[noreturn]] void refuse(const std::string& origin, std::string_view what, std::string_view why) {
    throw UserError("{}: {} ({}). Write it with numpy.save.", origin, what, why);
}

/// The text between `before` and `after` in the header.
std::string_view between(std::string_view text, std::string_view before, std::string_view after,
                         const std::string& origin) {
    const std::size_t begin = text.find(before);
    const std::size_t end = begin == std::string_view::npos ? begin : text.find(after, begin + before.size());
    if (end == std::string_view::npos) refuse(origin, "its header is damaged", fmt::format("no {}", before));
    return text.substr(begin + before.size(), end - begin - before.size());
}

NpyHeader parse_header(std::string_view bytes, const std::string& origin) {
    const auto byte = [&](std::size_t at) -> std::size_t { return static_cast<unsigned char>(bytes[at]); };
    if (bytes.size() < 12) refuse(origin, "its header is cut off", "12 bytes at least");
    const std::size_t begin = byte(6) == 1 ? 10 : 12;
    std::size_t length = byte(8) | byte(9) << 8;
    if (begin == 12) length |= byte(10) << 16 | byte(11) << 24;
    if (bytes.size() - begin < length) refuse(origin, "its header is cut off", "the file is shorter");
    const std::string_view text = bytes.substr(begin, length);
    NpyHeader header;
    header.data = begin + length;
    header.type = between(text, "'descr': '", "'", origin);
    header.by_columns = between(text, "'fortran_order': ", ",", origin) == "True";
    std::string_view shape = between(text, "'shape': (", ")", origin);
    while (!shape.empty()) {
        std::uint64_t size = 0;
        const auto [rest, error] = std::from_chars(shape.data(), shape.data() + shape.size(), size);
        if (error != std::errc()) refuse(origin, "its shape is damaged", excerpt(shape));
        header.shape.push_back(size);
        shape.remove_prefix(static_cast<std::size_t>(rest - shape.data()));
        shape.remove_prefix(std::min(shape.find_first_not_of(", "), shape.size()));
    }
    return header;
}

/// The format: https://numpy.org/doc/stable/reference/generated/numpy.lib.format.html
samplers::PointSet parse_npy(std::string_view bytes, const std::string& origin) {
    const NpyHeader header = parse_header(bytes, origin);
    constexpr std::array<std::string_view, 3> types{"<f8", "<f4", "<u4"};
    if (std::find(types.begin(), types.end(), header.type) == types.end())
        refuse(origin, fmt::format("numbers of type '{}'", excerpt(header.type)),
               "float64, float32 or uint32 are read");
    if (header.shape.size() != 2 && header.shape.size() != 3)
        refuse(origin, fmt::format("shape ({})", fmt::join(header.shape, ", ")), "(n, d) or (trials, n, d) are read");
    const std::uint64_t width = header.shape.back();
    const std::uint64_t points = header.shape[header.shape.size() - 2];
    const std::uint64_t sets = header.shape.size() == 3 ? header.shape[0] : 1;
    expect_size(origin, sets, points, width);
    const std::size_t bytes_each = header.type == "<f8" ? 8 : 4;
    const std::uint64_t there = (bytes.size() - header.data) / bytes_each;
    if (width > there || points > there / width || sets > there / width / points || sets * points * width != there) {
        throw UserError(
            "{}: {} numbers (its header says {} x {} x {}). It was cut off or is still being written; "
            "write it again.",
            origin, there, sets, points, width);
    }
    samplers::PointSet result{points, std::min<std::size_t>(width, max_dimension), sets, {}};
    result.coordinate.resize(sets * result.dimension * points);
    for (std::uint64_t set = 0; set < sets; ++set) {
        for (std::size_t d = 0; d < result.dimension; ++d) {
            std::uint32_t* const row = &result.coordinate[(set * result.dimension + d) * points];
            for (std::uint64_t i = 0; i < points; ++i) {
                const std::uint64_t index =
                    header.by_columns ? (d * points + i) * sets + set : (set * points + i) * width + d;
                const std::size_t at = header.data + index * bytes_each;
                if (header.type == "<u4") {
                    row[i] = number_at<std::uint32_t>(bytes, at);
                } else {
                    const double x = bytes_each == 8 ? number_at<double>(bytes, at)
                                                     : static_cast<double>(number_at<float>(bytes, at));
                    row[i] = fixed_point(x, origin, set, i, d);
                }
            }
        }
    }
    return result;
}

samplers::PointSet parse_raw(std::string_view bytes, const std::string& origin) {
    if (bytes.size() < raw_header)
        throw UserError("{}: its header is cut off (24 bytes: FFPOINTS, n, d). Write it again.", origin);
    const auto points = number_at<std::uint64_t>(bytes, 8);
    const auto width = number_at<std::uint64_t>(bytes, 16);
    expect_size(origin, 1, points, width);
    const std::uint64_t there = (bytes.size() - raw_header) / sizeof(double);
    if (width > there || points > there / width || points * width != there ||
        (bytes.size() - raw_header) % sizeof(double) != 0)
        throw UserError("{}: {} bytes of numbers (its header says {} x {} of 8 bytes). Write them all.", origin,
                        bytes.size() - raw_header, points, width);
    samplers::PointSet result{points, std::min<std::size_t>(width, max_dimension), 1, {}};
    result.coordinate.resize(result.dimension * points);
    for (std::uint64_t i = 0; i < points; ++i) {
        for (std::size_t d = 0; d < result.dimension; ++d)
            result.coordinate[d * points + i] =
                fixed_point(number_at<double>(bytes, raw_header + (i * width + d) * sizeof(double)), origin, 0, i, d);
    }
    return result;
}

/// Rows of text, and where each set ends.
struct TextRows {
    std::vector<double> values;
    std::size_t width = 0;
    std::vector<std::uint64_t> ends;  ///< ends of sets, counted in rows
    std::uint64_t rows = 0;
};

void end_set(TextRows& rows) {
    if (rows.rows != (rows.ends.empty() ? 0 : rows.ends.back())) rows.ends.push_back(rows.rows);
}

void read_row(std::string_view line, TextRows& rows, const std::string& place) {
    const auto words = split_words(line, " \t,;\r");
    for (const std::string_view word : words) {
        const auto value = parse_bare_number<double>(word);
        if (!value)
            throw UserError("{}: \"{}\" (not a number). Write a point a line, numbers separated by spaces or commas.",
                            place, excerpt(word));
        rows.values.push_back(*value);
    }
    const std::size_t width = words.size();
    if (width == 0) return;
    if (rows.width == 0) rows.width = width;
    if (width != rows.width)
        throw UserError("{}: {} numbers (the points before have {}). Give every point as many.", place, width,
                        rows.width);
    ++rows.rows;
}

samplers::PointSet parse_text(std::string_view text, const std::string& origin) {
    TextRows rows;
    for_each_line(text, [&](std::uint64_t number, std::string_view line) {
        if (line.starts_with('#')) {
            end_set(rows);
        } else {
            read_row(line, rows, fmt::format("{}:{}", origin, number));
        }
    });
    end_set(rows);
    const std::uint64_t sets = rows.ends.size();
    const std::uint64_t points = sets == 0 ? 0 : rows.ends.front();
    expect_size(origin, sets, points, rows.width);
    for (std::uint64_t set = 1; set < sets; ++set) {
        if (rows.ends[set] - rows.ends[set - 1] != points)
            throw UserError("{}: set {} has {} points (set 0 has {}). Give every set as many.", origin, set,
                            rows.ends[set] - rows.ends[set - 1], points);
    }
    samplers::PointSet result{points, std::min(rows.width, max_dimension), sets, {}};
    result.coordinate.resize(sets * result.dimension * points);
    for (std::uint64_t i = 0; i < rows.rows; ++i) {
        for (std::size_t d = 0; d < result.dimension; ++d) {
            result.coordinate[(i / points * result.dimension + d) * points + i % points] =
                fixed_point(rows.values[i * rows.width + d], origin, i / points, i % points, d);
        }
    }
    return result;
}

}  // namespace

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

samplers::PointSet parse_points(std::string_view bytes, const std::string& origin) {
    if (bytes.starts_with(npy_magic)) return parse_npy(bytes, origin);
    if (bytes.starts_with(raw_magic)) return parse_raw(bytes, origin);
    if (is_ld_data(bytes)) return parse_ld_data(bytes, origin);
    return parse_text(bytes, origin);
}

}  // namespace ff::studies
