#include "studies/point_files/point_file.hpp"

#include "core/support/error.hpp"
#include "core/support/excerpt.hpp"
#include "core/support/words.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace ff::studies {
namespace {

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
            throw UserError(
                fmt::format("{}: \"{}\" (not a number). Write a point a line, numbers separated by spaces or commas.",
                            place, excerpt(word)));
        rows.values.push_back(*value);
    }
    const std::size_t width = words.size();
    if (width == 0) return;
    if (rows.width == 0) rows.width = width;
    if (width != rows.width)
        throw UserError(fmt::format("{}: {} numbers (the points before have {}). Give every point as many.", place,
                                    width, rows.width));
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
            throw UserError(fmt::format("{}: set {} has {} points (set 0 has {}). Give every set as many.", origin, set,
                                        rows.ends[set] - rows.ends[set - 1], points));
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

std::uint32_t fixed_point(double x, const std::string& origin, std::uint64_t set, std::uint64_t point, std::size_t d) {
    if (x >= 0 && x < 1) return static_cast<std::uint32_t>(x * 0x1p32);
    throw UserError(fmt::format("{}: set {}, point {}, coordinate {} is {} (counted from 0; not in [0, 1)). {}", origin,
                                set, point, d, x,
                                x == 1 ? "Leave out the upper end." : "Check the program that made the points."));
}

void expect_size(const std::string& origin, std::uint64_t sets, std::uint64_t points, std::uint64_t dimension) {
    if (sets == 0 || points == 0 || dimension == 0)
        throw UserError(
            fmt::format("{}: no points (a set has at least one). Give an array (n, d) or (trials, n, d).", origin));
    if (points > samplers::max_points || sets > (std::uint64_t{1} << 32) / points * 16)
        throw UserError(fmt::format("{}: {} sets of {} points (too many). Split the file.", origin, sets, points));
}

samplers::PointSet parse_points(std::string_view bytes, const std::string& origin) {
    if (is_npy(bytes)) return parse_npy(bytes, origin);
    if (is_raw(bytes)) return parse_raw(bytes, origin);
    if (is_ld_data(bytes)) return parse_ld_data(bytes, origin);
    return parse_text(bytes, origin);
}

}  // namespace ff::studies
