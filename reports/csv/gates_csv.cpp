#include "reports/csv/gates_csv.hpp"

#include "reports/csv/csv_field.hpp"
#include "reports/text/numbers.hpp"

#include <fmt/format.h>

#include <string>
#include <vector>

namespace ff::reports {
namespace {

template <class Number>
std::string whole(const std::optional<Number>& number) {
    return number ? std::to_string(*number) : std::string();
}

std::string row(const studies::GateResult& result, const studies::Comparison& c) {
    const auto& measurement = c.measurement;
    const auto of_measurement = [&](auto value) { return measurement ? exact(value(*measurement)) : std::string(); };
    const std::vector<std::string> fields{
        csv_field(result.gate),
        csv_field(c.scene),
        csv_field(c.method),
        whole(c.patches_per_face),
        whole(c.samples_per_patch),
        csv_field(c.from_face),
        csv_field(c.to_face),
        csv_field(c.quantity),
        of_measurement([](const studies::Measurement& e) { return e.value; }),
        of_measurement([](const studies::Measurement& e) { return e.passing.low; }),
        of_measurement([](const studies::Measurement& e) { return e.passing.high; }),
        exact(c.band.low),
        exact(c.band.high),
        std::string(name(c.verdict)),
        of_measurement([](const studies::Measurement& e) { return e.minimum_detectable; }),
        exact(c.levels.fail_alpha),
        exact(c.levels.power)};
    return fmt::format("{}\n", fmt::join(fields, ","));
}

}  // namespace

void write_verdicts_csv(std::ostream& out, const studies::CheckResults& check) {
    out << "gate,scene,method,patches_per_face,samples_per_patch,from_face,to_face,quantity,value,ci_low,ci_high,"
           "band_low,band_high,verdict,minimum_detectable,alpha,power\n";
    for (const studies::GateResult& result : check.results) {
        for (const studies::Comparison& comparison : result.comparisons) out << row(result, comparison);
    }
}

void write_seed_sweep_csv(std::ostream& out, const studies::GatesSpec& spec,
                          std::span<const studies::SeedSweep> sweeps) {
    out << "gate,seeds,fails,fail_rate,fail_ci_low,fail_ci_high,alpha,inconclusive,inconclusive_rate,"
           "inconclusive_ci_low,inconclusive_ci_high,inconclusive_allowed\n";
    for (const studies::SeedSweep& sweep : sweeps) {
        const auto failed = failure_rate(sweep, spec);
        const auto undecided = inconclusive_rate(sweep, spec);
        out << fmt::format("{},{},{},{},{},{},{},{},{},{},{},{}\n", csv_field(sweep.gate), sweep.seeds, sweep.fails,
                           exact(failed.rate), exact(failed.interval.low), exact(failed.interval.high),
                           exact(failed.allowed), sweep.inconclusive, exact(undecided.rate),
                           exact(undecided.interval.low), exact(undecided.interval.high), exact(undecided.allowed));
    }
}

}  // namespace ff::reports
