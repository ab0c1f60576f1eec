#include "tests/validation/gates/selftest.hpp"

#include "stats/error_rates/multiplicity.hpp"
#include "tests/validation/gates/comparison_checks.hpp"
#include "tests/validation/gates/coverage.hpp"
#include "tests/validation/gates/distribution_checks.hpp"
#include "tests/validation/gates/estimate_checks.hpp"
#include "tests/validation/gates/looking_checks.hpp"
#include "tests/validation/gates/reported_checks.hpp"
#include "tests/validation/gates/study_checks.hpp"

#include <algorithm>

namespace ff::studies::gates {
namespace {

constexpr double family_alpha = 0.01;

}  // namespace

std::vector<RateTable> Selftest::tables() const {
    std::vector<RateTable> all{detection.caught, detection.sound, calibration.false_alarms, detection.edge,
                               calibration.power};
    all.insert(all.end(), estimates.begin(), estimates.end());
    all.push_back(coverage);
    return all;
}

std::size_t Selftest::contradictions() const {
    std::size_t count = 0;
    for (const RateTable& table : tables()) count += table.contradictions(level);
    const auto rejected = [&](const PValues& values) { return values.p < 1 - level; };
    return count +
           static_cast<std::size_t>(std::count_if(calibration.p_values.begin(), calibration.p_values.end(), rejected));
}

Selftest run_selftest(const Spec& controls, const SelftestOptions& options) {
    const Repetitions repetitions{options.seed, options.threads};
    Selftest selftest;
    selftest.options = options;
    selftest.detection = measure_detection(controls, repetitions, options.seeds);
    selftest.calibration = measure_calibration(repetitions, options.repetitions);
    selftest.estimates = measure_estimate_checks(repetitions, options.repetitions);
    for (const auto measure : {measure_study_checks, measure_comparison_checks, measure_reported_checks,
                               measure_looking_checks, measure_distribution_checks}) {
        const auto tables = measure(repetitions, options.repetitions);
        selftest.estimates.insert(selftest.estimates.end(), tables.begin(), tables.end());
    }
    selftest.coverage = measure_coverage(repetitions, options.repetitions);
    std::size_t claims = selftest.calibration.p_values.size();
    for (const RateTable& table : selftest.tables()) claims += table.claims();
    selftest.level = 1 - stats::bonferroni_level(family_alpha, claims);
    return selftest;
}

}  // namespace ff::studies::gates
