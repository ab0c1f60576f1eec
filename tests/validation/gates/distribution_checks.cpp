#include "tests/validation/gates/distribution_checks.hpp"

#include "studies/verdicts/reported/distribution_gates.hpp"
#include "studies/verdicts/reported/reported_gates.hpp"
#include "tests/validation/rates/bench.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>

namespace ff::studies::gates {
namespace {

constexpr double band_of_counts = 0.1;

using Shares = std::vector<double>;

Shares even_shares() {
    constexpr std::size_t cells = 20;
    Shares shares(cells, 1.0 / cells);
    return shares;
}

/// The same with one cell that contains a few of a thousand events.
Shares shares_with_a_rare_cell() {
    Shares shares = even_shares();
    constexpr double rare = 0.005;
    for (double& share : shares) share *= (1 - rare) / (1 - shares.back());
    shares.back() = rare;
    return shares;
}

/// Every other cell has more by this share, the others less, so that the distance is equal to this share.
Shares tilted(Shares shares, double by) {
    for (std::size_t i = 0; i < shares.size(); ++i) shares[i] *= i % 2 == 0 ? 1 + by : 1 - by;
    return shares;
}

double distance_between(const Shares& a, const Shares& b) {
    double divergence = 0;
    for (std::size_t i = 0; i < a.size(); ++i) divergence += 2 * a[i] * std::log(a[i] / b[i]);
    return std::sqrt(divergence);
}

/// The last cell has more, until the distance is as given.
Shares grown(const Shares& shares, double distance) {
    double low = 1;
    double high = 50;
    Shares result;
    for (int i = 0; i < 60; ++i) {
        const double factor = (low + high) / 2;
        result = shares;
        result.back() *= factor;
        for (std::size_t k = 0; k + 1 < shares.size(); ++k) result[k] *= (1 - result.back()) / (1 - shares.back());
        (distance_between(result, shares) < distance ? low : high) = factor;
    }
    return result;
}

ReportedFile histogram(Holds holds, const Shares& values) {
    ReportedFile file;
    file.origin = "file.csv";
    file.holds = holds;
    file.quantities = {"x"};
    file.has_bins = true;
    file.rows.resize(1);
    for (std::size_t i = 0; i < values.size(); ++i) {
        file.names.push_back(fmt::format("{}", i));
        ReportedRow row;
        row.mean = values[i];
        row.name = static_cast<std::uint32_t>(i);
        file.rows[0].push_back(row);
    }
    return file;
}

ReportedFile draw_counts(const Shares& shares, std::size_t n, stats::Draws& draws) {
    Shares sums(shares.size());
    std::partial_sum(shares.begin(), shares.end(), sums.begin());
    Shares counts(shares.size());
    for (std::size_t i = 0; i < n; ++i) {
        const auto found = std::upper_bound(sums.begin(), sums.end() - 1, draws.uniform());
        ++counts[static_cast<std::size_t>(found - sums.begin())];
    }
    return histogram(Holds::counts, counts);
}

Comparison judge_histogram(const ReportedFile& file, const ReportedFile& against, double width) {
    Spec spec;
    spec.alpha = usual_alpha;
    Gate gate;
    gate.name = gate.quantity = "x";
    gate.kind = GateKind::distribution;
    gate.against = Against::file;
    gate.band = {0, width};
    spec.gates = {gate};
    return judge_reported(spec, gate, file, &against).comparisons.front();
}

RateTable measure_counts(const Repetitions& repetitions, std::uint64_t times) {
    RateTable table{
        .title = "Distributions of counts",
        .text =
            "Gates of kind `distribution` on 5000 counts in 20 cells, alike or with one cell of 0.5 %, α = 0.01: "
            "without a difference and a band far narrower than the noise; at the end of a band of 0.1, by a small "
            "difference in all cells or a large one in the rare cell; with few events; power; and how often the 90 % "
            "interval contains the distance.",
        .rates = {}};
    const Bench bench{repetitions, times, table};
    constexpr std::size_t n = 5000;
    const auto compare = [](const Shares& from, const Shares& shares, double width, stats::Draws& draws) {
        return judge_histogram(draw_counts(from, n, draws), histogram(Holds::shares, shares), width);
    };
    const Shares even = even_shares();
    const Shares rare = shares_with_a_rare_cell();
    const auto verdict_rate = [&](const std::string& what, Verdict verdict, RateClaim claim, double claimed,
                                  const Shares& from, const Shares& shares, double width) {
        bench.add(what, claim, claimed,
                  [=](stats::Draws& draws) { return compare(from, shares, width, draws).verdict == verdict; });
    };
    verdict_rate("fails: no difference", Verdict::fail, RateClaim::at_most, usual_alpha, even, even, narrow_band);
    verdict_rate("fails: no difference, a rare cell", Verdict::fail, RateClaim::at_most, usual_alpha, rare, rare,
                 narrow_band);
    verdict_rate("passes: no difference in a band of 0.1", Verdict::pass, RateClaim::at_least, 0.9, even, even,
                 band_of_counts);
    const Shares small = tilted(even, band_of_counts);
    const Shares spike = grown(rare, band_of_counts);
    for (const auto& [what, from, shares] : {std::tuple("all cells at the end of the band", small, even),
                                             std::tuple("the rare cell at the end of the band", spike, rare)}) {
        const double distance = distance_between(from, shares);
        verdict_rate(fmt::format("fails: {}", what), Verdict::fail, RateClaim::at_most, usual_alpha, from, shares,
                     distance);
        verdict_rate(fmt::format("passes: {}", what), Verdict::pass, RateClaim::at_most, 0.05, from, shares, distance);
        bench.add(fmt::format("interval holds the distance: {}", what), RateClaim::at_least, 0.9,
                  [=, from = from, shares = shares](stats::Draws& draws) {
                      return compare(from, shares, band_of_counts, draws).measurement->passing.contains(distance);
                  });
    }
    verdict_rate("fails: a distance of 0.25 in a band of 0.1", Verdict::fail, RateClaim::at_least, 0.9,
                 tilted(even, 0.25), even, band_of_counts);
    bench.add("passes: 24 events in two cells, at the end of a band of 0.05", RateClaim::at_most, 0.05,
              [](stats::Draws& draws) {
                  const Shares halves{0.5, 0.5};
                  const Shares from = tilted(halves, 0.05);
                  const auto row = judge_histogram(draw_counts(from, 24, draws), histogram(Holds::shares, halves),
                                                   distance_between(from, halves));
                  return row.verdict == Verdict::pass;
              });
    const auto of_two = [](double tilt, double width, stats::Draws& draws) {
        const auto first = draw_counts(tilted(even_shares(), tilt / 2), n, draws);
        return judge_histogram(first, draw_counts(tilted(even_shares(), -tilt / 2), n, draws), width).verdict;
    };
    bench.add("fails: two files, no difference", RateClaim::at_most, usual_alpha,
              [=](stats::Draws& draws) { return of_two(0, narrow_band, draws) == Verdict::fail; });
    bench.add("fails: two files at the end of the band", RateClaim::at_most, usual_alpha,
              [=](stats::Draws& draws) { return of_two(band_of_counts, band_of_counts, draws) == Verdict::fail; });
    bench.add("passes: two files at the end of the band", RateClaim::at_most, 0.05,
              [=](stats::Draws& draws) { return of_two(band_of_counts, band_of_counts, draws) == Verdict::pass; });
    bench.add("fails: two files, 0.3 in a band of 0.1", RateClaim::at_least, 0.9,
              [=](stats::Draws& draws) { return of_two(0.3, band_of_counts, draws) == Verdict::fail; });
    return table;
}

/// Uniform numbers; a share of them is 0 instead, so that no distribution is further than that from the uniform one.
std::vector<double> draw_contaminated(std::size_t n, double share, stats::Draws& draws) {
    std::vector<double> values(n);
    for (double& value : values) value = draws.uniform() < share ? 1e-9 * draws.uniform() : draws.uniform();
    return values;
}

RateTable measure_values(const Repetitions& repetitions, std::uint64_t times) {
    RateTable table{
        .title = "Distributions of values",
        .text =
            "Uniform numbers against the uniform distribution, and two files of them, α = 0.01. At the end of a band "
            "of 0.05, that share of the numbers is almost 0, the worst case for the tail. Intervals have level 90 %.",
        .rates = {}};
    const Bench bench{repetitions, times, table};
    constexpr double width = 0.05;
    const auto one = [](std::size_t n, double share, double tolerance, stats::Draws& draws) {
        const Levels levels{.fail_alpha = usual_alpha, .pass_alpha = 0.05, .power = 0.9};
        const auto measured = measure_distribution(draw_contaminated(n, share, draws), KnownLaw{}, levels);
        return std::pair(judge(measured, {0, tolerance}), measured);
    };
    const auto two = [](std::size_t n, std::size_t m, double share, double tolerance, stats::Draws& draws) {
        const Levels levels{.fail_alpha = usual_alpha, .pass_alpha = 0.05, .power = 0.9};
        const auto first = draw_contaminated(n, share, draws);
        const auto measured = measure_distributions(first, draw_contaminated(m, 0, draws), levels);
        return std::pair(judge(measured, {0, tolerance}), measured);
    };
    for (const std::size_t n : {20u, 200u}) {
        bench.add(fmt::format("fails: no difference, n = {}", n), RateClaim::at_most, usual_alpha,
                  [=](stats::Draws& draws) { return one(n, 0, narrow_band, draws).first == Verdict::fail; });
        bench.add(fmt::format("fails: at the end of the band, n = {}", n), RateClaim::at_most, usual_alpha,
                  [=](stats::Draws& draws) { return one(n, width, width, draws).first == Verdict::fail; });
    }
    bench.add("passes: at the end of the band, n = 2000", RateClaim::at_most, 0.05,
              [=](stats::Draws& draws) { return one(2000, width, width, draws).first == Verdict::pass; });
    bench.add("passes: no difference, n = 4000", RateClaim::at_least, 0.9,
              [=](stats::Draws& draws) { return one(4000, 0, width, draws).first == Verdict::pass; });
    bench.add("fails: a share of 0.25, n = 200", RateClaim::at_least, 0.9,
              [=](stats::Draws& draws) { return one(200, 0.25, width, draws).first == Verdict::fail; });
    bench.add("interval holds the distance of 0.05, n = 200", RateClaim::at_least, 0.9,
              [=](stats::Draws& draws) { return one(200, width, width, draws).second.passing.contains(width); });
    for (const auto& [n, m] : {std::pair<std::size_t, std::size_t>{20, 20}, {200, 200}, {50, 2000}}) {
        const std::string sizes = fmt::format("{} and {}", n, m);
        bench.add(
            "fails: two files, no difference, " + sizes, RateClaim::at_most, usual_alpha,
            [=, n = n, m = m](stats::Draws& draws) { return two(n, m, 0, narrow_band, draws).first == Verdict::fail; });
        bench.add(
            "fails: two files at the end of the band, " + sizes, RateClaim::at_most, usual_alpha,
            [=, n = n, m = m](stats::Draws& draws) { return two(n, m, width, width, draws).first == Verdict::fail; });
    }
    bench.add("fails: two files, a share of 0.35, 200 and 200", RateClaim::at_least, 0.9,
              [=](stats::Draws& draws) { return two(200, 200, 0.35, width, draws).first == Verdict::fail; });
    bench.add("interval holds the distance of two files, 0.05, 200 and 200", RateClaim::at_least, 0.9,
              [=](stats::Draws& draws) { return two(200, 200, width, width, draws).second.passing.contains(width); });
    return table;
}

}  // namespace

std::vector<RateTable> measure_distribution_checks(const Repetitions& repetitions, std::uint64_t times) {
    const std::uint64_t fewer = std::max<std::uint64_t>(20, times / 10);
    return {measure_counts(repetitions, fewer), measure_values(repetitions, fewer)};
}

}  // namespace ff::studies::gates
