// Every printed figure of the paper is altered in turn, and the audit must notice.

#include "studies/audit/audit.hpp"
#include "studies/audit/scene_facts.hpp"
#include "tests/support/repetitions.hpp"
#include "tests/unit/studies/audit/simulated_tables.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <map>
#include <random>
#include <set>
#include <string>
#include <vector>

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

/// Every digit by every other one on request, otherwise one digit of each figure (another position for each) by one.
std::vector<std::string> alterations_of(const std::string& right, std::size_t figure, std::mt19937_64& random) {
    if (!test::is_nightly()) {
        std::size_t position = figure % right.size();
        if (right[position] == '.') ++position;
        return {test::with_other_digit(right, position, random)};
    }
    std::vector<std::string> all;
    for (std::size_t position = 0; position < right.size(); ++position) {
        if (right[position] == '.') continue;
        for (char digit = '0'; digit <= '9'; ++digit) {
            if (digit == right[position]) continue;
            all.push_back(right);
            all.back()[position] = digit;
        }
    }
    return all;
}

/// Alters every figure and counts what the audit notices.
std::map<std::string, NoticedShare> alter_every_figure(const PublishedTables& tables) {
    DistributionCache cache;
    const std::set<std::string> known = statements(examine(tables, {}, cache));
    std::mt19937_64 random(20261120);
    std::map<std::string, NoticedShare> shares;
    for (std::size_t f = 0; f < tables.figures.size(); ++f) {
        for (const std::string& wrong : alterations_of(tables.figures[f].printed, f, random)) {
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
    }
    return shares;
}

// Over all 6417 alterations of the nightly test 95.7 % are found and 87.9 % blamed; of the worst kinds, 88.5 % of
// deterministic row sums are found and 78.2 % of sampled ones blamed. Not to be found in principle: a figure altered to
// what is right (0.78 to 0.79, 0.86 to 0.87), and last digits of row sums that the rounding of their terms explains or
// where every print is a whole number of hits and the sum of relative errors, printed to 0.01 %, cannot tell. The test
// of every push alters one digit a figure, so the required shares are about 3 standard errors below what was measured.
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
    EXPECT_GE(total.found, 0.89 * total.altered);
    EXPECT_GE(total.blamed, 0.78 * total.altered);
}

}  // namespace
}  // namespace ff::studies::audit
