#include "studies/verdicts/band_reader.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace ff::studies::gates {

void expect_magnitude(const TomlReader& reader, std::string_view key, double number) {
    const double size = std::abs(number);
    if (size == 0 || (smallest_magnitude <= size && size <= largest_magnitude)) return;
    reader.fail(key, "(beyond 1e75, or nearer to 0 than 1e-75: its powers cannot be computed). Choose another unit.");
}

namespace {

/// Two ends in order.
Band read_ends(const TomlReader& reader, const std::vector<double>& ends) {
    if (ends.size() != 2) reader.fail("band", "(one width, or two ends). Write 0.1 or [0.9, 1.1].");
    if (ends[0] == ends[1])
        reader.fail("band",
                    "(a band of zero width: no number of trials shows exactly this value). Move the ends apart.");
    if (ends[0] > ends[1]) reader.fail("band", "(the lower end comes first). Exchange them.");
    return {ends[0], ends[1]};
}

double read_width(const TomlReader& reader, const std::vector<double>& numbers, std::string_view suggestion) {
    if (numbers.size() != 1) reader.fail("band", fmt::format("(expected one number, not a list). Try {}.", suggestion));
    if (numbers[0] == 0)
        reader.fail("band",
                    fmt::format("(a band of zero width: no number of trials shows an effect of exactly nothing). "
                                "Try {}.",
                                suggestion));
    if (numbers[0] < 0) reader.fail("band", fmt::format("(a width is positive). Try {}.", suggestion));
    return numbers[0];
}

/// Refuses a band that is too narrow. @param width  from a ratio of 1, or from the level of a share, to an end of the
/// band
void expect_room(const TomlReader& reader, double width) {
    constexpr double least = 1e-12;
    if (width < least) reader.fail("band", "(narrower than 1e-12: a ratio is not computed to more digits). Try 0.1.");
}

Band read_ratio(const TomlReader& reader, const std::vector<double>& numbers, bool upwards_only) {
    if (numbers.size() == 1) {
        const double width = read_width(reader, numbers, "0.1");
        expect_room(reader, width);
        return {1 / (1 + width), upwards_only ? std::numeric_limits<double>::infinity() : 1 + width};
    }
    const Band band = read_ends(reader, numbers);
    if (band.low < 0 || band.low >= 1 || band.high <= 1)
        reader.fail("band", "(a ratio of 1, no change, has to lie inside). Try [0.9, 1.1].");
    expect_room(reader, std::min(1 - band.low, band.high - 1));
    return band;
}

}  // namespace

Band read_band(const TomlReader& reader, const Gate& gate) {
    if (!reader.has("band")) reader.fail("band", "missing (what is tolerated?). Add the key with a number.");
    const auto numbers = reader.numbers("band");
    for (const double number : numbers) expect_magnitude(reader, "band", number);
    switch (gate.kind) {
        case GateKind::bias:
        case GateKind::closure:
        case GateKind::reciprocity:
        case GateKind::equal: {
            const double width = read_width(reader, numbers, "1e-4");
            return {-width, width};
        }
        case GateKind::std:
        case GateKind::rmse:
        case GateKind::std_error:
            return read_ratio(reader, numbers, false);
        case GateKind::efficiency:
            return read_ratio(reader, numbers, true);
        case GateKind::distribution: {
            const double width = read_width(reader, numbers, "0.05");
            if (width >= 1)
                reader.fail("band",
                            "(expected below 1, from which on any distribution of values would pass). Try 0.05.");
            return {0, width};
        }
        case GateKind::lost_rays:
            if (numbers.size() != 1 || numbers[0] < 0 || numbers[0] >= 1)
                reader.fail("band", "(the largest share of lost rays that is tolerated). Try 0.");
            return {0, numbers[0]};
        case GateKind::coverage: {
            if (numbers.size() == 2) {
                const Band band = read_ends(reader, numbers);
                if (!band.holds(gate.interval_level))
                    reader.fail("band", "(the level of the interval has to lie inside). Try 0.02, around the level.");
                return band;
            }
            const double width = read_width(reader, numbers, "0.02");
            expect_room(reader, width);
            return {gate.interval_level - width, std::min(1.0, gate.interval_level + width)};
        }
        case GateKind::slope:
            break;
    }
    const auto expected = reader.optional_number("expected");
    if (numbers.size() == 2) {
        if (expected) reader.fail("expected", "(the band has two ends of its own). Remove the key.");
        return read_ends(reader, numbers);
    }
    const double width = read_width(reader, numbers, "0.05");
    if (!expected) reader.fail("expected", "missing (the slope that the band lies around). Try -0.5.");
    const Band band{*expected - width, *expected + width};
    if (!(band.low < *expected && *expected < band.high))
        reader.fail("expected", "(so large a number beside the band that rounding closes it). Try -0.5.");
    return band;
}

}  // namespace ff::studies::gates
