#include "studies/run/pace.hpp"

#include "tests/support/studies.hpp"

#include <gtest/gtest.h>

namespace ff::studies {
namespace {

/// Two methods with units of their own.
class Paces : public testing::Test {
  protected:
    static std::string method(const char* name) {
        return std::string("[[method]]\nname = \"") + name +
               "\"\nsampler = \"random\"\nestimator = \"ray_shooting\"\nsamples_per_patch = 4000000\n";
    }
    [[nodiscard]] const WorkUnit& unit_of(std::size_t method, std::size_t index) const {
        for (const WorkUnit& unit : plan.units) {
            if (plan.cells[unit.cell].method == method && index-- == 0) return unit;
        }
        throw std::out_of_range("no such unit");
    }
    [[nodiscard]] double price(std::size_t method, std::size_t index) const {
        const WorkUnit& unit = unit_of(method, index);
        return static_cast<double>(unit.trials) * expected_seconds_per_trial(plan, plan.cells[unit.cell]);
    }

    const StudyPlan plan = test::plan_of(test::study_text("trials = 4", method("a") + method("b")));
    Pace pace{plan};
};

TEST_F(Paces, TakesThePlansPricesWhereNothingWasMeasured) {
    pace.count(unit_of(0, 0), true, true);
    pace.count(unit_of(0, 1), false, false);
    pace.finish(unit_of(0, 1), 0);
    const Pace::Seconds seconds = pace.seconds();
    EXPECT_DOUBLE_EQ(seconds.all, price(0, 0) + price(0, 1));
    EXPECT_DOUBLE_EQ(seconds.done, seconds.all);
    EXPECT_DOUBLE_EQ(seconds.before, price(0, 0));
}

TEST_F(Paces, CorrectsPricesByWhatTrialsOfEachMethodTook) {
    for (std::size_t method = 0; method < 2; ++method) {
        for (std::size_t i = 0; i < 2; ++i) pace.count(unit_of(method, i), false, false);
    }
    const double a = price(0, 0) + price(0, 1);
    const double b = price(1, 0) + price(1, 1);
    pace.finish(unit_of(0, 0), 10 * price(0, 0));
    EXPECT_DOUBLE_EQ(pace.seconds().all, 10 * (a + b));  // b may be off as a is
    EXPECT_DOUBLE_EQ(pace.seconds().done, 10 * price(0, 0));
    pace.finish(unit_of(1, 0), price(1, 0) / 2);
    EXPECT_DOUBLE_EQ(pace.seconds().all, 10 * a + b / 2);
    EXPECT_DOUBLE_EQ(pace.seconds().done, 10 * price(0, 0) + price(1, 0) / 2);
}

TEST_F(Paces, RemembersPricesInALaterRound) {
    pace.count(unit_of(0, 0), false, false);
    pace.finish(unit_of(0, 0), 10 * price(0, 0));
    pace.begin_round();
    pace.count(unit_of(0, 1), false, false);
    EXPECT_DOUBLE_EQ(pace.seconds().all, 10 * price(0, 1));
    EXPECT_EQ(pace.seconds().done, 0);
}

}  // namespace
}  // namespace ff::studies
