#include "studies/audit/printed_number.hpp"

#include "core/support/contract.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <vector>

namespace ff::studies::audit {
namespace {

double power_of_ten(int exponent) {
    constexpr std::array<double, 13> powers{1e0, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9, 1e10, 1e11, 1e12};
    if (exponent < 0) return 1 / power_of_ten(-exponent);
    const auto index = static_cast<std::size_t>(exponent);
    return index < powers.size() ? powers[index] : std::pow(10.0, exponent);
}

/// k with 10^k <= value < 10^(k+1), numbers a hair below a power of ten belonging to it; 0 for 0.
int decade(double value) {
    return value <= 0 ? 0 : static_cast<int>(std::floor(std::log10(value) + 1e-12));
}

int decimals_of(double value, NumberFormat format) {
    return format.layout == Layout::fixed_decimals ? format.digits : format.digits - 1 - decade(value);
}

/// P(at least `successes`) of independent events.
double probability_of_at_least(std::size_t successes, const std::vector<double>& probabilities) {
    std::vector<double> count(probabilities.size() + 1, 0.0);
    count[0] = 1;
    for (const double p : probabilities) {
        for (std::size_t k = count.size() - 1; k > 0; --k) count[k] = count[k] * (1 - p) + count[k - 1] * p;
        count[0] *= 1 - p;
    }
    double sum = 0;
    for (std::size_t k = count.size(); k-- > successes;) sum += count[k];
    return std::min(1.0, sum);
}

}  // namespace

Range deviation(Range x, double reference) {
    const double below = reference - x.low;
    const double above = x.high - reference;
    const double least = std::max({0.0, x.low - reference, reference - x.high});
    return {100 * least / reference, 100 * std::max(below, above) / reference};
}

double PrintedNumber::value() const {
    return static_cast<double>(digits) / power_of_ten(decimals);
}

std::optional<PrintedNumber> parse_printed(std::string_view text) {
    PrintedNumber number;
    bool point = false;
    bool any = false;
    if (text.size() > 16) return std::nullopt;
    for (const char c : text) {
        if (c == '.' && !point) {
            point = true;
            continue;
        }
        if (c < '0' || c > '9') return std::nullopt;
        any = true;
        number.digits = 10 * number.digits + (c - '0');
        if (point) ++number.decimals;
    }
    if (!any) return std::nullopt;
    return number;
}

std::string describe(NumberFormat format) {
    return fmt::format("{} to {} {}", format.rounding == Rounding::rounded ? "rounded" : "truncated", format.digits,
                       format.layout == Layout::fixed_decimals ? "decimals" : "significant digits");
}

double printed_unit(double value, NumberFormat format) {
    return power_of_ten(-decimals_of(value, format));
}

std::optional<Range> printed_range(PrintedNumber number, NumberFormat format) {
    const double value = number.value();
    const int decimals = decimals_of(value, format);
    PrintedNumber stripped = number;
    while (stripped.decimals > decimals && stripped.digits % 10 == 0) {
        stripped.digits /= 10;
        --stripped.decimals;
    }
    if (stripped.decimals > decimals) return std::nullopt;
    const double unit = power_of_ten(-decimals);
    if (format.rounding == Rounding::truncated) return Range{value, value + unit * (1 - 1e-6)};
    // Below a power of ten significant digits are finer.
    const double below = printed_unit(value - 0.01 * unit, format);
    return Range{value - 0.5 * below, value + 0.5 * unit};
}

std::optional<Range> printed_range(std::string_view text, NumberFormat format) {
    const auto number = parse_printed(text);
    return number ? printed_range(*number, format) : std::nullopt;
}

std::string print(double value, NumberFormat format) {
    FF_EXPECT(value >= 0);
    const int decimals = std::max(0, decimals_of(value, format));
    const double scaled = value * power_of_ten(decimals);
    // The hair keeps numbers such as 0.29 = 28.999... / 100 from losing a digit.
    const double whole = format.rounding == Rounding::rounded ? std::round(scaled) : std::floor(scaled + 1e-7);
    return fmt::format("{:.{}f}", whole / power_of_ten(decimals), decimals);
}

int misprint_distance(std::string_view printed, std::string_view meant) {
    // Optimal string alignment: Levenshtein's distance with swaps of neighbours.
    const std::size_t columns = meant.size() + 1;
    std::vector<int> table((printed.size() + 1) * columns);
    const auto at = [&](std::size_t i, std::size_t j) -> int& { return table[i * columns + j]; };
    for (std::size_t i = 0; i <= printed.size(); ++i) at(i, 0) = static_cast<int>(i);
    for (std::size_t j = 0; j <= meant.size(); ++j) at(0, j) = static_cast<int>(j);
    for (std::size_t i = 1; i <= printed.size(); ++i) {
        for (std::size_t j = 1; j <= meant.size(); ++j) {
            const int replaced = at(i - 1, j - 1) + (printed[i - 1] == meant[j - 1] ? 0 : 1);
            at(i, j) = std::min({replaced, at(i - 1, j) + 1, at(i, j - 1) + 1});
            if (i > 1 && j > 1 && printed[i - 1] == meant[j - 2] && printed[i - 2] == meant[j - 1]) {
                at(i, j) = std::min(at(i, j), at(i - 2, j - 2) + 1);
            }
        }
    }
    return at(printed.size(), meant.size());
}

std::optional<HitRange> possible_hits(Range values, std::uint64_t rays) {
    FF_EXPECT(rays >= 1);
    constexpr double slack = 1e-6;  // share of a hit: far above rounding, far below a printed digit
    const double n = static_cast<double>(rays);
    const HitRange hits{static_cast<std::int64_t>(std::ceil(values.low * n - slack)),
                        static_cast<std::int64_t>(std::floor(values.high * n + slack))};
    if (hits.low > hits.high) return std::nullopt;
    return hits;
}

FormatEvidence weigh_format(std::span<const SampledFigure> figures, NumberFormat format) {
    FormatEvidence evidence{.format = format};
    std::vector<double> chances;
    for (const SampledFigure& figure : figures) {
        const double rays = static_cast<double>(figure.rays);
        const auto range = printed_range(figure.number, format);
        const auto hits = range ? possible_hits(*range, figure.rays) : std::nullopt;
        // A print is as likely as the number of hit counts that give it, or a misprint: any string of its length. Zeros
        // behind the last digit of the format were appended, which makes it no likelier.
        const double distinct = std::max(1.0, rays * std::pow(10.0, -figure.number.decimals));
        const double explained = hits ? std::min(static_cast<double>(hits->count()), distinct) : 0.0;
        const double any = rays * std::pow(10.0, -std::max(figure.number.decimals, format.digits));
        evidence.log_likelihood += std::log((1 - misprint_share) * explained + misprint_share * any);
        const double chance = rays * printed_unit(figure.number.value(), format);
        if (chance >= 1) continue;
        ++evidence.figures;
        if (hits) ++evidence.whole;
        chances.push_back(range ? chance : 0.0);
        evidence.expected += chances.back();
    }
    evidence.chance = probability_of_at_least(evidence.whole, chances);
    return evidence;
}

std::vector<FormatEvidence> weigh_formats(std::span<const SampledFigure> figures, int digits) {
    std::vector<FormatEvidence> all;
    for (const Layout layout : {Layout::fixed_decimals, Layout::significant_digits}) {
        for (const Rounding rounding : {Rounding::rounded, Rounding::truncated}) {
            all.push_back(weigh_format(figures, {rounding, layout, digits}));
        }
    }
    std::ranges::stable_sort(all, std::ranges::greater{}, &FormatEvidence::log_likelihood);
    return all;
}

}  // namespace ff::studies::audit
