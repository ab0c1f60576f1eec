#include "studies/audit/audit.hpp"
#include "studies/audit/scene_facts.hpp"
#include "tests/unit/studies/audit/simulated_tables.hpp"

#include <gtest/gtest.h>

#include <random>

namespace ff::studies::audit {
namespace {

// The audit's family-wise alpha is 1e-4 a file, from its statistical tests; all other relations hold exactly. So 200
// correct files raise any alarm at all with probability 0.02. A checker that cries wolf in one file of 50 fails here
// with probability 0.98.
TEST(AuditOfConsistentTables, RaisesNoFalseAlarm) {
    DistributionCache cache;
    for (std::uint64_t seed = 0; seed < 200; ++seed) {
        const Report report = examine(test::simulate_tables(seed), {}, cache);
        EXPECT_EQ(report.contradictions(), 0u) << "seed " << seed << ": " << report.findings.front().statement;
    }
}

// Measured over seeds 1000 to 1199: 200 of 200 found, blamed and corrected to the original digits. With a true share of
// .99, fewer than 190 of 200 have a probability of 1e-4.
TEST(AuditOfConsistentTables, BlamesAPlantedMisprintAndRestoresIt) {
    DistributionCache cache;
    std::mt19937_64 random(1);
    int blamed = 0;
    int restored = 0;
    constexpr int files = 200;
    for (int k = 0; k < files; ++k) {
        const PublishedTables tables = test::simulate_tables(1000 + static_cast<std::uint64_t>(k));
        const std::size_t index = random() % tables.figures.size();
        const std::string& right = tables.figures[index].printed;
        std::size_t position = random() % right.size();
        if (right[position] == '.') position = 0;
        const std::string wrong = test::with_other_digit(right, position, random);
        const Report report = examine(test::with_print(tables, index, wrong), {}, cache);
        for (const Finding& finding : report.findings) {
            if (finding.blamed.empty() || finding.blamed.front() != index) continue;
            ++blamed;
            const double meant = parse_printed(finding.corrections.front().meant)->value();
            restored += meant == parse_printed(right)->value() ? 1 : 0;
        }
    }
    RecordProperty("blamed", blamed);
    RecordProperty("restored", restored);
    EXPECT_GE(blamed, 190);
    EXPECT_GE(restored, 190);
}

}  // namespace
}  // namespace ff::studies::audit
