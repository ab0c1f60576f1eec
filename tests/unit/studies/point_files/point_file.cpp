#include "studies/point_files/point_file.hpp"

#include "core/support/error.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

namespace ff::studies {
namespace {

template <class Number>
std::string npy(const std::string& type, const std::string& shape, const std::vector<Number>& numbers,
                const std::string& by_columns = "False") {
    std::string header = "{'descr': '" + type + "', 'fortran_order': " + by_columns + ", 'shape': (" + shape + "), }";
    header.resize(118, ' ');
    std::string bytes = std::string("\x93NUMPY\x01\x00", 8) + std::string("\x76\x00", 2) + header;
    const auto begin = reinterpret_cast<const char*>(numbers.data());
    return bytes.append(begin, begin + numbers.size() * sizeof(Number));
}

constexpr std::uint32_t quarter = 1u << 30;

TEST(PointFile, ReadsArraysOfEveryType) {
    for (const std::string& bytes :
         {npy<double>("<f8", "2, 2", {0.25, 0.5, 0, 0.75}), npy<float>("<f4", "2, 2", {0.25F, 0.5F, 0, 0.75F}),
          npy<std::uint32_t>("<u4", "2, 2", {quarter, 2 * quarter, 0, 3 * quarter}),
          npy<double>("<f8", "2, 2", {0.25, 0, 0.5, 0.75}, "True")}) {
        const auto set = parse_points(bytes, "points.npy");
        EXPECT_EQ(set.points, 2u);
        EXPECT_EQ(set.dimension, 2u);
        EXPECT_EQ(set.sets, 1u);
        EXPECT_EQ(set.coordinate, (std::vector<std::uint32_t>{quarter, 0, 2 * quarter, 3 * quarter}));
    }
}

TEST(PointFile, ReadsArraysOfSeveralTrialsAndIgnoresCoordinatesBeyondFour) {
    std::vector<double> numbers(2 * 3 * 6);
    for (std::size_t i = 0; i < numbers.size(); ++i) numbers[i] = static_cast<double>(i) / 64;
    const auto set = parse_points(npy<double>("<f8", "2, 3, 6", numbers), "points.npy");
    EXPECT_EQ(set.dimension, 4u);
    EXPECT_EQ(set.sets, 2u);
    EXPECT_EQ(set.row(1, 3)[2], (1u * 18 + 2 * 6 + 3) << 26);
}

TEST(PointFile, RefusesDamagedArrays) {
    const std::string whole = npy<double>("<f8", "2, 2", {0.25, 0.5, 0, 0.75});
    for (std::size_t length = 1; length < whole.size(); ++length)
        EXPECT_THROW(parse_points(whole.substr(0, length), "points.npy"), UserError) << length;
    EXPECT_THROW(parse_points(whole + "12345678", "points.npy"), UserError);
    EXPECT_THROW(parse_points(npy<double>("<f8", "4", {0, 0, 0, 0}), "points.npy"), UserError);
    EXPECT_THROW(parse_points(npy<double>("<i8", "2, 2", {0, 0, 0, 0}), "points.npy"), UserError);
    EXPECT_THROW(parse_points(npy<double>("<f8", "0, 2", {}), "points.npy"), UserError);
    EXPECT_THROW(parse_points(npy<double>("<f8", "4294967296, 4294967296", {0}), "points.npy"), UserError);
    EXPECT_THROW(parse_points(npy<double>("<f8", "2, 2, 4611686018427387905", {0, 0, 0, 0}), "points.npy"), UserError);
}

TEST(PointFile, ReadsRawNumbersAndRefusesDamagedOnes) {
    const std::vector<std::uint64_t> sizes{2, 2};
    const std::vector<double> numbers{0.25, 0.5, 0, 0.75};
    std::string bytes = "FFPOINTS";
    bytes.append(reinterpret_cast<const char*>(sizes.data()), 16);
    bytes.append(reinterpret_cast<const char*>(numbers.data()), 32);
    EXPECT_EQ(parse_points(bytes, "points.bin").coordinate,
              (std::vector<std::uint32_t>{quarter, 0, 2 * quarter, 3 * quarter}));
    for (std::size_t length = 1; length < bytes.size(); ++length)
        EXPECT_THROW(parse_points(bytes.substr(0, length), "points.bin"), UserError) << length;
    EXPECT_THROW(parse_points(bytes + "12345678", "points.bin"), UserError);
    bytes.replace(16, 8, std::string(8, '\xff'));
    EXPECT_THROW(parse_points(bytes, "points.bin"), UserError);
}

TEST(PointFile, ReadsTextWithSetsBetweenMarks) {
    const auto set = parse_points("# made by hand\n0.25 0.5\n\n0,0.75\r\n#\n0.5;0\n0.5\t0\n", "points.txt");
    EXPECT_EQ(set.sets, 2u);
    EXPECT_EQ(set.coordinate,
              (std::vector<std::uint32_t>{quarter, 0, 2 * quarter, 3 * quarter, 2 * quarter, 2 * quarter, 0, 0}));
}

// Point i of a lattice of 9 points with the vector (1, 4): (i / 9, 4 i / 9 mod 1).
TEST(PointFile, MakesLattices) {
    const auto set = parse_points("# lattice\n2 # dimension\n9\n1\n4\n", "lattice.txt");
    for (std::uint64_t i = 0; i < 9; ++i) {
        EXPECT_EQ(set.row(0, 0)[i], (i << 32) / 9);
        EXPECT_EQ(set.row(0, 1)[i], (4 * i % 9 << 32) / 9);
    }
}

// The first 2^m points of a lattice with the vector (1, 3) are the lattice of 2^m points with that vector.
TEST(PointFile, OrdersLatticesInBaseTwoAsSequences) {
    for (const char* const modulus : {"8", "4294967296"}) {
        const auto set = parse_points(fmt::format("# lattice\n2\n{}\n1\n3\n", modulus), "lattice.txt");
        EXPECT_EQ(set.points, std::min(std::stoull(modulus), 1ull << 22));
        EXPECT_EQ(set.row(0, 0)[1], 1u << 31);
        for (const std::uint32_t n : {2u, 4u, 8u}) {
            std::vector<bool> taken(n);
            for (std::uint32_t i = 0; i < n; ++i) {
                const std::uint64_t multiple = std::uint64_t{set.row(0, 0)[i]} * n >> 32;
                EXPECT_EQ(set.row(0, 0)[i], (multiple << 32) / n);
                EXPECT_EQ(set.row(0, 1)[i], (3 * multiple % n << 32) / n);
                taken[multiple] = true;
            }
            EXPECT_EQ(std::count(taken.begin(), taken.end(), true), n);
        }
    }
}

// Unit matrices: van der Corput's sequence; anti-diagonal ones: i / n.
TEST(PointFile, MakesDigitalNetsWithAnyNumberOfDigits) {
    for (const char* const text : {"# dnet\n2\n2\n3\n3\n4 2 1\n1 2 4\n",
                                   "# dnet\n2\n2\n3\n40\n549755813888 274877906944 137438953472\n137438953472 "
                                   "274877906944 549755813888\n"}) {
        const auto set = parse_points(text, "net.txt");
        EXPECT_EQ(set.points, 8u);
        EXPECT_EQ(set.row(0, 0)[1], 1u << 31);
        EXPECT_EQ(set.row(0, 0)[6], 3u << 29);
        for (std::uint32_t i = 0; i < 8; ++i) EXPECT_EQ(set.row(0, 1)[i], i << 29);
    }
}

// The files of LDData name the number of points where the format has that of columns; dnetup has the first row's digit
// lowest. One net in three ways.
TEST(PointFile, ReadsDigitalNetsAsLDDataHasThem) {
    const auto net = parse_points("# dnet\n2\n2\n7\n8\n128 64 32 16 8 4 2\n2 4 8 16 32 64 128\n", "net.txt");
    EXPECT_EQ(net.points, 128u);
    EXPECT_EQ(net.row(0, 0)[1], 1u << 31);
    for (const char* const text : {"# dnet\n2\n2\n128\n8\n128 64 32 16 8 4 2\n2 4 8 16 32 64 128\n",
                                   "# dnetup\n2\n2\n128\n8\n1 2 4 8 16 32 64\n64 32 16 8 4 2 1\n"})
        EXPECT_EQ(parse_points(text, "net.txt").coordinate, net.coordinate);
}

TEST(PointFile, TruncatesLongDigitalSequences) {
    std::string text = "# dnetup\n2\n1\n4294967296\n64\n";
    for (int c = 0; c < 32; ++c) text += fmt::format("{} ", (std::uint64_t{1} << 63) + (std::uint64_t{1} << c));
    const auto net = parse_points(text, "sequence.txt");
    EXPECT_EQ(net.points, 1u << 22);
    EXPECT_EQ(net.row(0, 0)[1], 1u << 31);
    EXPECT_EQ(net.row(0, 0)[6], 3u << 29);
}

// The first points of van der Corput's sequence form a set of their own for every power of 2; those of i / n only for
// one point.
TEST(PointFile, FindsTheNestedSizesOfASet) {
    const auto sequence = parse_points("# dnetup\n2\n1\n3\n3\n1 2 4\n", "sequence.txt");
    EXPECT_EQ(nested_sizes(sequence), (std::vector<std::uint64_t>{1, 2, 4}));
    const auto net = parse_points("# dnetup\n2\n2\n3\n3\n1 2 4\n4 2 1\n", "net.txt");
    EXPECT_EQ(nested_sizes(net), (std::vector<std::uint64_t>{1}));
}

}  // namespace
}  // namespace ff::studies
