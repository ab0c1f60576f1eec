#include "studies/verdicts/ledger.hpp"

#include "core/support/error.hpp"

#include <gmock/gmock.h>

namespace ff::studies::gates {
namespace {

using testing::HasSubstr;

TEST(Ledger, ReadsBackAsItWasWritten) {
    const Ledger ledger{{"abc", "1", "2", Verdict::fail}, {"def", "1", "3", Verdict::pass}};
    const Ledger read = parse_ledger(ledger_csv(ledger), "l.csv");
    ASSERT_EQ(read.size(), 2u);
    EXPECT_EQ(read[0].commit, "abc");
    EXPECT_EQ(read[0].verdict, Verdict::fail);
    EXPECT_EQ(read[1].data, "3");
}

TEST(Ledger, RefusesMalformedLines) {
    EXPECT_THAT([] { parse_ledger("commit,bands,data,verdict\na,b\n", "l.csv"); },
                testing::ThrowsMessage<UserError>(HasSubstr("l.csv:2:1: not a line of a ledger")));
    EXPECT_THAT([] { parse_ledger("commit,bands,data,verdict\na,b,c,green\n", "l.csv"); },
                testing::ThrowsMessage<UserError>(HasSubstr("not a verdict")));
}

// A change of the bands file, even of a comment, would otherwise begin alpha anew, and take a failure back.
TEST(NextLook, CountsAllLooksAtACommitWhateverTheirBands) {
    const Ledger ledger{
        {"abc", "9", "5", Verdict::inconclusive}, {"def", "9", "4", Verdict::fail}, {"abc", "1", "5", Verdict::pass}};
    const auto next = next_look(ledger, {"abc", "1", "6", Verdict::inconclusive});
    EXPECT_EQ(next.number, 3u);
    EXPECT_FALSE(next.failed || next.repeated || next.changed);
    EXPECT_TRUE(next_look(ledger, {"def", "1", "6", Verdict::inconclusive}).failed);
    const auto changed = next_look(ledger, {"abc", "2", "5", Verdict::inconclusive});
    EXPECT_EQ(changed.number, 3u);
    EXPECT_TRUE(changed.changed);
    EXPECT_FALSE(changed.repeated) << "other bands may say something else of the same data";
    const auto repeated = next_look(ledger, {"abc", "1", "5", Verdict::inconclusive});
    EXPECT_TRUE(repeated.repeated);
    EXPECT_EQ(repeated.earlier, Verdict::pass);
}

TEST(AtLook, SpendsNoMoreThanAllOfAlpha) {
    Spec spec;
    double alpha = 0;
    double pass_alpha = 0;
    for (std::size_t look = 1; look <= 20; ++look) {
        alpha += at_look(spec, look).alpha;
        pass_alpha += at_look(spec, look).pass_alpha;
    }
    EXPECT_LT(alpha, spec.alpha);
    EXPECT_LT(pass_alpha, spec.pass_alpha);
    EXPECT_GT(alpha, 0.999 * spec.alpha);
    EXPECT_THROW(static_cast<void>(at_look(spec, 60)), UserError);
}

// t = 1/4 and 1 of the spending functions; R: log(1 + (exp(1) - 1) / 4) is 0.3573740, and
// 2 * (1 - pnorm(qnorm(1 - 0.05 / 2) / sqrt(1 / 4))) / 0.05 is 0.0017715.
TEST(ShareOfLook, FollowsTheSpendingFunctions) {
    Spec spec;
    spec.alpha = 0.05;
    spec.looks = 4;
    spec.spending = Spending::pocock;
    EXPECT_NEAR(share_of_look(spec, 1), 0.3573740, 1e-6);
    spec.spending = Spending::obrien_fleming;
    EXPECT_NEAR(share_of_look(spec, 1), 0.0017715, 1e-6);
}

TEST(ShareOfLook, AddsUpToOneOverAllPlannedLooks) {
    for (const Spending spending : {Spending::pocock, Spending::obrien_fleming}) {
        for (const double alpha : {0.05, 1e-4, 1e-9}) {
            Spec spec;
            spec.alpha = alpha;
            spec.looks = 10;
            spec.spending = spending;
            double sum = 0;
            for (std::size_t look = 1; look <= 10; ++look) sum += at_look(spec, look).alpha;
            EXPECT_NEAR(sum / alpha, 1, 1e-9) << static_cast<int>(spending) << ' ' << alpha;
            EXPECT_THAT([&] { static_cast<void>(at_look(spec, 11)); },
                        testing::ThrowsMessage<UserError>(HasSubstr("look 11 of 10: all of alpha is spent")));
        }
    }
}

}  // namespace
}  // namespace ff::studies::gates
