// Every printed figure of the paper is altered in turn, and the audit must notice.

#include "studies/audit/audit.hpp"
#include "tests/unit/studies/audit/simulated_tables.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <map>
#include <random>
#include <set>
#include <string>

namespace ff::studies::audit {
namespace {

struct NoticedShare {
    int altered = 0;
    int found = 0;   ///< a new finding is about the figure
    int blamed = 0;  ///< and blames it before all others
};

std::string kind_of(const Figure& figure) {
    switch (figure.kind) {
        case FigureKind::form_factor:
            return figure.method + " form factor";
        case FigureKind::row_sum:
            return figure.method + " row sum";
        case FigureKind::relative_error:
            return figure.method + " relative error";
        case FigureKind::sum_relative_error:
            return figure.method + " sum of relative errors";
    }
    return {};
}

std::set<std::string> statements(const Report& report) {
    std::set<std::string> all;
    for (const Finding& finding : report.findings) all.insert(finding.id + finding.statement);
    return all;
}

bool contains(const std::vector<std::size_t>& figures, std::size_t figure) {
    return std::find(figures.begin(), figures.end(), figure) != figures.end();
}

/// Alters one digit of every figure (another position for each) and counts what the audit notices.
std::map<std::string, NoticedShare> alter_every_figure(const PublishedTables& tables) {
    DistributionCache cache;
    const std::set<std::string> known = statements(examine(tables, {}, cache));
    std::mt19937_64 random(20261120);
    std::map<std::string, NoticedShare> shares;
    for (std::size_t f = 0; f < tables.figures.size(); ++f) {
        const std::string& right = tables.figures[f].printed;
        std::size_t position = f % right.size();
        if (right[position] == '.') ++position;
        const std::string wrong = test::with_other_digit(right, position, random);
        const Report report = examine(test::with_print(tables, f, wrong), {}, cache);
        NoticedShare& share = shares[kind_of(tables.figures[f])];
        ++share.altered;
        bool found = false;
        bool blamed = false;
        for (const Finding& finding : report.findings) {
            if (known.count(finding.id + finding.statement) > 0) continue;
            found = found || contains(finding.involved, f);
            blamed = blamed || contains(finding.blamed, f);
        }
        share.found += found ? 1 : 0;
        share.blamed += blamed ? 1 : 0;
    }
    return shares;
}

// Measured over all 6417 alterations (every digit by every other one): 98.4 % found, 92.8 % blamed; the worst kind,
// sampled row sums, 95.9 % and 78.2 %. Not to be found in principle: a figure altered to what is right (0.78 to 0.79,
// 0.86 to 0.87), and last digits of row sums where every print is a whole number of hits and the sum of relative
// errors, printed to 0.01 %, cannot tell (the columns with 169 000 and 9 000 000 rays per face). The test alters one
// digit a figure, so the required shares leave room for the luck of the draw: about 3 standard errors below what was
// measured.
TEST(AuditOfThePaper, NoticesEveryKindOfAlteredDigit) {
    const PublishedTables tables = read_published_tables(test::paper_tables_file());
    NoticedShare total;
    for (const auto& [kind, share] : alter_every_figure(tables)) {
        std::printf("%-28s altered %3d  found %3d (%.1f %%)  blamed %3d (%.1f %%)\n", kind.c_str(), share.altered,
                    share.found, 100.0 * share.found / share.altered, share.blamed,
                    100.0 * share.blamed / share.altered);
        total.altered += share.altered;
        total.found += share.found;
        total.blamed += share.blamed;
        EXPECT_GE(share.found, 0.8 * share.altered) << kind;
    }
    EXPECT_GE(total.found, 0.95 * total.altered);
    EXPECT_GE(total.blamed, 0.86 * total.altered);
}

}  // namespace
}  // namespace ff::studies::audit
