#include "core/support/error.hpp"
#include "core/support/excerpt.hpp"
#include "core/support/words.hpp"
#include "samplers/point_sets/parts.hpp"
#include "studies/point_files/point_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <utility>
#include <vector>

// The format: https://github.com/QMCSoftware/LDData/blob/main/formats.md, as LatNet Builder, SSJ and QMCPy read and
// write it.

namespace ff::studies {
namespace {

constexpr std::uint64_t most_points = std::uint64_t{1} << 26;
/// The number of points taken from a longer sequence: files of 2^32 points are common.
constexpr std::uint64_t most_columns = 22;

std::uint32_t reversed_bits(std::uint64_t x) {
    std::uint32_t result = 0;
    for (int bit = 0; bit < 32; ++bit) result |= static_cast<std::uint32_t>(x >> bit & 1u) << (31 - bit);
    return result;
}

/// The numbers of the file in order; what follows # in a line is a comment.
class Numbers {
  public:
    Numbers(std::string_view text, std::string origin) : origin_(std::move(origin)) {
        for_each_line(text, [&](std::uint64_t number, std::string_view line) {
            for (const std::string_view word : split_words(line.substr(0, line.find('#')))) {
                const auto value = parse_bare_number<std::uint64_t>(word);
                if (!value)
                    throw UserError("{}:{}: \"{}\" (expected a whole number). Mark comments with #.", origin_, number,
                                    excerpt(word));
                numbers_.push_back(*value);
            }
        });
    }

    std::uint64_t next(std::string_view what) {
        if (at_ == numbers_.size())
            throw UserError(
                "{}: {} missing (the file ends before it). See docs/study-files.md for what an "
                "LDData file holds.",
                origin_, what);
        return numbers_[at_++];
    }

  private:
    std::string origin_;
    std::vector<std::uint64_t> numbers_;
    std::size_t at_ = 0;
};

void expect_range(const std::string& origin, std::string_view what, std::uint64_t value, std::uint64_t least,
                  std::uint64_t most) {
    if (value >= least && value <= most) return;
    throw UserError("{}: {} = {} ({} to {} are read). Take another file.", origin, what, value, least, most);
}

/// Point i is the fractional part of i * vector / n; where n is a power of 2, of i with its digits reversed, so that
/// the first 2^m points are the lattice of 2^m points.
samplers::PointSet lattice(Numbers numbers, const std::string& origin) {
    const std::uint64_t dimension = numbers.next("the dimension");
    expect_range(origin, "dimension", dimension, 1, 1u << 20);
    const std::uint64_t modulus = numbers.next("the number of points");
    const bool is_embedded = std::has_single_bit(modulus) && modulus > 1;
    expect_range(origin, "points", modulus, 1, is_embedded ? std::uint64_t{1} << 32 : most_points);
    const std::uint64_t n = is_embedded ? std::min(modulus, std::uint64_t{1} << most_columns) : modulus;
    samplers::PointSet result{n, std::min<std::size_t>(dimension, max_dimension), 1, {}};
    result.coordinate.resize(result.dimension * n);
    for (std::size_t d = 0; d < result.dimension; ++d) {
        const std::uint64_t factor = numbers.next(fmt::format("component {} of the generating vector", d)) % modulus;
        for (std::uint64_t i = 0; i < n; ++i)
            // Modulo 1 is modulo 2^32 here.
            result.coordinate[d * n + i] = is_embedded ? static_cast<std::uint32_t>(reversed_bits(i) * factor)
                                                       : static_cast<std::uint32_t>((i * factor % n << 32) / n);
    }
    return result;
}

/// Point i is the exclusive or of the columns of the set bits of i.
/// @param first_is_top  digit 0 of a column's number is that of the first row, as `dnetup` has it
samplers::PointSet digital_net(Numbers numbers, bool first_is_top, const std::string& origin) {
    const std::uint64_t base = numbers.next("the base");
    expect_range(origin, "base", base, 2, 2);
    const std::uint64_t dimension = numbers.next("the dimension");
    expect_range(origin, "dimension", dimension, 1, 1u << 20);
    // The format states the number of columns k here; the files of LDData themselves have 2^k.
    std::uint64_t columns = numbers.next("the number of columns");
    if (columns > 64 && std::has_single_bit(columns)) columns = static_cast<std::uint64_t>(std::countr_zero(columns));
    expect_range(origin, "columns", columns, 1, 64);
    const std::uint64_t digits = numbers.next("the number of digits");
    expect_range(origin, "digits", digits, 1, 64);
    const std::uint64_t n = std::uint64_t{1} << std::min(columns, most_columns);
    samplers::PointSet result{n, std::min<std::size_t>(dimension, max_dimension), 1, {}};
    result.coordinate.resize(result.dimension * n);
    for (std::size_t d = 0; d < result.dimension; ++d) {
        std::uint32_t* const row = &result.coordinate[d * n];
        for (std::uint64_t c = 0; c < columns; ++c) {
            const std::uint64_t column = numbers.next(fmt::format("column {} of coordinate {}", c, d));
            expect_range(origin, "a column", column, 0, ~std::uint64_t{0} >> (64 - digits));
            if (c >= most_columns) continue;
            const auto word = first_is_top  ? reversed_bits(column)
                              : digits > 32 ? static_cast<std::uint32_t>(column >> (digits - 32))
                                            : static_cast<std::uint32_t>(column << (32 - digits));
            for (std::uint64_t i = 0; i < std::uint64_t{1} << c; ++i) row[(std::uint64_t{1} << c) + i] = row[i] ^ word;
        }
    }
    return result;
}

/// How the file begins: "# lattice", "# dnet", "# dnetup".
std::string_view heading(std::string_view text) {
    return text.substr(0, text.find_first_of(" \t\r\n", 2));
}

}  // namespace

bool is_ld_data(std::string_view text) {
    const auto kind = heading(text);
    return kind == "# lattice" || kind == "# dnet" || kind == "# dnetup";
}

samplers::PointSet parse_ld_data(std::string_view text, const std::string& origin) {
    Numbers numbers(text, origin);
    const auto kind = heading(text);
    return kind == "# lattice" ? lattice(std::move(numbers), origin)
                               : digital_net(std::move(numbers), kind == "# dnetup", origin);
}

std::vector<std::uint64_t> nested_sizes(const samplers::PointSet& set) {
    std::vector<std::uint64_t> sizes;
    for (std::uint64_t n = 1; n < set.points; n *= 2) {
        bool is_spread = true;
        for (std::size_t d = 0; d < set.dimension && is_spread; ++d) {
            std::vector<bool> taken(n);
            for (const std::uint32_t x : set.row(0, d).first(n)) taken[samplers::part_of(x, n)] = true;
            is_spread = std::find(taken.begin(), taken.end(), false) == taken.end();
        }
        if (is_spread) sizes.push_back(n);
    }
    return sizes;
}

}  // namespace ff::studies
