#include "studies/audit/hit_counts.hpp"

#include "core/support/contract.hpp"

#include <algorithm>
#include <cmath>

namespace ff::studies::audit {
namespace {

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

std::optional<HitRange> possible_hits(Range values, std::uint64_t rays) {
    FF_EXPECT(rays >= 1);
    constexpr double slack = 1e-6;  // of a hit; far above rounding, far below what a printed digit can tell
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
    std::stable_sort(all.begin(), all.end(), [](const FormatEvidence& a, const FormatEvidence& b) {
        return a.log_likelihood > b.log_likelihood;
    });
    return all;
}

}  // namespace ff::studies::audit
