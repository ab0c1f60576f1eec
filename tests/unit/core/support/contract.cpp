#include "core/support/contract.hpp"

#include <gtest/gtest.h>

namespace {

TEST(ContractViolationDeathTest, NamesTheConditionAndThePlace) {
    EXPECT_DEATH(ff::contract_violation("expects", "n > 0", "moments.cpp", 7),
                 "moments.cpp:7: contract violation: expects n > 0");
}

#if FF_CONTRACTS

TEST(ContractDeathTest, StopsTheProgramWhereItIsBroken) {
    const int rays = 0;
    EXPECT_DEATH(FF_EXPECT(rays >= 1), "contract violation: expects rays >= 1");
    EXPECT_DEATH(FF_ENSURE(rays >= 1), "contract violation: ensures rays >= 1");
    FF_EXPECT(rays == 0);
    FF_ENSURE(rays == 0);
}

#else

TEST(Contract, IsNotEvenEvaluatedInARelease) {
    int evaluations = 0;
    FF_EXPECT(++evaluations < 0);
    FF_ENSURE(++evaluations < 0);
    EXPECT_EQ(evaluations, 0);
}

#endif

}  // namespace
