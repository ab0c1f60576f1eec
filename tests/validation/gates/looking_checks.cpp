#include "tests/validation/gates/looking_checks.hpp"

#include "stats/basics/moments.hpp"
#include "stats/means/mean_interval.hpp"
#include "studies/verdicts/ledger.hpp"
#include "studies/verdicts/reported/reported_gates.hpp"
#include "tests/validation/rates/bench.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <span>

namespace ff::studies::gates {
namespace {

/// How often a value is looked at, and on which data.
struct Looking {
    std::optional<Spending> spending;  ///< empty: each look has all of alpha
    std::size_t looks = 20;
    bool with_earlier_data = false;  ///< look k judges all data so far
};

ReportedFile one_value(double mean, double error) {
    ReportedFile file;
    file.origin = "file.csv";
    file.quantities = {"x"};
    file.names = {""};
    file.has_errors = true;
    ReportedRow row;
    row.mean = mean;
    row.standard_error = error;
    file.rows = {{row}};
    return file;
}

/// Looks at data until a verdict comes. Each look's data have an error of 1.
Verdict look_until_decided(const Looking& how, double bias, double band, stats::Draws& draws) {
    Spec spec;
    spec.alpha = usual_alpha;
    spec.looks = how.looks;
    spec.spending = how.spending.value_or(Spending::halving);
    Gate gate;
    gate.name = gate.quantity = "x";
    gate.against = Against::number;
    gate.reference = 0;
    gate.band = {-band, band};
    spec.gates = {gate};
    double sum = 0;
    for (std::size_t look = 1; look <= how.looks; ++look) {
        const double value = bias + draw_normal(draws);
        sum += value;
        const auto n = static_cast<double>(look);
        const auto file = how.with_earlier_data ? one_value(sum / n, 1 / std::sqrt(n)) : one_value(value, 1);
        const Spec share = how.spending ? at_look(spec, look) : spec;
        const Verdict verdict = judge_reported(share, gate, file, nullptr).verdict;
        if (verdict != Verdict::inconclusive) return verdict;
    }
    return Verdict::inconclusive;
}

RateTable measure_ledger(const Repetitions& repetitions, std::uint64_t times) {
    RateTable table{
        .title = "Looking again",
        .text =
            "One value, judged again until the gate passes or fails: reruns on new data with all of alpha each, and "
            "looks with `--again`, which share it by each spending rule, on new data or on all data so far. α = 0.01.",
        .rates = {}};
    const Bench bench{repetitions, times, table};
    struct Case {
        std::string what;
        Looking how;
    };
    const std::size_t planned = 5;
    for (const Case& c :
         {Case{"rerun until decided, 20 times", {}}, Case{"--again, halving, 20 looks", {Spending::halving, 20, false}},
          Case{"--again, halving, 20 looks, all data", {Spending::halving, 20, true}},
          Case{"--again, pocock, 5 looks", {Spending::pocock, planned, false}},
          Case{"--again, pocock, 5 looks, all data", {Spending::pocock, planned, true}},
          Case{"--again, obrien_fleming, 5 looks", {Spending::obrien_fleming, planned, false}},
          Case{"--again, obrien_fleming, 5 looks, all data", {Spending::obrien_fleming, planned, true}}}) {
        const RateClaim claim = c.how.spending ? RateClaim::at_most : RateClaim::none;
        bench.add(c.what + ": fails without bias, point null", claim, usual_alpha, [how = c.how](stats::Draws& draws) {
            return look_until_decided(how, 0, narrow_band, draws) == Verdict::fail;
        });
        bench.add(c.what + ": passes at the end of a band of 3", claim, 0.05,
                  [how = c.how](stats::Draws& draws) { return look_until_decided(how, 3, 3, draws) == Verdict::pass; });
        if (!c.how.with_earlier_data) continue;
        bench.add(c.what + ": fails with a bias of 4", RateClaim::at_least, 0.9, [how = c.how](stats::Draws& draws) {
            return look_until_decided(how, 4, narrow_band, draws) == Verdict::fail;
        });
    }
    return table;
}

/// Looks at a growing series after every tenth of up to 1000 values.
template <class Draw, class IntervalOf>
Verdict watch(double reference, double band, const Draw& draw, const IntervalOf& interval_of) {
    constexpr std::size_t most = 1000;
    constexpr std::size_t step = 10;
    std::vector<double> values;
    while (values.size() < most) {
        for (std::size_t i = 0; i < step; ++i) values.push_back(draw());
        const auto shifted = [&](double level) {
            auto interval = interval_of(std::span<const double>(values), level);
            interval.low -= reference;
            interval.high -= reference;
            return interval;
        };
        Measurement measurement;
        measurement.passing = shifted(0.9);
        measurement.failing = shifted(1 - usual_alpha);
        const Verdict verdict = judge(measurement, {-band, band});
        if (verdict != Verdict::inconclusive) return verdict;
    }
    return Verdict::inconclusive;
}

RateTable measure_sequences(const Repetitions& repetitions, std::uint64_t times) {
    RateTable table{.title = "At any time",
                    .text =
                        "A file of trials that grows to 1000 values and is looked at after every ten, until the gate "
                        "is decided: by Student's interval, and by the sequences of `anytime`. Normal values of "
                        "deviation 1, and values that are 1 in a tenth of all trials, else 0. α = 0.01.",
                    .rates = {}};
    const Bench bench{repetitions, times, table};
    const auto student = [](std::span<const double> values, double level) {
        return *stats::mean_interval_t(stats::moments_of(values, 0), level);
    };
    const auto normal = [](std::span<const double> values, double level) {
        return stats::normal_sequence(values, 100, level);
    };
    const auto bounded = [](std::span<const double> values, double level) {
        return stats::bounded_sequence(values, 0, 1, level);
    };
    const auto normal_case = [](const auto& interval, double bias, double band, stats::Draws& draws) {
        return watch(
            0, band, [&] { return bias + draw_normal(draws); }, interval);
    };
    const auto share_case = [=](double bias, double band, stats::Draws& draws) {
        constexpr double share = 0.1;
        return watch(
            share - bias, band, [&] { return draws.uniform() < share ? 1.0 : 0.0; }, bounded);
    };
    bench.add("Student at every look: fails without bias", RateClaim::none, 0,
              [=](stats::Draws& draws) { return normal_case(student, 0, narrow_band, draws) == Verdict::fail; });
    bench.add("normal: fails without bias", RateClaim::at_most, usual_alpha,
              [=](stats::Draws& draws) { return normal_case(normal, 0, narrow_band, draws) == Verdict::fail; });
    bench.add("normal: passes at the end of a band of 0.3", RateClaim::at_most, 0.05,
              [=](stats::Draws& draws) { return normal_case(normal, 0.3, 0.3, draws) == Verdict::pass; });
    bench.add("normal: fails with a bias of 0.3", RateClaim::at_least, 0.9,
              [=](stats::Draws& draws) { return normal_case(normal, 0.3, narrow_band, draws) == Verdict::fail; });
    bench.add("normal: passes without bias, a band of 0.3", RateClaim::at_least, 0.9,
              [=](stats::Draws& draws) { return normal_case(normal, 0, 0.3, draws) == Verdict::pass; });
    bench.add("bounded: fails without bias", RateClaim::at_most, usual_alpha,
              [=](stats::Draws& draws) { return share_case(0, narrow_band, draws) == Verdict::fail; });
    bench.add("bounded: passes at the end of a band of 0.06", RateClaim::at_most, 0.05,
              [=](stats::Draws& draws) { return share_case(0.06, 0.06, draws) == Verdict::pass; });
    bench.add("bounded: fails with a bias of 0.08", RateClaim::at_least, 0.9,
              [=](stats::Draws& draws) { return share_case(0.08, narrow_band, draws) == Verdict::fail; });
    return table;
}

}  // namespace

std::vector<RateTable> measure_looking_checks(const Repetitions& repetitions, std::uint64_t times) {
    const auto share = [times](std::uint64_t divisor) { return std::max<std::uint64_t>(20, times / divisor); };
    return {measure_ledger(repetitions, share(2)), measure_sequences(repetitions, share(10))};
}

}  // namespace ff::studies::gates
