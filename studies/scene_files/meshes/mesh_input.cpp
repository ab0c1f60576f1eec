#include "studies/scene_files/meshes/mesh_input.hpp"

#include "core/support/error.hpp"
#include "core/support/excerpt.hpp"
#include "core/support/words.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <utility>

namespace ff::studies::meshes {
namespace {

using Kind = NumberType::Kind;

constexpr std::array number_types{
    NumberTypeNames{{Kind::integer, 1}, "char int8", "CHAR SIGNED_CHAR", "Int8"},
    NumberTypeNames{{Kind::natural, 1}, "uchar uint8", "UNSIGNED_CHAR", "UInt8"},
    NumberTypeNames{{Kind::integer, 2}, "short int16", "SHORT", "Int16"},
    NumberTypeNames{{Kind::natural, 2}, "ushort uint16", "UNSIGNED_SHORT", "UInt16"},
    NumberTypeNames{{Kind::integer, 4}, "int int32", "INT VTKIDTYPE VTKTYPEINT32", "Int32"},
    NumberTypeNames{{Kind::natural, 4}, "uint uint32", "UNSIGNED_INT VTKTYPEUINT32", "UInt32"},
    NumberTypeNames{{Kind::integer, 8}, "", "LONG LONG_LONG VTKTYPEINT64", "Int64"},
    NumberTypeNames{{Kind::natural, 8}, "", "UNSIGNED_LONG VTKTYPEUINT64", "UInt64"},
    NumberTypeNames{{Kind::real, 4}, "float float32", "FLOAT", "Float32"},
    NumberTypeNames{{Kind::real, 8}, "double float64", "DOUBLE", "Float64"},
};

constexpr std::string_view blanks_and_ends = " \t\r\n\v\f";

constexpr std::string_view ends_early = "it ends here, and more has to follow (it was cut off). Write it again.";

static_assert(std::endian::native == std::endian::little);

template <class Number>
Number number_of(const std::array<char, 8>& bytes) {
    Number value;
    std::memcpy(&value, bytes.data(), sizeof value);
    return value;
}

std::int64_t whole_of(const std::array<char, 8>& bytes, NumberType type) {
    const auto value = number_of<std::uint64_t>(bytes);
    const auto unused = static_cast<int>(64 - 8 * type.bytes);
    const auto shifted = static_cast<std::int64_t>(value << unused);
    return type.kind == Kind::natural ? static_cast<std::int64_t>(value) : shifted >> unused;
}

double real_of(const std::array<char, 8>& bytes, NumberType type) {
    if (type.kind == Kind::integer) return static_cast<double>(whole_of(bytes, type));
    if (type.kind == Kind::natural) return static_cast<double>(number_of<std::uint64_t>(bytes));
    return type.bytes == 4 ? static_cast<double>(number_of<float>(bytes)) : number_of<double>(bytes);
}

}  // namespace

std::optional<NumberType> number_type_named(std::string_view name, std::string_view NumberTypeNames::*format) {
    for (const NumberTypeNames& names : number_types) {
        const auto words = split_words(names.*format);
        if (std::find(words.begin(), words.end(), name) != words.end()) return names.type;
    }
    return std::nullopt;
}

MeshInput MeshInput::part(std::string_view name, std::string_view bytes, Encoding encoding) {
    MeshInput input(name, bytes);
    input.encoding_ = encoding;
    input.is_whole_ = false;
    return input;
}

void MeshInput::fail(std::string_view problem) const {
    std::string place = name_;
    if (is_whole_ && encoding_ == Encoding::text) {
        const std::string_view before = bytes_.substr(0, at_);
        place += fmt::format(":{}", 1 + std::count(before.begin(), before.end(), '\n'));
    } else if (is_whole_) {
        place += fmt::format(", byte {}", at_);
    }
    if (!section_.empty()) place += fmt::format(": {}", excerpt(section_));
    throw UserError("{}: {}", place, problem);
}

void MeshInput::skip_blanks() {
    at_ = std::min(bytes_.find_first_not_of(blanks_and_ends, at_), bytes_.size());
}

bool MeshInput::at_end() {
    skip_blanks();
    return at_ == bytes_.size();
}

std::string_view MeshInput::line() {
    const std::size_t end = std::min(bytes_.find('\n', at_), bytes_.size());
    const std::string_view text = bytes_.substr(at_, end - at_);
    at_ = std::min(end + 1, bytes_.size());
    return trimmed(text);
}

std::string_view MeshInput::next_word() const {
    const std::size_t begin = std::min(bytes_.find_first_not_of(blanks_and_ends, at_), bytes_.size());
    return bytes_.substr(begin, bytes_.find_first_of(blanks_and_ends, begin) - begin);
}

std::string_view MeshInput::word() {
    skip_blanks();
    const std::string_view next = next_word();
    if (next.empty()) fail(ends_early);
    at_ += next.size();
    return next;
}

template <class Number>
Number MeshInput::number_in_text(std::string_view problem) {
    skip_blanks();
    const std::string_view text = next_word();
    if (text.starts_with('$'))
        fail("{} comes before all that is announced. Correct the number, or write the file again.", excerpt(text));
    const auto value = parse_number<Number>(text);
    if (!value && !text.empty()) fail("'{}' {}", excerpt(text), problem);
    static_cast<void>(word());
    return value.value_or(0);
}

std::uint64_t MeshInput::count() {
    return number_in_text<std::uint64_t>("is no number of things. Correct it.");
}

void MeshInput::skip_past(std::string_view text) {
    const std::size_t found = bytes_.find(text, at_);
    if (found == std::string_view::npos) fail("no {} follows (it was cut off). Write it again.", text);
    at_ = found + text.size();
}

void MeshInput::skip_bytes(std::size_t count) {
    if (count > left()) fail(ends_early);
    at_ += count;
}

std::string_view MeshInput::take_bytes(std::size_t count) {
    const std::size_t begin = at_;
    skip_bytes(count);
    return bytes_.substr(begin, count);
}

std::array<char, 8> MeshInput::binary(NumberType type) {
    std::array<char, 8> bytes{};
    const std::string_view taken = take_bytes(type.bytes);
    std::copy(taken.begin(), taken.end(), bytes.begin());
    if (encoding_ == Encoding::big_endian)
        std::reverse(bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(type.bytes));
    return bytes;
}

double MeshInput::real(NumberType type) {
    if (encoding_ != Encoding::text) return real_of(binary(type), type);
    return number_in_text<double>("is not a number in double precision.");
}

double MeshInput::coordinate(NumberType type) {
    const double value = real(type);
    if (!std::isfinite(value)) fail("a coordinate is {}, which is no place. Correct it.", value);
    return value;
}

Eigen::Vector3d MeshInput::place(NumberType type) {
    const double x = coordinate(type);
    const double y = coordinate(type);
    return {x, y, coordinate(type)};
}

std::int64_t MeshInput::whole(NumberType type) {
    if (!type.is_whole()) fail("its numbers are of a type with fractions, and have to be whole.");
    if (encoding_ != Encoding::text) return whole_of(binary(type), type);
    return number_in_text<std::int64_t>("is not a whole number of up to 64 bits.");
}

void MeshInput::expect_room(std::uint64_t tuples, std::uint64_t components, std::size_t bytes) const {
    // In text, a number takes at least a digit and a blank; the last one needs no blank.
    const std::uint64_t room = encoding_ == Encoding::text ? (left() + 1) / 2 : left() / bytes;
    if (components == 0 || tuples <= room / components) return;
    fail(
        "{} numbers are announced, and the {} bytes that follow have no room for them (it was cut off, or the number "
        "is wrong). Write it again.",
        components == 1 ? fmt::format("{}", tuples) : fmt::format("{} x {}", tuples, components), left());
}

void MeshInput::expect_index(std::int64_t index, std::uint64_t points) const {
    if (index < 0 || std::cmp_greater_equal(index, points))
        fail("a polygon has point {}, of {} that count from 0. Correct the index.", index, points);
}

std::vector<double> MeshInput::reals(NumberType type, std::uint64_t tuples, std::uint64_t components) {
    expect_room(tuples, components, type.bytes);
    std::vector<double> values(tuples * components);
    for (double& value : values) value = real(type);
    return values;
}

std::vector<std::int64_t> MeshInput::wholes(NumberType type, std::uint64_t tuples, std::uint64_t components) {
    expect_room(tuples, components, type.bytes);
    std::vector<std::int64_t> values(tuples * components);
    for (std::int64_t& value : values) value = whole(type);
    return values;
}

void MeshInput::skip(NumberType type, std::uint64_t tuples, std::uint64_t components) {
    expect_room(tuples, components, type.bytes);
    if (encoding_ != Encoding::text) return skip_bytes(tuples * components * type.bytes);
    for (std::uint64_t i = 0; i < tuples * components; ++i) static_cast<void>(word());
}

}  // namespace ff::studies::meshes
