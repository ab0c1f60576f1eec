#include "studies/verdicts/needed_trials.hpp"

#include "core/support/contract.hpp"
#include "stats/basics/distributions.hpp"
#include "stats/basics/moments.hpp"
#include "stats/error_rates/power.hpp"
#include "stats/gates/skewed_reach.hpp"

#include <algorithm>
#include <cmath>

namespace ff::studies::gates {
namespace {

/// Below, normal approximations and a kurtosis mean little, and the far quantiles of t are very far.
constexpr std::uint64_t fewest_trials = 32;

/// Nobody runs more trials than this.
constexpr double most_trials = 1e15;

std::optional<std::uint64_t> whole(double trials) {
    if (!(trials <= most_trials)) return std::nullopt;
    return std::max(fewest_trials, static_cast<std::uint64_t>(std::ceil(trials)));
}

/// Chance that one comparison may miss at each end of its band.
double miss(const Levels& levels, std::size_t comparisons) {
    FF_EXPECT(comparisons >= 1);
    return (1 - levels.power) / static_cast<double>(2 * comparisons);
}

/// Standard errors that have to fit between the middle and an end of the band.
double reach_to_pass(const Levels& levels, std::size_t comparisons) {
    return stats::normal_critical(levels.pass_alpha) + stats::normal_critical(miss(levels, comparisons));
}

/// The part of the half width of a band that the reference leaves; empty where nothing is left.
std::optional<double> room_beside(double half_width, double reference_se, double reach) {
    const double uncertain = reach * reference_se;
    if (uncertain >= half_width) return std::nullopt;
    return std::sqrt(half_width * half_width - uncertain * uncertain);
}

/// Number of trials relative to Student's t for an interval that allows for skewness, which normal values do not have.
double price_of_caution(const Levels& levels, std::size_t comparisons, std::uint64_t trials) {
    const auto n = static_cast<double>(std::max(trials, fewest_trials));
    const double t = stats::student_critical(n - 1, levels.pass_alpha);
    const double z = stats::normal_critical(levels.pass_alpha);
    const gate::MeanSkewness skewness{.error =
                                          *stats::skewness_standard_error(static_cast<std::size_t>(n)) / std::sqrt(n)};
    const double longer = gate::skewed_reach(skewness, 1, t, z) - t;
    return std::pow(1 + longer / reach_to_pass(levels, comparisons), 2);
}

}  // namespace

bool can_decide_mean(double half_width, double sigma, double reference_se, const Levels& levels,
                     std::size_t comparisons) {
    FF_EXPECT(half_width > 0 && sigma >= 0);
    const auto room = room_beside(half_width, reference_se, reach_to_pass(levels, comparisons));
    return room && reach_to_pass(levels, comparisons) * sigma <= *room * std::sqrt(most_trials);
}

std::optional<std::uint64_t> trials_for_mean(double half_width, double sigma, double skewness, double reference_se,
                                             const Levels& levels, std::size_t comparisons) {
    if (!can_decide_mean(half_width, sigma, reference_se, levels, comparisons)) return std::nullopt;
    const double room = room_beside(half_width, reference_se, reach_to_pass(levels, comparisons)).value();
    const double z = stats::normal_critical(levels.fail_alpha / 2);
    const double straight = std::pow(z * z * z * skewness / (3 * std::log(2.0)), 2);
    const auto enough = whole(straight);
    if (!enough || sigma == 0) return enough;
    const auto trials = static_cast<std::uint64_t>(
        stats::trials_for_equivalence(room, sigma, {levels.pass_alpha, levels.power}, comparisons));
    return whole(static_cast<double>(std::max(*enough, trials)) * price_of_caution(levels, comparisons, trials));
}

std::optional<std::uint64_t> runs_for_mean(double half_width, double error, double reference_se, const Levels& levels,
                                           std::size_t comparisons) {
    if (!can_decide_mean(half_width, error, reference_se, levels, comparisons)) return std::nullopt;
    const double reach = reach_to_pass(levels, comparisons);
    const double runs = std::pow(reach * error / room_beside(half_width, reference_se, reach).value(), 2);
    return std::max(std::uint64_t{1}, static_cast<std::uint64_t>(std::ceil(runs)));
}

std::optional<std::uint64_t> trials_for_ratio(const Band& band, double excess_kurtosis, double reference_freedom,
                                              const Levels& levels, std::size_t comparisons) {
    FF_EXPECT(band.low < 1 && band.high > 1);
    const double half_width = std::min(-std::log(band.low), std::log(band.high));
    const double z = reach_to_pass(levels, comparisons);
    // ln of a standard deviation has the variance 1 / (2 freedom); chi-squared is skewed, which costs half a z^2 more.
    const double freedom = z * z / 2 / (half_width * half_width - z * z / (2 * reference_freedom)) + z * z / 2;
    if (half_width * half_width <= z * z / (2 * reference_freedom)) return std::nullopt;
    return whole(freedom * (1 + std::max(0.0, excess_kurtosis) / 2) + 1);
}

std::optional<std::uint64_t> trials_for_proportion(const Band& band, double probability, const Levels& levels,
                                                   std::size_t comparisons) {
    const double below = probability - band.low;
    const double above = band.high < 1 ? band.high - probability : below;
    if (!(below > 0 && above > 0)) return std::nullopt;
    // Wide enough at the end of the band as well as at the truth; Clopper-Pearson adds a count.
    const auto needed = [&](double room, double end) {
        const auto deviation = [](double p) { return std::sqrt(p * (1 - p)); };
        const double width = stats::normal_critical(levels.pass_alpha) * deviation(end) +
                             stats::normal_critical(miss(levels, comparisons)) * deviation(probability);
        return width * width / (room * room) + 2 / room;
    };
    const double upper = band.high < 1 ? needed(above, band.high) : 0;
    return whole(std::max(needed(below, std::max(0.0, band.low)), upper));
}

std::optional<std::uint64_t> trials_for_slope(const Band& band, std::span<const double> sizes, double kurtosis_factor,
                                              const Levels& levels, std::size_t comparisons) {
    FF_EXPECT(band.low < band.high && sizes.size() >= 2);
    double mean = 0;
    for (const double size : sizes) mean += std::log(size) / static_cast<double>(sizes.size());
    double spread = 0;
    for (const double size : sizes) spread += std::pow(std::log(size) - mean, 2);
    const double error = (band.high - band.low) / 2 / reach_to_pass(levels, comparisons);
    // Var(slope) = Var(ln RMSE) / spread, Var(ln RMSE) about factor / (2 T).
    return whole(kurtosis_factor / (2 * spread * error * error));
}

double rays_for_loss(double rate, const Levels& levels) {
    FF_EXPECT(0 < rate && rate < 1);
    return std::ceil(std::log1p(-levels.power) / std::log1p(-rate));
}

}  // namespace ff::studies::gates
