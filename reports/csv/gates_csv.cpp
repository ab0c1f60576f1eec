#include "reports/csv/gates_csv.hpp"

#include "reports/csv/csv_records.hpp"
#include "reports/json/gates_json.hpp"
#include "reports/text/json_values.hpp"
#include "reports/text/numbers.hpp"

#include <fmt/format.h>

namespace ff::reports {

void write_verdicts_csv(std::ostream& out, const studies::gates::CheckResults& check) {
    CsvRecords csv(out,
                   "gate,scene,method,patches_per_face,samples_per_patch,from_face,to_face,quantity,value,"
                   "ci_low=passing_interval/low,ci_high=passing_interval/high,band_low=band/low,band_high=band/high,"
                   "verdict,minimum_detectable,alpha,power");
    for (const studies::gates::GateResult& result : check.results) {
        for (const studies::gates::Comparison& comparison : result.comparisons) {
            Json record = comparison_json(comparison);
            record["gate"] = result.gate;
            csv.add(record);
        }
    }
}

void write_seed_sweep_csv(std::ostream& out, const studies::gates::Spec& spec,
                          std::span<const studies::gates::SeedSweep> sweeps) {
    out << "gate,seeds,fails,fail_rate,fail_ci_low,fail_ci_high,alpha,inconclusive,inconclusive_rate,"
           "inconclusive_ci_low,inconclusive_ci_high,inconclusive_allowed\n";
    for (const studies::gates::SeedSweep& sweep : sweeps) {
        const auto failed = failure_rate(sweep, spec);
        const auto undecided = inconclusive_rate(sweep, spec);
        out << fmt::format("{},{},{},{},{},{},{},{},{},{},{},{}\n", csv_field(sweep.gate), sweep.seeds, sweep.fails,
                           exact(failed.rate), exact(failed.interval.low), exact(failed.interval.high),
                           exact(failed.allowed), sweep.inconclusive, exact(undecided.rate),
                           exact(undecided.interval.low), exact(undecided.interval.high), exact(undecided.allowed));
    }
}

}  // namespace ff::reports
