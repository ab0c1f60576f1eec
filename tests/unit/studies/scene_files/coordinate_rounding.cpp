#include "studies/scene_files/coordinate_rounding.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <random>
#include <string>
#include <vector>

#include <fmt/format.h>

namespace ff::studies {
namespace {

/// 60 numbers of a turned scene, written in this format and read again.
std::vector<double> written(const std::string& format, double scale = 1) {
    std::mt19937_64 engine(3);
    std::uniform_real_distribution<double> uniform(0.1, 0.9);
    std::vector<double> values;
    for (int i = 0; i < 60; ++i)
        values.push_back(std::strtod(fmt::format(fmt::runtime(format), scale * uniform(engine)).c_str(), nullptr));
    return values;
}

TEST(CoordinateRounding, IsHalfAUnitOfTheLastDigit) {
    EXPECT_DOUBLE_EQ(coordinate_rounding(written("{:.6f}"), 1), 5e-7);
    EXPECT_DOUBLE_EQ(coordinate_rounding(written("{:.4f}", 1000), 1000), 5e-5);
    EXPECT_DOUBLE_EQ(coordinate_rounding(written("{:.6g}", 1e-3), 1e-3), 5e-10);
    EXPECT_DOUBLE_EQ(coordinate_rounding(written("{:.9g}", 1e5), 1e5), 5e-5);
}

TEST(CoordinateRounding, RecognisesSinglePrecision) {
    std::vector<double> values = written("{:.17g}");
    for (double& value : values) value = static_cast<double>(static_cast<float>(value));
    EXPECT_NEAR(coordinate_rounding(values, 1), 0.9 * 0x1p-24, 0.1 * 0x1p-24);
}

/// 60 single-precision numbers far from 0, written in this format and read again.
std::vector<double> written_singles(const std::string& format, float far) {
    std::vector<double> values;
    for (const double value : written("{:.17g}")) {
        const auto single = far + static_cast<float>(value);
        values.push_back(std::strtod(fmt::format(fmt::runtime(format), single).c_str(), nullptr));
    }
    return values;
}

TEST(CoordinateRounding, RecognisesSinglePrecisionWrittenInDecimals) {
    for (const std::string format : {"{:.6f}", "{:.9g}", "{}"})
        EXPECT_NEAR(coordinate_rounding(written_singles(format, 1000), 1), 1000 * 0x1p-24, 0x1p-24) << format;
    // Multiples of 1/8 are single-precision numbers, too, but were not rounded.
    std::vector<double> eighths;
    for (int i = 0; i < 60; ++i) eighths.push_back(500000 + i / 8.);
    EXPECT_EQ(coordinate_rounding(eighths, 7.5), 0);
}

// Whether doubles were written with 15 digits or with all of theirs cannot be seen.
TEST(CoordinateRounding, IsThatOfFifteenDigitsFarAway) {
    for (const std::string format : {"{:.15g}", "{:.17g}"}) {
        std::vector<double> values = written(format);
        for (double& value : values)
            value = std::strtod(fmt::format(fmt::runtime(format), 2e5 + value).c_str(), nullptr);
        EXPECT_DOUBLE_EQ(coordinate_rounding(values, 1), 5e-10) << format;
    }
}

TEST(CoordinateRounding, IsZeroForNumbersGivenExactly) {
    EXPECT_EQ(coordinate_rounding(written("{:.17g}"), 1), 0);
    EXPECT_EQ(coordinate_rounding(std::vector<double>{0.25, 1, 3.5, 500000.25, 1e-7, 4, 2.125}, 5e5), 0);
    EXPECT_EQ(coordinate_rounding(std::vector<double>{500000.01, 500000, 500004, 500010, 4}, 5e5), 0);
    EXPECT_EQ(coordinate_rounding({}, 1), 0);
}

// The digits of far coordinates say where a scene lies, not how finely its sizes were written.
TEST(CoordinateRounding, IsZeroForFewDecimalsOfAFarScene) {
    EXPECT_EQ(coordinate_rounding(std::vector<double>{10000003, 10000004, 10000005, 1e7}, 5), 0);
    EXPECT_EQ(coordinate_rounding(std::vector<double>{10000.5, 10000.7, 10000.3, 1e4}, 0.7), 0);
    EXPECT_DOUBLE_EQ(coordinate_rounding(std::vector<double>{500123.41, 500987.12, 4600045.93, 4600512.67}, 900), 5e-3);
}

TEST(CoordinateStep, IsTheLastDecimalOfNumbersThatMayBeRounded) {
    EXPECT_DOUBLE_EQ(coordinate_step(written("{:.3f}", 5), 5), 1e-3);
    EXPECT_DOUBLE_EQ(coordinate_step(written("{:.0f}", 5000), 5000), 1);
    EXPECT_EQ(coordinate_step(written("{:.6f}"), 1), 0) << "these are known to be rounded";
    EXPECT_EQ(coordinate_step(written("{:.17g}"), 1), 0);
    EXPECT_DOUBLE_EQ(coordinate_step(written("{:.4g}", 5), 5), 1e-3);
    EXPECT_EQ(coordinate_step(std::vector<double>{0.5, 2.75, 4, 3, 1.5, 0.125}, 4), 0) << "coarse";
    EXPECT_EQ(coordinate_step(std::vector<double>{1, 2, 3}, 3), 0) << "coarse";
    EXPECT_EQ(coordinate_step({}, 1), 0);
    // Two files in one: a part with three decimals, another with four.
    std::vector<double> mixed = written("{:.3f}", 5);
    for (const double value : written("{:.4f}", 4.1)) mixed.push_back(value);
    EXPECT_DOUBLE_EQ(coordinate_step(mixed, 5), 1e-3);
    // A grid of 1/64, written in full.
    std::vector<double> grid;
    for (int i = 1; i < 60; ++i) grid.push_back((7 * i % 256) / 64.);
    EXPECT_DOUBLE_EQ(coordinate_step(grid, 4), 1 / 64.);
    // Quarters of a millimetre, of which half have five decimals.
    std::vector<double> quarters = written("{:.17g}", 5);
    for (double& value : quarters) value = std::round(value / 0.00025) * 0.00025;
    quarters.push_back(6.1e-17);  // the cosine of a right angle
    EXPECT_NEAR(coordinate_step(quarters, 5), 0.00025, 1e-12);
}

TEST(CoordinateRounding, RecognisesDecimalsReadOneUlpOff) {
    std::vector<double> values = written("{:.6f}");
    for (double& value : values) value = std::nextafter(value, 1);
    EXPECT_DOUBLE_EQ(coordinate_rounding(values, 1), 5e-7);
}

}  // namespace
}  // namespace ff::studies
